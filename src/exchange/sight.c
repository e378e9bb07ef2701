/* SPDX-License-Identifier: Apache-2.0 */
#include "sight.h"

#include "walk.h"

#include <math.h>

void murk_sight_init(murk_sight *sight, const murk_medium *medium, const murk_ground *ground)
{
    const murk_grid *grid = medium->grid;
    *sight = (murk_sight){.grid = grid, .kappa_t = medium->kappa_t, .ground = ground};
    double cells = 1;
    for (int a = 0; a < 3; a++) {
        cells *= (double)grid->hi[a] - grid->lo[a];
        sight->box[a] = ((double)grid->hi[a] - grid->lo[a]) * grid->voxel[a];
    }
    double least = INFINITY;
    for (size_t i = 0; i < grid->brick_count * MURK_BRICK_SLOTS; i++)
        if (medium->kappa_t[i] > 0) {
            sight->kappa_max = fmax(sight->kappa_max, medium->kappa_t[i]);
            least = fmin(least, medium->kappa_t[i]);
        }
    if ((double)grid->zone_count == cells && least == sight->kappa_max)
        sight->kappa_uniform = least;
    if (!ground)
        return;
    const int axis[3] = {murk_ground_axis_a(ground), murk_ground_axis_b(ground),
                         murk_ground_axis_up(ground)};
    double *vector[3] = {sight->a, sight->b, sight->up};
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++)
            vector[c][a] = grid->axis[a][axis[c]];
        sight->origin[c] = grid->corner[axis[c]];
    }
    sight->origin[2] -= ground->height;
    sight->clearance = sight->origin[2];
    double height = 0;
    for (int a = 0; a < 3; a++) {
        sight->clearance += fmin(0, sight->up[a] * sight->box[a]);
        height += fabs(sight->up[a] * grid->voxel[a]);
    }
    if (fabs(sight->clearance) < 1e-5 * height) /* rounding of a ground that touches the zones */
        sight->clearance = 0;
}

double murk_sight_depth(const murk_sight *sight, const double origin[3], const double direction[3],
                        double t0, double t1)
{
    if (sight->kappa_uniform == 0)
        return murk_walk_depth(sight->grid, sight->kappa_t, origin, direction, t0, t1);
    const double low[3] = {0, 0, 0};
    double t[2];
    if (!murk_box_chord(low, sight->box, origin, direction, t))
        return 0;
    return sight->kappa_uniform * fmax(0, fmin(t1, t[1]) - fmax(t0, t[0]));
}

void murk_sight_project(const murk_sight *sight, const double point[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = sight->origin[c];
    for (int a = 0; a < 3; a++) {
        out[0] += sight->a[a] * point[a];
        out[1] += sight->b[a] * point[a];
        out[2] += sight->up[a] * point[a];
    }
}

bool murk_box_chord(const double lo[3], const double hi[3], const double origin[3],
                    const double direction[3], double t[2])
{
    t[0] = -INFINITY;
    t[1] = INFINITY;
    for (int a = 0; a < 3; a++) {
        if (direction[a] == 0) {
            if (origin[a] < lo[a] || origin[a] > hi[a])
                return false;
            continue;
        }
        double near = (lo[a] - origin[a]) / direction[a];
        double far = (hi[a] - origin[a]) / direction[a];
        t[0] = fmax(t[0], fmin(near, far));
        t[1] = fmin(t[1], fmax(near, far));
    }
    return t[0] < t[1];
}

double murk_chord_escape(double x)
{
    return x < 1e-5 ? 1 - x / 2 : -expm1(-x) / x;
}
