/* SPDX-License-Identifier: Apache-2.0 */
#include "blocks.h"

/* First voxel and number of voxels that a neighbour at -1, 0, +1 lends to the block. */
static const int FROM[3] = {7, 0, 0}, COUNT[3] = {1, 8, 1}, TO[3] = {0, 1, 9};

static void fill_block(const murk_grid *grid, const float *field, const int32_t brick[3],
                       float *block)
{
    for (int n = 0; n < 27; n++) {
        const int d[3] = {n / 9, n / 3 % 3, n % 3};
        int32_t b =
            murk_grid_find(grid, brick[0] + d[0] - 1, brick[1] + d[1] - 1, brick[2] + d[2] - 1);
        if (b == MURK_NO_BRICK)
            continue;
        const float *values = field + (size_t)b * MURK_BRICK_SLOTS;
        for (int x = 0; x < COUNT[d[0]]; x++)
            for (int y = 0; y < COUNT[d[1]]; y++)
                for (int z = 0; z < COUNT[d[2]]; z++)
                    block[((TO[d[0]] + x) * MURK_BLOCK_EDGE + TO[d[1]] + y) * MURK_BLOCK_EDGE +
                          TO[d[2]] + z] =
                        values[(FROM[d[0]] + x) * 64 + (FROM[d[1]] + y) * 8 + FROM[d[2]] + z];
    }
}

/* (1 - albedo) E: what a zone radiates by itself. */
static float glow_of(const murk_medium *medium, size_t slot)
{
    return (1 - murk_value(&medium->albedo, slot)) * murk_value(&medium->emission, slot);
}

/* Emission (1 - albedo) E of the zones next to a voxel that is none: their mean. */
static float emission_beside(const murk_medium *medium, const int32_t voxel[3])
{
    double sum = 0;
    int count = 0;
    for (int n = 0; n < 27; n++) {
        int64_t slot = murk_grid_slot(medium->grid, voxel[0] + n / 9 - 1, voxel[1] + n / 3 % 3 - 1,
                                      voxel[2] + n % 3 - 1);
        if (slot < 0 || !(medium->kappa_t[slot] > 0))
            continue;
        sum += glow_of(medium, (size_t)slot);
        count++;
    }
    return count ? (float)(sum / count) : 0;
}

/* The solution holds albedo G / 4 beyond the zones, as other programs expect it. Here emission is
   carried on too, or a glowing medium would fade towards its rim. */
static void add_emission(const murk_medium *medium, const int32_t brick[3], float *block)
{
    for (int n = 0; n < MURK_BLOCK_SLOTS; n++) {
        const int32_t voxel[3] = {brick[0] * MURK_BRICK_EDGE + n / 100 - 1,
                                  brick[1] * MURK_BRICK_EDGE + n / 10 % 10 - 1,
                                  brick[2] * MURK_BRICK_EDGE + n % 10 - 1};
        int64_t slot = murk_grid_slot(medium->grid, voxel[0], voxel[1], voxel[2]);
        if (slot < 0 || !(medium->kappa_t[slot] > 0))
            block[n] += emission_beside(medium, voxel);
    }
}

bool murk_blocks_any_glow(const murk_solution *solution)
{
    const float least = 1e-9f;
    const murk_medium *medium = solution->medium;
    float glow = 0, light = 0;
    if (!medium->emission.field && !(medium->emission.constant > 0))
        return false;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++)
        if (medium->kappa_t[i] > 0)
            glow = fmaxf(glow, glow_of(medium, i));
    for (size_t i = 0; i < solution->grid->brick_count * MURK_BRICK_SLOTS; i++)
        light = fmaxf(light, solution->radiosity[i]);
    return glow > least * light;
}

static float *create(murk_context *context, const murk_medium *medium, const murk_grid *lit,
                     const float *field, bool glows)
{
    const murk_grid *grid = medium->grid;
    float *blocks = murk_alloc(grid->brick_count * MURK_BLOCK_SLOTS, sizeof *blocks);
    if (!blocks)
        return NULL;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++) {
        fill_block(lit, field, grid->brick[b], blocks + b * MURK_BLOCK_SLOTS);
        if (glows)
            add_emission(medium, grid->brick[b], blocks + b * MURK_BLOCK_SLOTS);
    }
    return blocks;
}

float *murk_blocks_create(murk_context *context, const murk_solution *solution)
{
    return create(context, solution->medium, solution->grid, solution->radiosity,
                  murk_blocks_any_glow(solution));
}

float *murk_blocks_glow(murk_context *context, const murk_solution *solution)
{
    const murk_medium *medium = solution->medium;
    const size_t slots = medium->grid->brick_count * MURK_BRICK_SLOTS;
    float *glow = murk_alloc(slots, sizeof *glow);
    if (!glow)
        return NULL;
    for (size_t i = 0; i < slots; i++)
        if (medium->kappa_t[i] > 0)
            glow[i] = glow_of(medium, i);
    float *blocks = create(context, medium, medium->grid, glow, true);
    murk_free(glow);
    return blocks;
}
