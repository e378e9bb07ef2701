/* SPDX-License-Identifier: Apache-2.0 */
/* Digital differential analysis over two levels: bricks, and the voxels of those that exist. */
#include "walk.h"

#include <math.h>

void murk_walk_find(murk_walk *walk)
{
    const int32_t *lo = walk->grid->lo;
    walk->brick = murk_grid_find(walk->grid, (walk->cell[0] + lo[0]) >> 3,
                                 (walk->cell[1] + lo[1]) >> 3, (walk->cell[2] + lo[2]) >> 3);
}

/* Places the walk at t: the cell from the position, kept inside [low, high] against rounding. */
static void place(murk_walk *walk, const int32_t low[3], const int32_t high[3])
{
    for (int a = 0; a < 3; a++) {
        double x = floor(walk->origin[a] + walk->direction[a] * walk->t);
        walk->cell[a] = x < low[a] ? low[a] : x > high[a] ? high[a] : (int32_t)x;
    }
}

static void set_faces(murk_walk *walk)
{
    for (int a = 0; a < 3; a++)
        walk->t_next[a] =
            walk->step[a] ? murk_walk_face(walk, a, walk->cell[a] + (walk->step[a] > 0)) : INFINITY;
}

void murk_walk_start(murk_walk *walk, const murk_grid *grid, const double origin[3],
                     const double direction[3], double t_min, double t_max)
{
    walk->grid = grid;
    walk->t = t_min > 0 ? t_min : 0;
    walk->t_end = t_max;
    for (int a = 0; a < 3; a++) {
        double size = (double)grid->hi[a] - grid->lo[a];
        walk->origin[a] = origin[a] / grid->voxel[a];
        walk->direction[a] = direction[a] / grid->voxel[a];
        walk->inverse[a] = 1 / walk->direction[a];
        walk->step[a] = (walk->direction[a] > 0) - (walk->direction[a] < 0);
        walk->t_delta[a] = fabs(walk->inverse[a]);
        if (!walk->step[a]) {
            if (!(walk->origin[a] >= 0 && walk->origin[a] < size))
                walk->t_end = -1;
            continue;
        }
        double t0 = murk_walk_face(walk, a, walk->step[a] > 0 ? 0 : (int32_t)size);
        double t1 = murk_walk_face(walk, a, walk->step[a] > 0 ? (int32_t)size : 0);
        walk->t = fmax(walk->t, t0);
        walk->t_end = fmin(walk->t_end, t1);
    }
    if (!(walk->t < walk->t_end) || !grid->brick_count) {
        walk->t_end = -1;
        return;
    }
    const int32_t low[3] = {0, 0, 0};
    const int32_t high[3] = {grid->hi[0] - grid->lo[0] - 1, grid->hi[1] - grid->lo[1] - 1,
                             grid->hi[2] - grid->lo[2] - 1};
    place(walk, low, high);
    set_faces(walk);
    murk_walk_find(walk);
}

void murk_walk_skip(murk_walk *walk)
{
    const int32_t *lo = walk->grid->lo;
    int32_t low[3], high[3];
    int through = 0;
    double t = INFINITY;
    for (int a = 0; a < 3; a++) {
        low[a] = ((walk->cell[a] + lo[a]) & ~7) - lo[a];
        high[a] = low[a] + 7;
        double exit = walk->step[a]
                          ? murk_walk_face(walk, a, walk->step[a] > 0 ? low[a] + 8 : low[a])
                          : INFINITY;
        if (exit < t) {
            t = exit;
            through = a;
        }
    }
    walk->t = fmax(walk->t, t);
    place(walk, low, high);
    walk->cell[through] = walk->step[through] > 0 ? low[through] + 8 : low[through] - 1;
    set_faces(walk);
    murk_walk_find(walk);
}

double murk_walk_depth(const murk_grid *grid, const float *kappa_t, const double origin[3],
                       const double direction[3], double t_min, double t_max)
{
    murk_walk walk;
    murk_step step;
    double depth = 0;
    murk_walk_start(&walk, grid, origin, direction, t_min, t_max);
    while (murk_walk_next(&walk, &step)) {
        size_t slot = (size_t)step.brick * MURK_BRICK_SLOTS + (size_t)step.slot;
        depth += kappa_t[slot] * (step.t1 - step.t0);
    }
    return depth;
}
