/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Seen from a point of the zone, cos(theta) dA / r^2 of [BG91] eq. (4) is the patch's solid angle,
 * which has a closed form; only the attenuation is left to sample, and nothing is singular. The
 * zone is halved where the patch is close to it, the patch where it fills much of the view.
 */
#include "factor_patch.h"

#include <math.h>

typedef struct view {
    const murk_sight *sight;
    double lo[3], hi[3]; /* the zone */
    double kappa;
    double a[2], b[2]; /* the patch */
    double fine;       /* zone parts of this size are not halved any more */
} view;

/* Solid angle of [0, x] x [0, y] at height h below the eye, with the signs of x and y. */
static double corner_angle(double x, double y, double h)
{
    return atan(x * y / (h * sqrt(x * x + y * y + h * h)));
}

static double solid_angle(const double x[2], const double y[2], double h)
{
    return corner_angle(x[1], y[1], h) - corner_angle(x[0], y[1], h) - corner_angle(x[1], y[0], h) +
           corner_angle(x[0], y[0], h);
}

enum { PARTS = 4 };

/* Ends and middles of parts of [x0, x1] that look equally wide from a distance. */
static void cut(const double x[2], double distance, double end[PARTS + 1], double middle[PARTS])
{
    double first = atan(x[0] / distance), step = (atan(x[1] / distance) - first) / PARTS;
    for (int i = 0; i < PARTS; i++) {
        end[i] = i ? distance * tan(first + step * i) : x[0];
        middle[i] = distance * tan(first + step * (i + 0.5));
    }
    end[PARTS] = x[1];
}

static double nearest(const double x[2])
{
    return x[0] > 0 ? x[0] : x[1] < 0 ? -x[1] : 0;
}

/* Share of the zone's light that reaches the point (x, y) of the ground beside the eye at p. */
static double transmitted(const view *v, const double p[3], double x, double y, double h)
{
    const murk_sight *sight = v->sight;
    double r = sqrt(x * x + y * y + h * h), d[3], t[2];
    for (int a = 0; a < 3; a++)
        d[a] = (sight->a[a] * x + sight->b[a] * y - sight->up[a] * h) / r;
    if (!murk_box_chord(v->lo, v->hi, p, d, t))
        return 0;
    return murk_chord_escape(v->kappa * (t[1] - t[0])) *
           exp(-murk_sight_depth(sight, p, d, t[1], r));
}

/* A patch that fills much of the view, in parts by their solid angles. */
static double view_wide(const view *v, const double p[3], const double x[2], const double y[2],
                        double h)
{
    double near_x = nearest(x), near_y = nearest(y), sum = 0;
    double end_x[PARTS + 1], end_y[PARTS + 1], middle_x[PARTS], middle_y[PARTS];
    cut(x, sqrt(h * h + near_y * near_y), end_x, middle_x);
    cut(y, sqrt(h * h + near_x * near_x), end_y, middle_y);
    for (int i = 0; i < PARTS; i++)
        for (int j = 0; j < PARTS; j++)
            sum += solid_angle(end_x + i, end_y + j, h) *
                   transmitted(v, p, middle_x[i], middle_y[j], h);
    return sum;
}

/* A patch at some distance: Gauss points, two an axis, or its middle. */
static double view_narrow(const view *v, const double p[3], const double x[2], const double y[2],
                          double h, bool middle)
{
    double spread = middle ? 0 : 0.5 / sqrt(3), sum = 0, weights = 0;
    for (int i = 0; i < (middle ? 1 : 4); i++) {
        double at_x = (x[0] + x[1]) / 2 + (i & 1 ? spread : -spread) * (x[1] - x[0]);
        double at_y = (y[0] + y[1]) / 2 + (i & 2 ? spread : -spread) * (y[1] - y[0]);
        double weight = pow(at_x * at_x + at_y * at_y + h * h, -1.5); /* of cos(theta) / r^2 */
        sum += weight * transmitted(v, p, at_x, at_y, h);
        weights += weight;
    }
    return solid_angle(x, y, h) * sum / weights;
}

static double from_point(const view *v, const double p[3])
{
    double at[3];
    murk_sight_project(v->sight, p, at);
    double h = at[2];
    const double x[2] = {v->a[0] - at[0], v->a[1] - at[0]};
    const double y[2] = {v->b[0] - at[1], v->b[1] - at[1]};
    double near_x = nearest(x), near_y = nearest(y);
    double distance = sqrt(h * h + near_x * near_x + near_y * near_y);
    double wide = fmax(x[1] - x[0], y[1] - y[0]) / distance;
    return wide > 1 ? view_wide(v, p, x, y, h) : view_narrow(v, p, x, y, h, wide < 0.1);
}

static double from_part(const view *v, const double lo[3], const double hi[3])
{
    double middle[3], at[3], edge = 0;
    int longest = 0;
    for (int a = 0; a < 3; a++) {
        middle[a] = (lo[a] + hi[a]) / 2;
        if (hi[a] - lo[a] > edge) {
            edge = hi[a] - lo[a];
            longest = a;
        }
    }
    murk_sight_project(v->sight, middle, at);
    double gap[3] = {fmax(0, fmax(v->a[0] - at[0], at[0] - v->a[1])),
                     fmax(0, fmax(v->b[0] - at[1], at[1] - v->b[1])), at[2]};
    double distance = sqrt(gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2]);
    if (edge > 0.6 * distance && edge > v->fine) {
        double low_hi[3] = {hi[0], hi[1], hi[2]}, high_lo[3] = {lo[0], lo[1], lo[2]};
        low_hi[longest] = high_lo[longest] = middle[longest];
        return from_part(v, lo, low_hi) + from_part(v, high_lo, hi);
    }
    double volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
    if (edge < 0.2 * distance && v->kappa * edge < 0.1)
        return volume * from_point(v, middle);
    double sum = 0;
    for (int i = 0; i < 8; i++) { /* Gauss points, two an axis */
        double p[3];
        for (int a = 0; a < 3; a++)
            p[a] = middle[a] + (i >> a & 1 ? 0.5 : -0.5) * (hi[a] - lo[a]) / sqrt(3);
        sum += from_point(v, p);
    }
    return volume / 8 * sum;
}

double murk_patch_factor(const murk_sight *sight, const int32_t cell[3], double kappa, size_t patch)
{
    const murk_ground *ground = sight->ground;
    size_t ia = patch % (size_t)ground->count[0], ib = patch / (size_t)ground->count[0];
    view v = {.sight = sight,
              .kappa = kappa,
              .a = {ground->edge[0][ia], ground->edge[0][ia + 1]},
              .b = {ground->edge[1][ib], ground->edge[1][ib + 1]}};
    double least = fmin(v.a[1] - v.a[0], v.b[1] - v.b[0]);
    for (int a = 0; a < 3; a++) {
        v.lo[a] = cell[a] * sight->grid->voxel[a];
        v.hi[a] = (cell[a] + 1) * sight->grid->voxel[a];
        least = fmin(least, sight->grid->voxel[a]);
    }
    v.fine = 0.3 * least;
    return kappa / M_PI * from_part(&v, v.lo, v.hi);
}
