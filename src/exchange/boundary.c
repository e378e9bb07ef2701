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
    for (int c = 0; c < 2; c++) {
        boundary->hit[c] =
            (boundary->hit[c] - ground->edge[c][ground->margin]) * ground->per_metre[c];
        boundary->per_u[c] *= ground->per_metre[c];
        boundary->per_v[c] *= ground->per_metre[c];
    }
}

/* What the ground under a tile is like. */
enum tile { ONE_PATCH, INTERIOR, ANYWHERE };

static const double ROUNDING = 1e-9; /* of positions, in patches */

/* Sets the patch for ONE_PATCH. A patch, the interior and the tile are convex: its corners tell. */
static enum tile classify(const murk_boundary *boundary, double u, double v, int64_t *patch)
{
    const murk_ground *ground = boundary->ground;
    double reach = boundary->span / 2;
    const double us[2] = {u - reach, u + MURK_TILE - 1 + reach};
    const double vs[2] = {v - reach, v + MURK_TILE - 1 + reach};
    bool interior = true, one = true;
    for (int corner = 0; corner < 4; corner++) {
        double t[2];
        int column[2];
        for (int c = 0; c < 2; c++) {
            t[c] = boundary->hit[c] + us[corner & 1] * boundary->per_u[c] +
                   vs[corner >> 1] * boundary->per_v[c];
            interior = interior && t[c] > ROUNDING && t[c] < ground->interior[c] - ROUNDING;
            column[c] = murk_ground_column(ground, c, t[c]);
        }
        int64_t here =
            column[0] < 0 || column[1] < 0 ? -1 : (int64_t)column[1] * ground->count[0] + column[0];
        if (!corner)
            *patch = here;
        one = one && here >= 0 && here == *patch;
    }
    return one ? ONE_PATCH : interior ? INTERIOR : ANYWHERE;
}

/* The patches that sample (su, sv) of each line of a tile falls on. */
static void find_patches(const murk_boundary *boundary, enum tile tile, double u, double v, int su,
                         int sv, int32_t patch[MURK_TILE_LINES])
{
    const murk_ground *ground = boundary->ground;
    int32_t beyond = ground->horizon ? MURK_GROUND_HORIZON : MURK_GROUND_NOTHING;
    double t[2];
    u += ((su + 0.5) / boundary->samples[0] - 0.5) * boundary->span;
    v += ((sv + 0.5) / boundary->samples[1] - 0.5) * boundary->span;
    for (int c = 0; c < 2; c++)
        t[c] = boundary->hit[c] + u * boundary->per_u[c] + v * boundary->per_v[c];
    for (int row = 0; row < MURK_TILE; row++)
        for (int i = 0; i < MURK_TILE; i++) {
            double a = t[0] + i * boundary->per_u[0] + row * boundary->per_v[0];
            double b = t[1] + i * boundary->per_u[1] + row * boundary->per_v[1];
            int32_t *out = &patch[row * MURK_TILE + i];
            if (tile == INTERIOR) {
                *out = ((int)b + ground->margin) * ground->count[0] + (int)a + ground->margin;
            } else {
                int column = murk_ground_column(ground, 0, a), r = murk_ground_column(ground, 1, b);
                *out = column < 0 || r < 0 ? beyond : r * ground->count[0] + column;
            }
        }
}

static float radiosity_of(const murk_incoming *incoming, int64_t patch)
{
    if (patch >= 0)
        return incoming->patch ? incoming->patch[patch] : 0;
    return patch == MURK_GROUND_HORIZON ? (float)incoming->horizon : 0;
}

static void fill(float *state, ptrdiff_t stride, float value, double *sum)
{
    for (int row = 0; row < MURK_TILE; row++, state += stride)
        for (int i = 0; i < MURK_TILE; i++)
            state[i] = value;
    *sum += (double)MURK_TILE_LINES * value;
}

