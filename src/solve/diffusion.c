/* SPDX-License-Identifier: Apache-2.0 */
#include "diffusion.h"

#include <math.h>
#include <string.h>

enum { EDGE = MURK_BRICK_EDGE / 2, LINES = 64 }; /* lines of voxels through a brick */

murk_voxel_shape murk_voxel_shape_of(const murk_grid *grid)
{
    double unit = cbrt(grid->volume);
    murk_voxel_shape shape = {.weight = (float)(4 * unit)};
    for (int a = 0; a < 3; a++) {
        shape.edge[a] = (float)grid->voxel[a];
        shape.area[a] = (float)(unit / grid->voxel[a]);
    }
    return shape;
}

murk_layout murk_face_layout(int axis, int edge)
{
    size_t n = (size_t)edge, m = n + 1, axes = m * n * n;
    const murk_layout layouts[3] = {{0, n * n, n, 1}, {axes, n, m * n, 1}, {2 * axes, 1, m * n, m}};
    return layouts[axis];
}

murk_layout murk_cell_layout(int axis, int edge)
{
    size_t n = (size_t)edge;
    const murk_layout layouts[3] = {{0, n * n, n, 1}, {0, n, n * n, 1}, {0, 1, n * n, n}};
    return layouts[axis];
}

void murk_diffusion_clear(murk_diffusion *d)
{
    murk_free(d->brick);
    murk_free(d->neighbour);
    murk_free(d->face);
    murk_free(d->sink);
    memset(d, 0, sizeof *d);
}

/* ---- from voxels --------------------------------------------------------------------------- */

/* Sums the half resistances of the two voxels of cell p on each line along an axis. */
static void add_resistances(const float *kappa_t, int axis, float edge, int p, float *sum)
{
    murk_layout layout = murk_cell_layout(axis, MURK_BRICK_EDGE);
    for (int i = 2 * p; i < 2 * p + 2; i++)
        for (size_t l = 0; l < LINES; l++)
            sum[l] += murk_half_resistance(
                edge *
                kappa_t[(size_t)i * layout.along + (l >> 3) * layout.u + (l & 7) * layout.v]);
}

/* The faces of a brick across one axis: the four lines through each conduct side by side. */
static void set_faces(const murk_medium *medium, const murk_voxel_shape *shape,
                      const int32_t neighbour[6], size_t brick, int axis, float *face)
{
    float sum[EDGE + 2][LINES] = {{0}};
    for (int p = -1; p <= EDGE; p++) {
        int64_t at = p < 0       ? neighbour[2 * axis]
                     : p == EDGE ? neighbour[2 * axis + 1]
                                 : (int64_t)brick;
        if (at == MURK_NO_BRICK)
            for (int l = 0; l < LINES; l++)
                sum[p + 1][l] = MURK_VACUUM;
        else
            add_resistances(medium->kappa_t + (size_t)at * MURK_BRICK_SLOTS, axis,
                            shape->edge[axis], (p + EDGE) % EDGE, sum[p + 1]);
    }
    murk_layout layout = murk_face_layout(axis, EDGE);
    for (size_t p = 0; p <= EDGE; p++)
        for (size_t l = 0; l < LINES; l++)
            face[layout.first + p * layout.along + (l >> 4) * layout.u + (l >> 1 & 3) * layout.v] +=
                shape->area[axis] / (sum[p][l] + sum[p + 1][l]);
}

/* A cell stands for x that follow the light around each zone, x_i = x c / (c + sink_i) with c the
   conductance of the voxel: so much of its sink is left. Without that a black zone would hide the
   others of its cell. */
static void set_sinks(const murk_medium *medium, const murk_voxel_shape *shape, size_t brick,
                      float *sink)
{
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        size_t i = brick * MURK_BRICK_SLOTS + (size_t)slot;
        float kappa_t = medium->kappa_t[i], conductance = 0;
        for (int a = 0; a < 3; a++)
            conductance += shape->area[a] / murk_half_resistance(shape->edge[a] * kappa_t);
        float albedo = murk_value(&medium->albedo, i);
        float own = (1 - albedo) * murk_zone_weight(shape, kappa_t, albedo);
        sink[((slot >> 7) * EDGE + (slot >> 4 & 3)) * EDGE + (slot >> 1 & 3)] +=
            conductance * own / (conductance + own);
    }
}

