/* SPDX-License-Identifier: Apache-2.0 */
#include "refine.h"

#include <stdlib.h>
#include <string.h>

enum { HALF = MURK_BRICK_EDGE / 2 };

void murk_refine_base(const murk_grid *zones, int32_t base[3])
{
    for (int a = 0; a < 3; a++)
        base[a] = zones->lo[a] & ~(MURK_BRICK_EDGE - 1);
}

/* The slot of the voxel that a half is part of, the halves' brick having the parity `odd`. */
static int whole_slot(const int32_t odd[3], int slot)
{
    return (odd[0] * HALF + (slot >> 6) / 2) * 64 + (odd[1] * HALF + (slot >> 3 & 7) / 2) * 8 +
           odd[2] * HALF + (slot & 7) / 2;
}

/* The bricks of halves with an active voxel, in ascending order. */
static bool find_bricks(const murk_grid *grid, const int32_t base[3], murk_bricks *out)
{
    out->brick = murk_alloc(8 * grid->brick_count, sizeof *out->brick);
    if (!out->brick)
        return false;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int n = 0; n < 8; n++) {
            const int32_t odd[3] = {n >> 2, n >> 1 & 1, n & 1};
            bool any = false;
            for (int slot = 0; !any && slot < MURK_BRICK_SLOTS; slot++)
                any = murk_grid_active(grid, b, whole_slot(odd, slot));
            for (int a = 0; any && a < 3; a++)
                out->brick[out->count][a] =
                    2 * (grid->brick[b][a] - base[a] / MURK_BRICK_EDGE) + odd[a];
            out->count += any;
        }
    qsort(out->brick, out->count, sizeof *out->brick, murk_brick_compare);
    out->mask = murk_alloc(out->count, sizeof *out->mask);
    out->values = murk_alloc(out->count * MURK_BRICK_SLOTS, sizeof(float));
    return out->mask && out->values;
}

/* The transform of the halves, whose cells are [i, i + 1]. */
static void place(const murk_grid *zones, const int32_t base[3], double matrix[16])
{
    memset(matrix, 0, 16 * sizeof *matrix);
    for (int c = 0; c < 3; c++) {
        matrix[4 * c + 3] = zones->corner[c];
        for (int a = 0; a < 3; a++) {
            matrix[4 * c + a] = zones->axis[a][c] * zones->voxel[a] / 2;
            matrix[4 * c + 3] -= zones->axis[a][c] * zones->voxel[a] * (zones->lo[a] - base[a]);
        }
    }
    matrix[15] = 1;
}

/* The halves of a field on the zones: active wherever the input is, 0 where no zone is. */
static bool halve(const murk_medium *medium, const float *field, murk_bricks *out)
{
    const murk_grid *zones = medium->grid, *input = medium->input;
    int32_t base[3];
    murk_refine_base(zones, base);
    if (!find_bricks(input, base, out))
        return false;
    place(zones, base, out->index_to_world);
    for (size_t b = 0; b < out->count; b++) {
        int32_t odd[3], at[3];
        for (int a = 0; a < 3; a++) {
            odd[a] = out->brick[b][a] & 1;
            at[a] = (out->brick[b][a] - odd[a]) / 2 + base[a] / MURK_BRICK_EDGE;
        }
        int32_t from = murk_grid_find(zones, at[0], at[1], at[2]);
        int32_t active = murk_grid_find(input, at[0], at[1], at[2]);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            int whole = whole_slot(odd, slot);
            if (!murk_grid_active(input, (size_t)active, whole))
                continue;
            out->mask[b][slot >> 6] |= (uint64_t)1 << (slot & 63);
            if (from != MURK_NO_BRICK)
                out->values[b * MURK_BRICK_SLOTS + (size_t)slot] =
                    field[(size_t)from * MURK_BRICK_SLOTS + (size_t)whole];
        }
    }
    return true;
}

murk_status murk_medium_refine(murk_context *context, const murk_medium *medium, murk_medium **out)
{
    murk_medium_parts parts = {.albedo_value = medium->albedo.constant,
                               .emission_value = medium->emission.constant,
                               .albedo_scale = 1,
                               .emission_scale = 1,
                               .extinction_scale = medium->extinction_scale,
                               .corner = true,
                               .where = "halved voxels"};
    if (halve(medium, medium->kappa_t, &parts.kappa_t) &&
        (!medium->albedo.field || halve(medium, medium->albedo.field, &parts.albedo)) &&
        (!medium->emission.field || halve(medium, medium->emission.field, &parts.emission)))
        return murk_medium_build(context, &parts, out);
    murk_bricks_clear(&parts.kappa_t);
    murk_bricks_clear(&parts.albedo);
    murk_bricks_clear(&parts.emission);
    return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                     8 * medium->grid->zone_count);
}

void murk_refine_average(const murk_grid *fine, const float *field, const int32_t base[3],
                         const murk_grid *grid, float *out)
{
    memset(out, 0, grid->brick_count * MURK_BRICK_SLOTS * sizeof *out);
    for (size_t b = 0; b < fine->brick_count; b++) {
        int32_t odd[3], at[3];
        for (int a = 0; a < 3; a++) {
            odd[a] = fine->brick[b][a] & 1;
            at[a] = (fine->brick[b][a] - odd[a]) / 2 + base[a] / MURK_BRICK_EDGE;
        }
        int32_t to = murk_grid_find(grid, at[0], at[1], at[2]);
        for (int slot = 0; to != MURK_NO_BRICK && slot < MURK_BRICK_SLOTS; slot++) {
            int whole = whole_slot(odd, slot);
            if (murk_grid_active(fine, b, slot) && murk_grid_active(grid, (size_t)to, whole))
                out[(size_t)to * MURK_BRICK_SLOTS + (size_t)whole] +=
                    field[b * MURK_BRICK_SLOTS + (size_t)slot] / 8;
        }
    }
}