/* The mean over the samples, which all lines of the tile have of their own. */
static void bring(const murk_boundary *boundary, enum tile tile, const murk_incoming *incoming,
                  int bands, double u, double v, float *state, ptrdiff_t stride, ptrdiff_t band,
                  double *sum)
{
    float brought[MURK_MOST_BANDS][MURK_TILE_LINES] = {{0}};
    int32_t patch[MURK_TILE_LINES];
    for (int su = 0; su < boundary->samples[0]; su++)
        for (int sv = 0; sv < boundary->samples[1]; sv++) {
            find_patches(boundary, tile, u, v, su, sv, patch);
            for (int b = 0; b < bands; b++)
                for (int i = 0; i < MURK_TILE_LINES; i++)
                    brought[b][i] += radiosity_of(&incoming[b], patch[i]);
        }
    float share = 1.f / (float)(boundary->samples[0] * boundary->samples[1]);
    for (int b = 0; b < bands; b++, state += band)
        for (int i = 0; i < MURK_TILE_LINES; i++) {
            float value = share * brought[b][i];
            state[i / MURK_TILE * stride + i % MURK_TILE] = value;
            sum[b] += value;
        }
}

void murk_boundary_enter(const murk_boundary *boundary, const murk_incoming *incoming, int bands,
                         int32_t u, int32_t v, float *state, ptrdiff_t stride, ptrdiff_t band,
                         double *sum)
{
    bool varies = false;
    int64_t patch = MURK_GROUND_HORIZON;
    if (!incoming->uniform && boundary->heading > 0) {
        for (int b = 0; b < bands; b++)
            varies = varies || incoming[b].patch || incoming[b].horizon != 0;
        enum tile tile = varies ? classify(boundary, u, v, &patch) : ONE_PATCH;
        if (tile != ONE_PATCH) {
            bring(boundary, tile, incoming, bands, u, v, state, stride, band, sum);
            return;
        }
        for (int b = 0; b < bands; b++)
            fill(state + b * band, stride, varies ? radiosity_of(&incoming[b], patch) : 0, &sum[b]);
        return;
    }
    for (int b = 0; b < bands; b++)
        fill(state + b * band, stride, (float)incoming[b].sky, &sum[b]);
}

/* What the lines of a tile have gained; returns whether any has. */
static bool find_gain(const murk_incoming *incoming, int bands, const float *state,
                      ptrdiff_t stride, ptrdiff_t band, float gain[][MURK_TILE_LINES], double *sum)
{
    bool any = false;
    for (int b = 0; b < bands; b++, state += band) {
        float sky = (float)incoming[b].sky;
        double total = 0;
        for (int i = 0; i < MURK_TILE_LINES; i++) {
            float value = state[i / MURK_TILE * stride + i % MURK_TILE];
            gain[b][i] = value - sky;
            total += value;
            any = any || value != sky;
        }
        sum[b] += total;
    }
    return any;
}

void murk_boundary_leave(const murk_boundary *boundary, const murk_incoming *incoming, int bands,
                         int32_t u, int32_t v, const float *state, ptrdiff_t stride, ptrdiff_t band,
                         double power_per_line, double *const *patch_power, double *sum)
{
    float gain[MURK_MOST_BANDS][MURK_TILE_LINES];
    bool any = find_gain(incoming, bands, state, stride, band, gain, sum);
    if (!any || !patch_power || boundary->heading >= 0)
        return;
    int64_t same;
    enum tile tile = classify(boundary, u, v, &same);
    if (tile == ONE_PATCH) {
        for (int b = 0; b < bands; b++) {
            double total = 0;
            for (int i = 0; i < MURK_TILE_LINES; i++)
                total += gain[b][i];
            patch_power[b][same] += power_per_line * total;
        }
        return;
    }
    double share = power_per_line / (boundary->samples[0] * boundary->samples[1]);
    int32_t patch[MURK_TILE_LINES];
    for (int su = 0; su < boundary->samples[0]; su++)
        for (int sv = 0; sv < boundary->samples[1]; sv++) {
            find_patches(boundary, tile, u, v, su, sv, patch);
            for (int b = 0; b < bands; b++)
                for (int i = 0; i < MURK_TILE_LINES; i++)
                    if (patch[i] >= 0)
                        patch_power[b][patch[i]] += share * gain[b][i];
        }
}
