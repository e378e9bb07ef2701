/* SPDX-License-Identifier: Apache-2.0 */
/* A ray's walk through the voxels of the bricks it meets, empty space skipped brick by brick. */
#ifndef MURK_GRID_WALK_H
#define MURK_GRID_WALK_H

#include "grid.h"

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

/* The next voxel of any existing brick, active or not; false at the end. */
bool murk_walk_next(murk_walk *walk, murk_step *step);

/* Optical depth of eq. (6) between t_min and t_max along the ray: sum of kappa_t * (t1 - t0). */
double murk_walk_depth(const murk_grid *grid, const float *kappa_t, const double origin[3],
                       const double direction[3], double t_min, double t_max);

#endif
