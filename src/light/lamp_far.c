/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A zone of power p = kappa V B makes G/4 = p tau / (4 pi r^2). What a line from centre to centre
 * does not tell is how tau / r^2 varies over the two voxels. Each of them counts as a box of its
 * neighbour's extinction, which the line passes, and of what it has above that, which is a box in
 * empty space: the mean of either has a closed form for parallel lines. What is left is of second
 * order in voxel over distance.
 */
#include "lamp_far.h"

#include "box_escape.h"
#include "walk.h"

#include <math.h>

/* A voxel whose optical depth differs from its neighbour's by less is like it. */
static const double ALIKE = 1e-3;
/* A voxel may be this much thinner than its neighbour, in optical depths, to be a hole in it. */
static const double LESS = 0.5;
/* Beyond so many optical depths it is dark. */
static const double DARK = 30;

/* One end of a line: the voxel there and its neighbour on the line [1/m]; the line's length in it.
 */
typedef struct line_end {
    double kappa, neighbour, length;
} line_end;

typedef struct line {
    double depth; /* from centre to centre */
    line_end lamp, receiver;
} line;

static double unit(const double way[3], double direction[3])
{
    double r = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    for (int a = 0; a < 3; a++)
        direction[a] = way[a] / r;
    return r;
}

static line walk_line(const murk_sight *sight, const double from[3], const double direction[3],
                      double r)
{
    line met = {0};
    murk_walk walk;
    murk_step step;
    double last = 0, end = 0, sliver = 1e-9 * r; /* where a line runs along an edge */
    murk_walk_start(&walk, sight->grid, from, direction, 0, r);
    for (int n = 0; met.depth < DARK && murk_walk_next(&walk, &step);) {
        double kappa = sight->kappa_t[(size_t)step.brick * MURK_BRICK_SLOTS + (size_t)step.slot];
        if (step.t1 - step.t0 < sliver)
            continue;
        bool touches = step.t0 <= end + sliver; /* no gap of empty bricks */
        if (n == 0)
            met.lamp = (line_end){.kappa = kappa, .length = step.t1};
        if (n == 1 && touches)
            met.lamp.neighbour = kappa;
        met.receiver = (line_end){kappa, touches ? last : 0, step.t1 - step.t0};
        met.depth += kappa * (step.t1 - step.t0);
        last = kappa;
        end = step.t1;
        n++;
    }
    return met;
}

/* The mean over the voxel at one end in place of the way through it: of its box, and with `mean` of
   that of its neighbour's extinction too. Adds to how much nearer the light is than the middle. */
static double end_factor(const double size[3], const double direction[3], double r,
                         const line_end *end, bool mean, double *depth, double *nearer)
{
    double edge = fmax(size[0], fmax(size[1], size[2]));
    double alike = fmin(end->neighbour, end->kappa + LESS / edge), above = end->kappa - alike;
    double factor = mean ? murk_box_mean(size, direction, alike) : 1;
    if (fabs(above) * edge < ALIKE)
        return factor;
    *depth -= above * end->length;
    *nearer += murk_box_shift(size, direction, above, r);
    return factor * murk_box_escape(size, direction, above);
}

/* By the second derivatives of exp(-kappa r) / r^2, but for those of exp(-kappa r) alone. */
static double spread_factor(const double spread[3], const double direction[3], double r,
                            double kappa)
{
    double sum = 0;
    for (int a = 0; a < 3; a++) {
        double d2 = direction[a] * direction[a];
        sum += spread[a] * ((4 * d2 - 1) / r + kappa * (5 * d2 - 1) / 2);
    }
    return 1 + sum / r;
}

/* tau / r^2 by the line from one centre to the other. */
static double by_centres(const murk_sight *sight, const murk_lamp_node *node,
                         const double offset[3], double kappa_t)
{
    const double *size = sight->grid->voxel;
    double direction[3], spread[3], r = unit(offset, direction);
    line met;
    if (sight->kappa_uniform > 0) {
        double kappa = sight->kappa_uniform;
        met.depth = murk_sight_depth(sight, node->centre, direction, 0, r);
        met.lamp = met.receiver = (line_end){.kappa = kappa, .neighbour = kappa};
    } else {
        met = walk_line(sight, node->centre, direction, r);
    }
    if (met.depth >= DARK)
        return 0;
    double depth = met.depth, factor = 1, nearer = 0, mean = met.depth / r;
    for (int a = 0; a < 3; a++) {
        spread[a] = node->spread[a] + size[a] * size[a] / 12;
        if (!node->lamp)
            factor += node->spread[a] * pow(mean * direction[a], 2) / 2;
    }
    if (node->lamp)
        factor = end_factor(size, direction, r, &met.lamp, true, &depth, &nearer);
    if (kappa_t > 0)
        factor *= end_factor(size, direction, r, &met.receiver, true, &depth, &nearer);
    factor *= spread_factor(spread, direction, r, depth > 0 ? depth / r : 0);
    return factor * exp(-depth) / ((r - nearer) * (r - nearer));
}

/* The same by eight lines between points whose first and second moments are those of lamp and
   receiver: columns of the Hadamard matrix of order 8. */
static double by_points(const murk_sight *sight, const murk_lamp_node *node, const double offset[3],
                        double kappa_t)
{
    const double *size = sight->grid->voxel;
    double sum = 0;
    for (int n = 0; n < 8; n++) {
        const int sign[3] = {n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1};
        double from[3], way[3], direction[3];
        for (int a = 0; a < 3; a++) {
            from[a] = node->centre[a] + sign[a] * sqrt(node->spread[a]);
            double to =
                node->centre[a] + offset[a] + sign[a] * sign[(a + 1) % 3] * size[a] / (2 * sqrt(3));
            way[a] = to - from[a];
        }
        double r = unit(way, direction), factor = 1, nearer = 0;
        line met = walk_line(sight, from, direction, r);
        if (met.depth >= DARK)
            continue;
        double depth = met.depth;
        if (node->lamp)
            factor = end_factor(size, direction, r, &met.lamp, false, &depth, &nearer);
        if (kappa_t > 0)
            factor *= end_factor(size, direction, r, &met.receiver, false, &depth, &nearer);
        sum += factor * exp(-depth) / ((r - nearer) * (r - nearer));
    }
    return sum / 8;
}

double murk_lamp_far(const murk_sight *sight, const murk_lamp_node *node, const double offset[3],
                     double kappa_t, bool rough)
{
    return node->power / (4 * M_PI) *
           (rough ? by_points : by_centres)(sight, node, offset, kappa_t);
}
