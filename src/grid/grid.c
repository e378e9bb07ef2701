/* SPDX-License-Identifier: Apache-2.0 */
#include "grid.h"

#include <math.h>
#include <string.h>

/* ---- transform ---------------------------------------------------------------------------- */

/* Splits index_to_world into axes and voxel sizes; they must stand at right angles. */
static murk_status take_transform(murk_context *context, murk_grid *grid, const double m[16])
{
    for (int a = 0; a < 3; a++) {
        double length = hypot(hypot(m[a], m[4 + a]), m[8 + a]);
        if (!(length > 0) || !isfinite(length))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "the grid's transform is singular: voxels need a size on each axis");
        grid->voxel[a] = length;
        for (int c = 0; c < 3; c++)
            grid->axis[a][c] = m[4 * c + a] / length;
    }
    for (int a = 0; a < 3; a++) {
        const double *u = grid->axis[a], *v = grid->axis[(a + 1) % 3];
        if (fabs(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) > 1e-6)
            return murk_fail(context, MURK_ERROR_INPUT,
                             "the grid's transform is sheared: only scale, rotation and "
                             "translation are supported; resample the grid");
    }
    for (int c = 0; c < 3; c++)
        if (!isfinite(m[4 * c + 3]))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "the grid's transform has a translation that is not finite");
    grid->volume = grid->voxel[0] * grid->voxel[1] * grid->voxel[2];
    return MURK_OK;
}

/* ---- order and hash ------------------------------------------------------------------------ */

static size_t hash_brick(int32_t x, int32_t y, int32_t z)
{
    uint64_t h = (uint64_t)(uint32_t)x * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ (uint32_t)y) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 31) ^ (uint32_t)z) * 0x94D049BB133111EBu;
    return (size_t)(h ^ (h >> 30));
}

static bool fill_hash(murk_grid *grid)
{
    size_t buckets = 16;
    while (buckets < 2 * grid->brick_count)
        buckets *= 2;
    grid->bucket = murk_alloc(buckets, sizeof *grid->bucket);
    if (!grid->bucket)
        return false;
    grid->bucket_mask = buckets - 1;
    for (size_t i = 0; i < buckets; i++)
        grid->bucket[i] = MURK_NO_BRICK;
    for (size_t b = 0; b < grid->brick_count; b++) {
        const int32_t *c = grid->brick[b];
        size_t i = hash_brick(c[0], c[1], c[2]) & grid->bucket_mask;
        while (grid->bucket[i] != MURK_NO_BRICK)
            i = (i + 1) & grid->bucket_mask;
        grid->bucket[i] = (int32_t)b;
    }
    return true;
}

int32_t murk_grid_find(const murk_grid *grid, int32_t x, int32_t y, int32_t z)
{
    size_t i = hash_brick(x, y, z) & grid->bucket_mask;
    for (int32_t b; (b = grid->bucket[i]) != MURK_NO_BRICK; i = (i + 1) & grid->bucket_mask) {
        const int32_t *c = grid->brick[b];
        if (c[0] == x && c[1] == y && c[2] == z)
            return b;
    }
    return MURK_NO_BRICK;
}

/* ---- creation ------------------------------------------------------------------------------ */

static int brick_population(const uint64_t mask[8])
{
    int count = 0;
    for (int x = 0; x < 8; x++)
        count += __builtin_popcountll(mask[x]);
    return count;
}

static bool copy_bricks(murk_grid *grid, const murk_bricks *bricks)
{
    for (size_t i = 0; i < bricks->count; i++)
        grid->brick_count += brick_population(bricks->mask[i]) > 0;
    grid->brick = murk_alloc(grid->brick_count, sizeof *grid->brick);
    grid->mask = murk_alloc(grid->brick_count, sizeof *grid->mask);
    grid->zone_first = murk_alloc(grid->brick_count + 1, sizeof *grid->zone_first);
    if (!grid->brick || !grid->mask || !grid->zone_first)
        return false;
    size_t b = 0;
    for (size_t i = 0; i < bricks->count; i++) {
        int population = brick_population(bricks->mask[i]);
        if (!population)
            continue;
        memcpy(grid->brick[b], bricks->brick[i], sizeof *grid->brick);
        memcpy(grid->mask[b], bricks->mask[i], sizeof *grid->mask);
        grid->zone_first[b + 1] = grid->zone_first[b] + (size_t)population;
        b++;
    }
    grid->zone_count = grid->zone_first[b];
    return true;
}

/* The box of the active voxels, tight to the voxel. */
static void find_box(murk_grid *grid)
{
    for (int a = 0; a < 3 && grid->brick_count; a++) {
        grid->lo[a] = INT32_MAX;
        grid->hi[a] = INT32_MIN;
    }
    for (size_t b = 0; b < grid->brick_count; b++) {
        uint64_t all = 0;
        int first[3], last[3];
        uint8_t x_used = 0, y_used = 0, z_used = 0;
        for (int x = 0; x < 8; x++) {
            all |= grid->mask[b][x];
            if (grid->mask[b][x])
                x_used |= (uint8_t)(1u << x);
        }
        for (int y = 0; y < 8; y++) {
            uint8_t row = (uint8_t)(all >> 8 * y);
            z_used |= row;
            if (row)
                y_used |= (uint8_t)(1u << y);
        }
        const uint8_t used[3] = {x_used, y_used, z_used};
        for (int a = 0; a < 3; a++) {
            first[a] = __builtin_ctz(used[a]);
            last[a] = 31 - __builtin_clz(used[a]);
            int32_t base = grid->brick[b][a] * MURK_BRICK_EDGE;
            if (base + first[a] < grid->lo[a])
                grid->lo[a] = base + first[a];
            if (base + last[a] + 1 > grid->hi[a])
                grid->hi[a] = base + last[a] + 1;
        }
    }
}

