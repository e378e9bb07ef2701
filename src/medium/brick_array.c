/* SPDX-License-Identifier: Apache-2.0 */
/* Media from bricks in memory. */
#include "medium.h"

#include <stdlib.h>
#include <string.h>

/* A brick's coordinates and its place in the arrays. */
struct place {
    int32_t at[3];
    size_t from;
};

/* The bricks in ascending order, from murk_alloc. */
static murk_status sort(murk_context *context, const murk_brick_array *bricks, struct place **out)
{
    struct place *places = murk_alloc(bricks->count, sizeof *places);
    if (!places)
        return murk_fail(context, MURK_ERROR_MEMORY, "bricks: out of memory");
    for (size_t b = 0; b < bricks->count; b++) {
        memcpy(places[b].at, bricks->brick + 3 * b, sizeof places[b].at);
        places[b].from = b;
    }
    qsort(places, bricks->count, sizeof *places, murk_brick_compare);
    for (size_t b = 1; b < bricks->count; b++)
        if (!murk_brick_compare(&places[b - 1], &places[b])) {
            const int32_t *at = places[b].at;
            murk_status status =
                murk_fail(context, MURK_ERROR_INPUT, "bricks: brick (%d, %d, %d) is there twice",
                          (int)at[0], (int)at[1], (int)at[2]);
            murk_free(places);
            return status;
        }
    *out = places;
    return MURK_OK;
}

/* Copies values in the order of places; the voxels with extinction are active. */
static bool copy(const murk_brick_array *bricks, const struct place *places, const float *values,
                 murk_bricks *out)
{
    out->brick = murk_alloc(bricks->count, sizeof *out->brick);
    out->mask = murk_alloc(bricks->count, sizeof *out->mask);
    out->values = murk_alloc(bricks->count * MURK_BRICK_SLOTS, sizeof(float));
    if (!out->brick || !out->mask || !out->values)
        return false;
    for (size_t b = 0; b < bricks->count; b++) {
        size_t from = places[b].from * MURK_BRICK_SLOTS;
        memcpy(out->brick[b], places[b].at, sizeof *out->brick);
        memcpy(out->values + b * MURK_BRICK_SLOTS, values + from,
               MURK_BRICK_SLOTS * sizeof *values);
        for (size_t slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            out->mask[b][slot >> 6] |= (uint64_t)(bricks->kappa_t[from + slot] != 0) << (slot & 63);
    }
    out->count = bricks->count;
    murk_bricks_place(out, bricks->voxel_size, bricks->origin);
    return true;
}

murk_status murk_medium_from_bricks(murk_context *context, const murk_brick_array *bricks,
                                    murk_medium **out)
{
    murk_medium_parts parts = {.albedo_value = bricks->albedo_value,
                               .emission_value = bricks->emission_value,
                               .albedo_scale = 1,
                               .emission_scale = 1,
                               .asymmetry = bricks->asymmetry,
                               .strict = true,
                               .where = "bricks"};
    struct place *places = NULL;
    murk_status status = sort(context, bricks, &places);
    if (status)
        return status;
    if (!copy(bricks, places, bricks->kappa_t, &parts.kappa_t) ||
        (bricks->albedo && !copy(bricks, places, bricks->albedo, &parts.albedo)) ||
        (bricks->emission && !copy(bricks, places, bricks->emission, &parts.emission))) {
        murk_bricks_clear(&parts.kappa_t);
        murk_bricks_clear(&parts.albedo);
        murk_bricks_clear(&parts.emission);
        status = murk_fail(context, MURK_ERROR_MEMORY, "bricks: out of memory");
    }
    murk_free(places);
    return status ? status : murk_medium_build(context, &parts, out);
}