murk_status murk_diffusion_create(murk_context *context, const murk_medium *medium,
                                  murk_diffusion *out)
{
    const murk_grid *grid = medium->grid;
    const murk_voxel_shape shape = murk_voxel_shape_of(grid);
    const size_t bricks = grid->brick_count, faces = murk_diffusion_faces(EDGE),
                 cells = murk_diffusion_cells(EDGE);
    murk_diffusion d = {.brick_count = bricks,
                        .edge = EDGE,
                        .brick = murk_alloc(bricks, sizeof *d.brick),
                        .neighbour = murk_alloc(bricks, sizeof *d.neighbour),
                        .face = murk_alloc(bricks * faces, sizeof(float)),
                        .sink = murk_alloc(bricks * cells, sizeof(float))};
    if (!d.brick || !d.neighbour || !d.face || !d.sink) {
        murk_diffusion_clear(&d);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                         grid->zone_count);
    }
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t b = 0; b < bricks; b++) {
        /* From the lowest brick: coarse cells do not depend on where the medium stands, and meet
           across the planes where an index is 0. */
        for (int a = 0; a < 3; a++)
            d.brick[b][a] = grid->brick[b][a] - (grid->lo[a] >> 3);
        for (int side = 0; side < 6; side++) {
            int32_t at[3] = {grid->brick[b][0], grid->brick[b][1], grid->brick[b][2]};
            at[side / 2] += side & 1 ? 1 : -1;
            d.neighbour[b][side] = murk_grid_find(grid, at[0], at[1], at[2]);
        }
        for (int a = 0; a < 3; a++)
            set_faces(medium, &shape, d.neighbour[b], b, a, d.face + b * faces);
        set_sinks(medium, &shape, b, d.sink + b * cells);
    }
    *out = d;
    return MURK_OK;
}

/* ---- the matrix ---------------------------------------------------------------------------- */

void murk_diffusion_invert_diagonal(const murk_diffusion *d, float *inverse)
{
    const size_t faces = murk_diffusion_faces(d->edge), cells = murk_diffusion_cells(d->edge);
    const size_t e = (size_t)d->edge;
    for (size_t b = 0; b < d->brick_count; b++)
        for (size_t c = 0; c < cells; c++) {
            const size_t at[3] = {c / e / e, c / e % e, c % e};
            float sum = d->sink[b * cells + c];
            for (int a = 0; a < 3; a++) {
                murk_layout layout = murk_face_layout(a, d->edge);
                const float *face = d->face + b * faces + layout.first + at[a] * layout.along +
                                    at[a ? 0 : 1] * layout.u + at[a == 2 ? 1 : 2] * layout.v;
                sum += face[0] + face[layout.along];
            }
            inverse[b * cells + c] = 1 / sum;
        }
}

/* Inlined with a constant e, so that its loops become straight vector code. */
static inline void residual(const murk_diffusion *d, size_t brick, const float *b, const float *x,
                            float *r, int e)
{
    enum { I = 36, J = 6 }; /* strides of a 4^3 brick with a layer around it */
    const int cells = e * e * e, layer = e * e;
    float padded[6 * I], *inner = padded + I + J + 1;
    const float *beside[6];
    static const float nothing[64];
    for (int s = 0; s < 6; s++) {
        int32_t n = d->neighbour[brick][s];
        beside[s] = n == MURK_NO_BRICK ? nothing : x + n * cells;
    }
    x += brick * (size_t)cells;
    b += brick * (size_t)cells;
    for (int i = 0; i < e; i++)
        for (int j = 0; j < e; j++) {
            for (int k = 0; k < e; k++)
                inner[i * I + j * J + k] = x[i * layer + j * e + k];
            inner[-I + i * J + j] = beside[0][(e - 1) * layer + i * e + j];
            inner[e * I + i * J + j] = beside[1][i * e + j];
            inner[i * I - J + j] = beside[2][i * layer + (e - 1) * e + j];
            inner[i * I + e * J + j] = beside[3][i * layer + j];
            inner[i * I + j * J - 1] = beside[4][i * layer + j * e + e - 1];
            inner[i * I + j * J + e] = beside[5][i * layer + j * e];
        }
    const float *face = d->face + brick * murk_diffusion_faces(e), *sink = d->sink + brick * cells;
    for (int i = 0; i < e; i++)
        for (int j = 0; j < e; j++) {
            const float *c = inner + i * I + j * J, *fx = face + i * layer + j * e,
                        *fy = face + ((e + 1) * layer + (i * (e + 1) + j) * e),
                        *fz = face + (2 * (e + 1) * layer + (i * e + j) * (e + 1));
            for (int k = 0; k < e; k++) {
                int at = i * layer + j * e + k;
                float lost = fx[k] * (c[k] - c[k - I]) + fx[k + layer] * (c[k] - c[k + I]) +
                             fy[k] * (c[k] - c[k - J]) + fy[k + e] * (c[k] - c[k + J]) +
                             fz[k] * (c[k] - c[k - 1]) + fz[k + 1] * (c[k] - c[k + 1]);
                r[at] = b[at] - sink[at] * c[k] - lost;
            }
        }
}

void murk_diffusion_residual(const murk_diffusion *d, size_t brick, const float *b, const float *x,
                             float *r)
{
    if (d->edge == 4)
        residual(d, brick, b, x, r, 4);
    else if (d->edge == 2)
        residual(d, brick, b, x, r, 2);
    else
        residual(d, brick, b, x, r, 1);
}