murk_status murk_grid_create(murk_context *context, const murk_bricks *bricks, bool corner,
                             murk_grid **out)
{
    murk_status status;
    murk_grid *grid = murk_alloc(1, sizeof *grid);
    if (!grid)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for a grid");
    status = take_transform(context, grid, bricks->index_to_world);
    if (status)
        goto failed;
    for (size_t i = 1; i < bricks->count; i++)
        if (murk_brick_compare(bricks->brick[i - 1], bricks->brick[i]) >= 0) {
            status = murk_fail(context, MURK_ERROR_INTERNAL, "bricks are out of order");
            goto failed;
        }
    if (!copy_bricks(grid, bricks) || !fill_hash(grid)) {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for a grid of %zu bricks",
                           bricks->count);
        goto failed;
    }
    find_box(grid);
    for (int a = 0; a < 3; a++)
        grid->middle[a] = ((double)grid->hi[a] - grid->lo[a]) / 2;
    for (int c = 0; c < 3; c++) {
        grid->corner[c] = bricks->index_to_world[4 * c + 3];
        for (int a = 0; a < 3; a++)
            grid->corner[c] +=
                bricks->index_to_world[4 * c + a] * ((double)grid->lo[a] - (corner ? 0.0 : 0.5));
    }
    *out = grid;
    return MURK_OK;
failed:
    murk_grid_release(grid);
    return status;
}

void murk_grid_release(murk_grid *grid)
{
    if (!grid)
        return;
    murk_free(grid->brick);
    murk_free(grid->mask);
    murk_free(grid->zone_first);
    murk_free(grid->bucket);
    murk_free(grid);
}

int64_t murk_grid_slot(const murk_grid *grid, int32_t i, int32_t j, int32_t k)
{
    int32_t b = murk_grid_find(grid, i >> 3, j >> 3, k >> 3);
    return b == MURK_NO_BRICK
               ? -1
               : (int64_t)b * MURK_BRICK_SLOTS + (i & 7) * 64 + (j & 7) * 8 + (k & 7);
}

int64_t murk_grid_beside(const murk_grid *grid, size_t slot, int axis, int step)
{
    static const int stride[3] = {64, 8, 1};
    const int in[3] = {slot >> 6 & 7, slot >> 3 & 7, slot & 7};
    if (in[axis] + step >= 0 && in[axis] + step <= 7)
        return (int64_t)slot + step * stride[axis];
    const int32_t *brick = grid->brick[slot / MURK_BRICK_SLOTS];
    int32_t at[3] = {brick[0], brick[1], brick[2]};
    at[axis] += step;
    int32_t next = murk_grid_find(grid, at[0], at[1], at[2]);
    return next == MURK_NO_BRICK
               ? -1
               : (int64_t)next * MURK_BRICK_SLOTS + (int64_t)(slot & 511) - step * 7 * stride[axis];
}

void murk_grid_direction_to_world(const murk_grid *grid, const double frame[3], double world[3])
{
    for (int c = 0; c < 3; c++)
        world[c] =
            grid->axis[0][c] * frame[0] + grid->axis[1][c] * frame[1] + grid->axis[2][c] * frame[2];
}

void murk_grid_direction_from_world(const murk_grid *grid, const double world[3], double frame[3])
{
    for (int a = 0; a < 3; a++)
        frame[a] =
            grid->axis[a][0] * world[0] + grid->axis[a][1] * world[1] + grid->axis[a][2] * world[2];
}

bool murk_grid_same(const murk_grid *a, const murk_grid *b)
{
    return a == b || (a->brick_count == b->brick_count &&
                      !memcmp(a->brick, b->brick, a->brick_count * sizeof *a->brick) &&
                      !memcmp(a->mask, b->mask, a->brick_count * sizeof *a->mask) &&
                      !memcmp(a->voxel, b->voxel, sizeof a->voxel) &&
                      !memcmp(a->axis, b->axis, sizeof a->axis) &&
                      !memcmp(a->corner, b->corner, sizeof a->corner));
}

void murk_grid_to_world(const murk_grid *grid, const double frame[3], double world[3])
{
    murk_grid_direction_to_world(grid, frame, world);
    for (int c = 0; c < 3; c++)
        world[c] += grid->corner[c];
}

void murk_grid_from_world(const murk_grid *grid, const double world[3], double frame[3])
{
    const double offset[3] = {world[0] - grid->corner[0], world[1] - grid->corner[1],
                              world[2] - grid->corner[2]};
    murk_grid_direction_from_world(grid, offset, frame);
}
