/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Both factors depend on the separation s of two points alone, so the six- or five-fold integral
 * is one over s with a weight: how often s occurs, a product of piecewise linear functions of the
 * components. Each piece is a cell of s space; by symmetry it lies at s >= 0. The singularity
 * 1/r^2 is met by cells with a corner at s = 0 only: those are cut into three pyramids with the
 * apex there, where the volume element cancels it and the integral over r is elementary.
 */
#include "factor_offset.h"

#include <math.h>
#include <stdbool.h>

#define FAR_AWAY 40.0 /* optical distance at which a factor is nothing */

/* Gauss-Legendre nodes and weights on [0, 1]. */
typedef struct rule {
    int count;
    double node[8], weight[8];
} rule;

static const rule rules[] = {
    {2, {0.21132486540518712, 0.78867513459481288}, {0.5, 0.5}},
    {3,
     {0.11270166537925831, 0.5, 0.88729833462074169},
     {0.27777777777777778, 0.44444444444444444, 0.27777777777777778}},
    {4,
     {0.069431844202973712, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629},
     {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}},
    {6,
     {0.033765242898423987, 0.16939530676686775, 0.38069040695840156, 0.61930959304159844,
      0.83060469323313225, 0.96623475710157601},
     {0.085662246189585173, 0.18038078652406930, 0.23395696728634552, 0.23395696728634552,
      0.18038078652406930, 0.085662246189585173}},
    {8,
     {0.019855071751231884, 0.10166676129318664, 0.23723379504183550, 0.40828267875217510,
      0.59171732124782490, 0.76276620495816450, 0.89833323870681336, 0.98014492824876812},
     {0.050614268145188130, 0.11119051722668724, 0.15685332293894364, 0.18134189168918099,
      0.18134189168918099, 0.15685332293894364, 0.11119051722668724, 0.050614268145188130}},
};

typedef struct kernel {
    double kappa, gap;
    bool patch; /* cos(theta) / r^2 rather than 1 / r^2 */
} kernel;

/* A cell of separations and its weight, the product of c[a][0] + c[a][1] * s[a]. */
typedef struct cell {
    double lo[3], hi[3], c[3][2];
} cell;

static double kernel_value(const kernel *k, const double s[3])
{
    double r2 = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
    double r = sqrt(r2);
    if (!k->patch)
        return exp(-k->kappa * r) / r2;
    return exp(-k->kappa * r * (1 - k->gap / s[2])) * s[2] / (r2 * r);
}

/* The shortest path in the medium between any two points that a cell stands for. */
static double depth_least(const kernel *k, const cell *c)
{
    double r = sqrt(c->lo[0] * c->lo[0] + c->lo[1] * c->lo[1] + c->lo[2] * c->lo[2]);
    return k->kappa * (r - (k->gap > 0 ? r * k->gap / c->lo[2] : 0));
}

static double integrate_product(const kernel *k, const cell *c, const rule *q)
{
    double s[3], sum = 0, length[3];
    for (int a = 0; a < 3; a++)
        length[a] = c->hi[a] - c->lo[a];
    for (int i = 0; i < q->count; i++) {
        s[0] = c->lo[0] + length[0] * q->node[i];
        double wx = q->weight[i] * (c->c[0][0] + c->c[0][1] * s[0]);
        for (int j = 0; j < q->count; j++) {
            s[1] = c->lo[1] + length[1] * q->node[j];
            double wy = wx * q->weight[j] * (c->c[1][0] + c->c[1][1] * s[1]);
            for (int l = 0; l < q->count; l++) {
                s[2] = c->lo[2] + length[2] * q->node[l];
                sum += wy * q->weight[l] * (c->c[2][0] + c->c[2][1] * s[2]) * kernel_value(k, s);
            }
        }
    }
    return sum * length[0] * length[1] * length[2];
}

/* A cell away from s = 0: as many nodes as its size against the distance and the mean free path
   calls for, halves where it is too large. */
static double integrate_away(const kernel *k, const cell *c)
{
    if (depth_least(k, c) > FAR_AWAY)
        return 0;
    double r = sqrt(c->lo[0] * c->lo[0] + c->lo[1] * c->lo[1] + c->lo[2] * c->lo[2]);
    double near = 0, thick = 0, worst = -1;
    int split = 0;
    for (int a = 0; a < 3; a++) {
        double length = c->hi[a] - c->lo[a];
        double depth = k->kappa * length;
        if (a == 2 && k->gap > 0) /* grazing lines enter the medium far out: steep in height */
            depth += depth * k->gap * (r + c->hi[0] + c->hi[1]) / (c->lo[2] * c->lo[2]);
        double measure = fmax(length / r, depth / 3);
        if (measure > worst) {
            worst = measure;
            split = a;
        }
        near = fmax(near, length / r);
        thick = fmax(thick, depth);
    }
    if (near < 1. / 16 && thick < 0.15)
        return integrate_product(k, c, &rules[0]);
    if (near < 1. / 4 && thick < 0.7)
        return integrate_product(k, c, &rules[1]);
    if (near < 1. / 2 && thick < 1.5)
        return integrate_product(k, c, &rules[2]);
    if (near < 1.01 && thick < 3)
        return integrate_product(k, c, &rules[3]);
    cell low = *c, high = *c;
    low.hi[split] = high.lo[split] = (c->lo[split] + c->hi[split]) / 2;
    return integrate_away(k, &low) + integrate_away(k, &high);
}

