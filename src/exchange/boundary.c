/* SPDX-License-Identifier: Apache-2.0 */
#include "boundary.h"

#include <math.h>

/* A footprint has samples no further apart than half a patch, up to this many a side: more change
   nothing from 192 directions on (in the paper's box), one costs a third more error. */
enum { MOST_SAMPLES = 2, BEAM_SAMPLES = 4 };

/* The world displacement of one step of the line number along a grid axis, carried along the
   lines onto the ground plane. */
static void project(const murk_ground *ground, const double step[3], const double direction[3],
                    double out[2])
{
    int up = murk_ground_axis_up(ground);
    double t = step[up] / direction[up];
    out[0] = step[murk_ground_axis_a(ground)] - direction[murk_ground_axis_a(ground)] * t;
    out[1] = step[murk_ground_axis_b(ground)] - direction[murk_ground_axis_b(ground)] * t;
}

void murk_boundary_lay(murk_boundary *boundary, const murk_grid *grid, const murk_ground *ground,
                       const murk_lattice *lattice, bool beam)
{
    *boundary = (murk_boundary){.ground = ground, .samples = {1, 1}, .span = lattice->span};
    if (!ground)
        return;
    int up = murk_ground_axis_up(ground), a = murk_ground_axis_a(ground),
        b = murk_ground_axis_b(ground);
    double direction[3], frame[3], at[3], step[2][3];
    murk_grid_direction_to_world(grid, lattice->direction, direction);
    if (fabs(direction[up]) < 1e-9)
        return;
    boundary->heading = direction[up] < 0 ? -1 : 1;
    const int axes[2] = {lattice->u, lattice->v};
    frame[lattice->axis] = lattice->middle * grid->voxel[lattice->axis];
    for (int c = 0; c < 2; c++) {
        frame[axes[c]] = lattice->offset[c] * grid->voxel[axes[c]];
        for (int w = 0; w < 3; w++)
            step[c][w] = grid->axis[axes[c]][w] * grid->voxel[axes[c]];
    }
    murk_grid_to_world(grid, frame, at);
    double t = (ground->height - at[up]) / direction[up];
    boundary->hit[0] = at[a] + t * direction[a];
    boundary->hit[1] = at[b] + t * direction[b];
    project(ground, step[0], direction, boundary->per_u);
    project(ground, step[1], direction, boundary->per_v);

    const double *edge_a = ground->edge[0] + ground->margin,
                 *edge_b = ground->edge[1] + ground->margin;
    double patch = fmin(edge_a[1] - edge_a[0], edge_b[1] - edge_b[0]);
    const double *span[2] = {boundary->per_u, boundary->per_v};
    for (int c = 0; c < 2; c++) {
        double samples = ceil(2 * lattice->span * hypot(span[c][0], span[c][1]) / patch);
        boundary->samples[c] = beam ? BEAM_SAMPLES : (int)fmin(fmax(samples, 1), MOST_SAMPLES);
    }
}

/* Calls for every sample of line (u, v) with its patch. */
#define FOR_SAMPLES(boundary, u, v, patch)                                                         \
    for (int su_ = 0; su_ < (boundary)->samples[0]; su_++)                                         \
        for (int sv_ = 0, once_ = 1; sv_ < (boundary)->samples[1]; sv_++, once_ = 1)               \
            for (int64_t patch = sample_patch(boundary, u, v, su_, sv_); once_; once_ = 0)

static int64_t sample_patch(const murk_boundary *boundary, double u, double v, int su, int sv)
{
    u += ((su + 0.5) / boundary->samples[0] - 0.5) * boundary->span;
    v += ((sv + 0.5) / boundary->samples[1] - 0.5) * boundary->span;
    return murk_ground_patch(boundary->ground,
                             boundary->hit[0] + u * boundary->per_u[0] + v * boundary->per_v[0],
                             boundary->hit[1] + u * boundary->per_u[1] + v * boundary->per_v[1]);
}

static double bring(const murk_boundary *boundary, const murk_incoming *incoming, double u,
                    double v)
{
    if (incoming->uniform || boundary->heading <= 0)
        return incoming->sky;
    double sum = 0;
    FOR_SAMPLES(boundary, u, v, patch)
    {
        if (patch >= 0)
            sum += incoming->patch ? incoming->patch[patch] : 0;
        else if (patch == MURK_GROUND_HORIZON)
            sum += incoming->horizon;
    }
    return sum / (boundary->samples[0] * boundary->samples[1]);
}

double murk_boundary_enter(const murk_boundary *boundary, const murk_incoming *incoming, int32_t u,
                           int32_t v, int n, float *state, ptrdiff_t stride)
{
    bool varies = !incoming->uniform && boundary->heading > 0;
    bool dark = varies && !incoming->patch && incoming->horizon == 0;
    float same = dark ? 0 : (float)incoming->sky;
    double sum = 0;
    for (int row = 0; row < n; row++, state += stride)
        for (int i = 0; i < n; i++) {
            state[i] = varies && !dark ? (float)bring(boundary, incoming, u + i, v + row) : same;
            sum += state[i];
        }
    return sum;
}

double murk_boundary_leave(const murk_boundary *boundary, const murk_incoming *incoming, int32_t u,
                           int32_t v, int n, const float *state, ptrdiff_t stride,
                           double power_per_line, double *patch_power)
{
    bool lands = boundary->heading < 0 && patch_power;
    double share = power_per_line / (boundary->samples[0] * boundary->samples[1]), sum = 0;
    for (int row = 0; row < n; row++, state += stride)
        for (int i = 0; i < n; i++) {
            double change = state[i] - (float)incoming->sky;
            sum += state[i];
            if (!lands || change == 0)
                continue;
            FOR_SAMPLES(boundary, u + i, v + row, patch)
            {
                if (patch >= 0)
                    patch_power[patch] += share * change;
            }
        }
    return sum;
}
