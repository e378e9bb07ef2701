/* SPDX-License-Identifier: Apache-2.0 */
/* Straight lines through a dense array of voxels (Amanatides, Woo 1987). */
#ifndef BENCH_MONTE_CARLO_LINE_H
#define BENCH_MONTE_CARLO_LINE_H

#include "monte_carlo.h"

/* A point on the way: the voxel, and the distance to it. */
struct bench_mc_line {
    int zone;       /* number of the voxel that comes next */
    double t;       /* where it begins */
    int left[3];    /* voxels to the end of the box, this one included */
    int stride[3];  /* from zone to zone */
    double wall[3]; /* where the line leaves the voxel on each axis */
    double step[3]; /* from wall to wall */
};

/* False where the line from its beginning on misses the box. */
bool bench_mc_line_begin(struct bench_mc_line *line, const struct bench_mc_scene *scene,
                         const double at[3], const double along[3]);

/* The next voxel and the length of the line in it; false at the end of the box. */
static inline bool bench_mc_line_next(struct bench_mc_line *line, int *zone, double *length)
{
    int a = line->wall[0] < line->wall[1] ? 0 : 1;
    a = line->wall[2] < line->wall[a] ? 2 : a;
    if (line->zone < 0)
        return false;
    *zone = line->zone;
    *length = line->wall[a] > line->t ? line->wall[a] - line->t : 0;
    line->t += *length;
    line->wall[a] += line->step[a];
    line->zone = --line->left[a] ? line->zone + line->stride[a] : -1;
    return true;
}

#endif