/* e[n] = integral of t^n exp(-b t) over [0, 1]. */
static void exponential_moments(double b, double e[4])
{
    double end = exp(-b);
    if (b > 2) {
        e[0] = (1 - end) / b;
        for (int n = 1; n < 4; n++)
            e[n] = (n * e[n - 1] - end) / b;
        return;
    }
    double term = 0.25, sum = 0; /* the recurrence upwards would cancel */
    for (int n = 4; term > 1e-17; n++) {
        sum += term;
        term *= b / (n + 1);
    }
    e[3] = end * sum;
    for (int n = 3; n > 0; n--)
        e[n - 1] = (b * e[n] + end) / n;
}

/* One line from s = 0 to the point x of the pyramid's base. */
static double integrate_radial(const kernel *k, const cell *c, const double x[3])
{
    double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    double r = sqrt(r2);
    double e[4], p[4] = {1, 0, 0, 0}; /* the weight as a polynomial along the line */
    for (int a = 0; a < 3; a++) {
        double slope = c->c[a][1] * x[a];
        for (int n = a + 1; n > 0; n--)
            p[n] = p[n] * c->c[a][0] + p[n - 1] * slope;
        p[0] *= c->c[a][0];
    }
    exponential_moments(k->kappa * r, e);
    double sum = p[0] * e[0] + p[1] * e[1] + p[2] * e[2] + p[3] * e[3];
    return k->patch ? sum * x[2] / (r2 * r) : sum / r2;
}

/* Ends of panels of [0, 1] that grow away from 0 like the distance to the apex does. */
static int panel_ends(double height, double width, double end[64])
{
    int count = 1;
    end[0] = 0;
    double next = height / width;
    while (next < 0.7 && count < 62) {
        end[count++] = next;
        next *= 3;
    }
    end[count] = 1;
    return count;
}

/* A cell with a corner at s = 0, where gap is 0. */
static double integrate_corner(const kernel *k, const cell *c)
{
    const rule *q = &rules[4];
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        int b = (axis + 1) % 3, d = (axis + 2) % 3;
        double end_b[64], end_d[64], x[3];
        int count_b = panel_ends(c->hi[axis], c->hi[b], end_b);
        int count_d = panel_ends(c->hi[axis], c->hi[d], end_d);
        x[axis] = c->hi[axis];
        for (int i = 0; i < count_b * q->count; i++) {
            int panel = i / q->count, node = i % q->count;
            double wide = end_b[panel + 1] - end_b[panel];
            double weight = wide * q->weight[node];
            x[b] = c->hi[b] * (end_b[panel] + wide * q->node[node]);
            for (int j = 0; j < count_d * q->count; j++) {
                panel = j / q->count;
                node = j % q->count;
                wide = end_d[panel + 1] - end_d[panel];
                x[d] = c->hi[d] * (end_d[panel] + wide * q->node[node]);
                sum += weight * wide * q->weight[node] * integrate_radial(k, c, x);
            }
        }
    }
    return sum * c->hi[0] * c->hi[1] * c->hi[2];
}

/* The linear pieces of max(0, size - |s - offset * size|) at s >= 0; those at s < 0 are the same
   again for offset 0, hence the 2. */
static int hat_pieces(double size, int offset, double lo[2], double hi[2], double c[2][2])
{
    if (offset < 0)
        offset = -offset;
    double middle = offset * size;
    lo[0] = middle;
    hi[0] = middle + size;
    c[0][0] = middle + size;
    c[0][1] = -1;
    if (offset == 0) {
        c[0][0] *= 2;
        c[0][1] *= 2;
        return 1;
    }
    lo[1] = (offset - 1) * size;
    hi[1] = middle;
    c[1][0] = -lo[1];
    c[1][1] = 1;
    return 2;
}

static double integrate(const kernel *k, const int count[3], double (*lo)[2], double (*hi)[2],
                        double (*c)[2][2])
{
    double sum = 0;
    for (int i = 0; i < count[0] * count[1] * count[2]; i++) {
        int part[3] = {i % count[0], i / count[0] % count[1], i / (count[0] * count[1])};
        cell one;
        bool corner = k->gap == 0;
        for (int a = 0; a < 3; a++) {
            one.lo[a] = lo[a][part[a]];
            one.hi[a] = hi[a][part[a]];
            one.c[a][0] = c[a][part[a]][0];
            one.c[a][1] = c[a][part[a]][1];
            corner = corner && one.lo[a] == 0;
        }
        sum += corner ? integrate_corner(k, &one) : integrate_away(k, &one);
    }
    return sum / M_PI;
}

double murk_factor_offset_zone(const double size[3], const int offset[3], double kappa)
{
    kernel k = {.kappa = kappa, .gap = 0, .patch = false};
    double lo[3][2], hi[3][2], c[3][2][2];
    int count[3];
    for (int a = 0; a < 3; a++)
        count[a] = hat_pieces(size[a], offset[a], lo[a], hi[a], c[a]);
    return integrate(&k, count, lo, hi, c);
}

double murk_factor_offset_patch(const double size[3], const int offset[3], double gap, double kappa)
{
    kernel k = {.kappa = kappa, .gap = gap, .patch = true};
    double lo[3][2], hi[3][2], c[3][2][2];
    int count[3] = {0, 0, 1};
    for (int a = 0; a < 2; a++)
        count[a] = hat_pieces(size[a], offset[a], lo[a], hi[a], c[a]);
    lo[2][0] = gap + offset[2] * size[2];
    hi[2][0] = lo[2][0] + size[2];
    c[2][0][0] = 1;
    c[2][0][1] = 0;
    return integrate(&k, count, lo, hi, c);
}
