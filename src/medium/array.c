/* SPDX-License-Identifier: Apache-2.0 */
/* Media from dense arrays in memory. */
#include "medium.h"

#include <string.h>

/* Cuts a dense array into bricks; every voxel of the box is active. */
static bool cut(const murk_array *array, const float *values, double constant, murk_bricks *out)
{
    const int32_t n[3] = {(array->size[0] + 7) / 8, (array->size[1] + 7) / 8,
                          (array->size[2] + 7) / 8};
    size_t count = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    out->brick = murk_alloc(count, sizeof *out->brick);
    out->mask = murk_alloc(count, sizeof *out->mask);
    out->values = murk_alloc(count * MURK_BRICK_SLOTS, sizeof(float));
    if (!out->brick || !out->mask || !out->values)
        return false;
    for (size_t b = 0; b < count; b++) {
        int32_t *c = out->brick[b];
        c[2] = (int32_t)(b % (size_t)n[2]);
        c[1] = (int32_t)(b / (size_t)n[2] % (size_t)n[1]);
        c[0] = (int32_t)(b / (size_t)n[2] / (size_t)n[1]);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            int32_t i = c[0] * 8 + (slot >> 6), j = c[1] * 8 + (slot >> 3 & 7),
                    k = c[2] * 8 + (slot & 7);
            if (i >= array->size[0] || j >= array->size[1] || k >= array->size[2])
                continue;
            size_t at = ((size_t)i * (size_t)array->size[1] + (size_t)j) * (size_t)array->size[2] +
                        (size_t)k;
            out->mask[b][slot >> 6] |= (uint64_t)1 << (slot & 63);
            out->values[b * MURK_BRICK_SLOTS + (size_t)slot] =
                values ? values[at] : (float)constant;
        }
    }
    out->count = count;
    murk_bricks_place(out, array->voxel_size, array->origin);
    return true;
}

murk_status murk_medium_from_array(murk_context *context, const murk_array *array,
                                   murk_medium **out)
{
    for (int a = 0; a < 3; a++)
        if (array->size[a] < 1)
            return murk_fail(context, MURK_ERROR_INPUT,
                             "array: size[%d] is %d, at least 1 is needed", a, (int)array->size[a]);
    murk_medium_parts parts = {.albedo_value = array->albedo_value,
                               .emission_value = array->emission_value,
                               .albedo_scale = 1,
                               .emission_scale = 1,
                               .asymmetry = array->asymmetry,
                               .strict = true,
                               .where = "array"};
    if (!cut(array, array->kappa_t, array->kappa_t_value, &parts.kappa_t) ||
        (array->albedo && !cut(array, array->albedo, 0, &parts.albedo)) ||
        (array->emission && !cut(array, array->emission, 0, &parts.emission))) {
        murk_bricks_clear(&parts.kappa_t);
        murk_bricks_clear(&parts.albedo);
        murk_bricks_clear(&parts.emission);
        return murk_fail(context, MURK_ERROR_MEMORY, "array: out of memory");
    }
    return murk_medium_build(context, &parts, out);
}
