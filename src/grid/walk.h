/* SPDX-License-Identifier: Apache-2.0 */
/* A ray's walk through the voxels of the bricks it meets, empty space skipped brick by brick. */
#ifndef MURK_GRID_WALK_H
#define MURK_GRID_WALK_H

#include "grid.h"

#include <math.h>

/* One step: the ray is in voxel `slot` of `brick` for t0 <= t < t1 (t in metres from the origin).
 */
typedef struct murk_step {
    int32_t brick;
    int slot; /* within the brick */
    double t0, t1;
} murk_step;

typedef struct murk_walk {
    const murk_grid *grid;
    double origin[3], direction[3]; /* grid frame in voxels (not metres), per metre of t */
    double inverse[3];
    int step[3];
    double t, t_end;  /* where the walk is and where it ends */
    int32_t cell[3];  /* voxel index, relative to grid->lo */
    double t_next[3]; /* t of the next voxel face on each axis */
    double t_delta[3];
    int32_t brick; /* the brick that cell lies in, or MURK_NO_BRICK */
} murk_walk;

/* Starts at origin (grid frame, m) along the unit vector direction, for t_min <= t <= t_max. */
void murk_walk_start(murk_walk *walk, const murk_grid *grid, const double origin[3],
                     const double direction[3], double t_min, double t_max);

/* What a step seldom comes to: the brick that the cell lies in, and the way from one that does not
   exist to the next on the ray. */
void murk_walk_find(murk_walk *walk);
void murk_walk_skip(murk_walk *walk);

/* t of the face of a cell where its number on the axis begins. */
static inline double murk_walk_face(const murk_walk *walk, int a, int32_t cell)
{
    return ((double)cell - walk->origin[a]) * walk->inverse[a];
}

/* The next voxel of any existing brick, active or not; false at the end. */
static inline bool murk_walk_next(murk_walk *walk, murk_step *step)
{
    const int32_t *lo = walk->grid->lo;
    while (walk->t < walk->t_end) {
        if (walk->brick == MURK_NO_BRICK) {
            murk_walk_skip(walk);
            continue;
        }
        int a = walk->t_next[0] < walk->t_next[1] ? 0 : 1;
        if (walk->t_next[2] < walk->t_next[a])
            a = 2;
        double t1 = fmin(walk->t_next[a], walk->t_end);
        const int32_t *cell = walk->cell;
        step->brick = walk->brick;
        step->slot =
            ((cell[0] + lo[0]) & 7) * 64 + ((cell[1] + lo[1]) & 7) * 8 + ((cell[2] + lo[2]) & 7);
        step->t0 = walk->t;
        step->t1 = t1;
        walk->cell[a] += walk->step[a];
        walk->t_next[a] = murk_walk_face(walk, a, walk->cell[a] + (walk->step[a] > 0));
        bool left = ((walk->cell[a] + lo[a]) & 7) == (walk->step[a] > 0 ? 0 : 7);
        if (left && t1 < walk->t_end)
            murk_walk_find(walk);
        bool passed = t1 > walk->t;
        walk->t = fmax(t1, walk->t);
        if (passed)
            return true;
    }
    return false;
}

/* Optical depth of eq. (6) between t_min and t_max along the ray: sum of kappa_t * (t1 - t0). */
double murk_walk_depth(const murk_grid *grid, const float *kappa_t, const double origin[3],
                       const double direction[3], double t_min, double t_max);

#endif
