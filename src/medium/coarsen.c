/* SPDX-License-Identifier: Apache-2.0 */
#include "coarsen.h"

#include <stdlib.h>
#include <string.h>

/* Along one axis of a fine brick: the first of the two coarse bricks that it can reach into, which
   of them a voxel lies in, and where in it. */
struct place {
    int32_t brick;
    int second[8], voxel[8];
};

static void find_place(const murk_grid *fine, int shift, size_t brick, int axis, struct place *out)
{
    int32_t base = fine->brick[brick][axis] * MURK_BRICK_EDGE - fine->lo[axis];
    for (int i = 0; i < MURK_BRICK_EDGE; i++) {
        int32_t at = base + i < 0 ? 0 : (base + i) >> shift; /* below the corner are no zones */
        if (!i)
            out->brick = at >> 3;
        out->second[i] = (at >> 3) - out->brick;
        out->voxel[i] = at & 7;
    }
}

/* Coarse brick number n (of 8) that a fine brick can reach. */
static void candidate(const struct place place[3], int n, int32_t out[3])
{
    for (int a = 0; a < 3; a++)
        out[a] = place[a].brick + (n >> a & 1);
}

static int which(const struct place place[3], int slot)
{
    return place[0].second[slot >> 6] | place[1].second[slot >> 3 & 7] << 1 |
           place[2].second[slot & 7] << 2;
}

/* The coarse bricks that zones fall into, sorted; the active voxels are not marked yet. */
static bool find_bricks(const murk_grid *fine, int shift, murk_bricks *out)
{
    size_t count = 0, unique = 0;
    int32_t(*all)[3] = murk_alloc(8 * fine->brick_count, sizeof *all);
    if (!all)
        return false;
    for (size_t b = 0; b < fine->brick_count; b++) {
        struct place place[3];
        unsigned met = 0;
        for (int a = 0; a < 3; a++)
            find_place(fine, shift, b, a, &place[a]);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (murk_grid_active(fine, b, slot))
                met |= 1u << which(place, slot);
        for (int n = 0; n < 8; n++)
            if (met >> n & 1)
                candidate(place, n, all[count++]);
    }
    qsort(all, count, sizeof *all, murk_brick_compare);
    for (size_t i = 0; i < count; i++)
        if (!i || murk_brick_compare(all[i], all[unique - 1]))
            memmove(all[unique++], all[i], sizeof *all);
    out->count = unique;
    out->brick = all;
    out->mask = murk_alloc(unique, sizeof *out->mask);
    return out->mask;
}

static void mark_voxels(const murk_grid *fine, int shift, murk_bricks *bricks)
{
    for (size_t b = 0; b < fine->brick_count; b++) {
        struct place place[3];
        size_t found[8];
        for (int a = 0; a < 3; a++)
            find_place(fine, shift, b, a, &place[a]);
        for (int n = 0; n < 8; n++) {
            int32_t key[3];
            candidate(place, n, key);
            const int32_t(*at)[3] = bsearch(key, bricks->brick, bricks->count,
                                            sizeof *bricks->brick, murk_brick_compare);
            found[n] = at ? (size_t)(at - (const int32_t(*)[3])bricks->brick) : 0;
        }
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (murk_grid_active(fine, b, slot))
                bricks->mask[found[which(place, slot)]][place[0].voxel[slot >> 6]] |=
                    (uint64_t)1 << (place[1].voxel[slot >> 3 & 7] * 8 + place[2].voxel[slot & 7]);
    }
}

void murk_coarse_slots(const murk_grid *fine, const murk_grid *coarse, int shift, size_t brick,
                       size_t slots[MURK_BRICK_SLOTS])
{
    if (!shift) {
        for (size_t slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            slots[slot] = brick * MURK_BRICK_SLOTS + slot;
        return;
    }
    struct place place[3];
    size_t found[8];
    for (int a = 0; a < 3; a++)
        find_place(fine, shift, brick, a, &place[a]);
    for (int n = 0; n < 8; n++) {
        int32_t key[3];
        candidate(place, n, key);
        int32_t at = murk_grid_find(coarse, key[0], key[1], key[2]);
        found[n] = at == MURK_NO_BRICK ? 0 : (size_t)at;
    }
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
        slots[slot] = found[which(place, slot)] * MURK_BRICK_SLOTS +
                      (size_t)(place[0].voxel[slot >> 6] * 64 + place[1].voxel[slot >> 3 & 7] * 8 +
                               place[2].voxel[slot & 7]);
}

/* Sums kappa_t, and kappa_t albedo, over the voxels that each coarse one covers, then divides. */
static void average(const murk_medium *medium, int shift, murk_medium *coarse)
{
    const murk_grid *fine = medium->grid;
    size_t count = coarse->grid->brick_count * MURK_BRICK_SLOTS, slots[MURK_BRICK_SLOTS];
    float share = 1 / (float)(1 << 3 * shift), *albedo = coarse->albedo.field;
    for (size_t b = 0; b < fine->brick_count; b++) {
        murk_coarse_slots(fine, coarse->grid, shift, b, slots);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            size_t i = b * MURK_BRICK_SLOTS + (size_t)slot;
            if (!murk_grid_active(fine, b, slot))
                continue;
            float kappa_t = share * medium->kappa_t[i];
            coarse->kappa_t[slots[slot]] += kappa_t;
            if (albedo)
                albedo[slots[slot]] += kappa_t * medium->albedo.field[i];
        }
    }
    for (size_t i = 0; albedo && i < count; i++)
        if (coarse->kappa_t[i] > 0)
            albedo[i] = albedo[i] < coarse->kappa_t[i] ? albedo[i] / coarse->kappa_t[i] : 1;
}

/* The transform of the coarse voxels: cells [I, I + 1] from the low corner of the zones. */
static void coarse_transform(const murk_grid *fine, int shift, double matrix[16])
{
    memset(matrix, 0, 16 * sizeof *matrix);
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++)
            matrix[4 * c + a] = fine->axis[a][c] * fine->voxel[a] * (1 << shift);
        matrix[4 * c + 3] = fine->corner[c];
    }
    matrix[15] = 1;
}

murk_status murk_medium_coarsen(murk_context *context, const murk_medium *medium, int shift,
                                murk_medium **out)
{
    if (!shift) {
        *out = murk_medium_share(medium);
        return MURK_OK;
    }
    murk_bricks bricks = {0};
    murk_status status = MURK_OK;
    murk_medium *coarse = murk_alloc(1, sizeof *coarse);
    bool ok = coarse && find_bricks(medium->grid, shift, &bricks);
    if (ok) {
        coarse->references = 1;
        coarse->corner = true;
        coarse->albedo.constant = medium->albedo.constant;
        mark_voxels(medium->grid, shift, &bricks);
        coarse_transform(medium->grid, shift, bricks.index_to_world);
        status = murk_grid_create(context, &bricks, true, &coarse->grid);
    }
    if (ok && !status) {
        size_t slots = coarse->grid->brick_count * MURK_BRICK_SLOTS;
        coarse->kappa_t = murk_alloc(slots, sizeof(float));
        if (medium->albedo.field)
            coarse->albedo.field = murk_alloc(slots, sizeof(float));
        ok = coarse->kappa_t && (!medium->albedo.field || coarse->albedo.field);
    }
    if (!ok)
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           medium->grid->zone_count);
    murk_bricks_clear(&bricks);
    if (status) {
        murk_medium_release(coarse);
        return status;
    }
    average(medium, shift, coarse);
    *out = coarse;
    return MURK_OK;
}
