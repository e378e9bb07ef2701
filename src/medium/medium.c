/* SPDX-License-Identifier: Apache-2.0 */
#include "medium.h"

#include "murk/band.h"

#include <math.h>
#include <string.h>

/* Counts what is not a finite non-negative extinction and makes it 0. */
static murk_status clean_extinction(murk_context *context, murk_medium_parts *parts,
                                    uint64_t *invalid)
{
    murk_bricks *kappa_t = &parts->kappa_t;
    uint64_t count = 0;
    for (size_t i = 0; i < kappa_t->count * MURK_BRICK_SLOTS; i++) {
        float *k = &kappa_t->values[i];
        if (!(*k >= 0 && *k <= 3e38f)) {
            *k = 0;
            count++;
        } else
            *k = (float)murk_or_none(*k);
    }
    if (count && parts->strict)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: %llu voxels are NaN, infinite or negative; mend the grid or leave "
                         "out --strict to treat them as empty",
                         parts->where, (unsigned long long)count);
    if (count)
        murk_warn(context, "%s: %llu voxels are NaN, infinite or negative: treated as empty",
                  parts->where, (unsigned long long)count);
    *invalid = count;
    return MURK_OK;
}

/* Splits the input's topology from that of the zones. */
static murk_status make_grids(murk_context *context, murk_medium *medium, murk_medium_parts *parts)
{
    murk_bricks *bricks = &parts->kappa_t;
    murk_status status = murk_grid_create(context, bricks, parts->corner, &medium->input);
    if (status)
        return status;
    for (size_t b = 0; b < bricks->count; b++)
        for (int x = 0; x < 8; x++) {
            const float *values = bricks->values + b * MURK_BRICK_SLOTS + 64 * x;
            uint64_t zones = 0;
            for (int i = 0; i < 64; i++)
                zones |= (uint64_t)(values[i] > 0) << i;
            bricks->mask[b][x] &= zones;
        }
    status = murk_grid_create(context, bricks, parts->corner, &medium->grid);
    if (status)
        return status;
    const murk_grid *grid = medium->grid;
    medium->kappa_t = murk_alloc(grid->brick_count * MURK_BRICK_SLOTS, sizeof(float));
    if (!medium->kappa_t)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory for %zu zones",
                         parts->where, grid->zone_count);
    size_t from = 0;
    for (size_t b = 0; b < grid->brick_count; b++, from++) {
        while (memcmp(bricks->brick[from], grid->brick[b], sizeof *grid->brick))
            from++;
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (murk_grid_active(grid, b, slot))
                medium->kappa_t[b * MURK_BRICK_SLOTS + (size_t)slot] =
                    bricks->values[from * MURK_BRICK_SLOTS + (size_t)slot];
    }
    return MURK_OK;
}

/* A second grid's values at the zones, in [0, maximum]. */
static murk_status take_values(murk_context *context, const murk_medium *medium,
                               const murk_medium_parts *parts, const murk_bricks *bricks,
                               double scale, double offset, double constant, double maximum,
                               const char *name, murk_values *out)
{
    const murk_grid *grid = medium->grid;
    bool varies = bricks->count > 0;
    out->constant = (float)murk_or_none(constant);
    if (!varies) {
        if (!(constant >= 0 && constant <= maximum))
            return murk_fail(context, MURK_ERROR_INPUT, "%s: %s %g is not in [0, %g]", parts->where,
                             name, constant, maximum);
        return MURK_OK;
    }
    murk_grid *lookup = NULL;
    murk_status status = murk_grid_create(context, bricks, parts->corner, &lookup);
    if (status)
        return status;
    size_t slots = grid->brick_count * MURK_BRICK_SLOTS, bad = 0;
    float worst = 0;
    float *field = murk_alloc(slots, sizeof *field);
    if (!field) {
        murk_grid_release(lookup);
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory for %s", parts->where,
                         name);
    }
    size_t *source = murk_alloc(lookup->brick_count, sizeof *source);
    for (size_t b = 0, from = 0; source && b < lookup->brick_count; b++, from++) {
        while (memcmp(bricks->brick[from], lookup->brick[b], sizeof *lookup->brick))
            from++;
        source[b] = from;
    }
    for (size_t b = 0; source && b < grid->brick_count; b++) {
        const int32_t *c = grid->brick[b];
        int32_t at = murk_grid_find(lookup, c[0], c[1], c[2]);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            if (!murk_grid_active(grid, b, slot))
                continue;
            float value = bricks->background;
            if (at != MURK_NO_BRICK && murk_grid_active(lookup, (size_t)at, slot))
                value = bricks->values[source[at] * MURK_BRICK_SLOTS + (size_t)slot];
            value = value * (float)scale + (float)offset;
            if (!(value >= 0 && value <= (float)maximum)) {
                bad++;
                worst = value;
                value = value > (float)maximum ? (float)maximum : 0;
            }
            field[b * MURK_BRICK_SLOTS + (size_t)slot] = (float)murk_or_none(value);
        }
    }
    status = source ? MURK_OK
                    : murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory for %s",
                                parts->where, name);
    murk_free(source);
    murk_grid_release(lookup);
    if (!status && bad && (maximum <= 1 || parts->strict))
        status = murk_fail(context, MURK_ERROR_INPUT,
                           "%s: the %s grid has %zu voxels outside [0, %g], such as %g; scale it",
                           parts->where, name, bad, maximum, (double)worst);
    if (status) {
        murk_free(field);
        return status;
    }
    if (bad)
        murk_warn(context,
                  "%s: the %s grid has %zu voxels that are NaN, infinite or negative: "
                  "treated as 0",
                  parts->where, name, bad);
    out->field = field;
    return MURK_OK;
}

/* Adds pi times Planck's radiance to the emission: black bodies, of which zones take the part that
   they absorb. */
static murk_status add_thermal(murk_context *context, murk_medium *medium,
                               const murk_medium_parts *parts)
{
    const double hottest = 1e8; /* K, the middle of a star */
    const size_t slots = medium->grid->brick_count * MURK_BRICK_SLOTS;
    murk_values temperature = {0}, *emission = &medium->emission;
    if (!murk_band_valid(&parts->band))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: a temperature needs a band of wavelengths to radiate in",
                         parts->where);
    murk_status status = take_values(
        context, medium, parts, &parts->temperature, parts->temperature_scale,
        parts->temperature_offset, parts->temperature_value, hottest, "temperature", &temperature);
    if (status)
        return status;
    if (!temperature.field && !emission->field) {
        emission->constant +=
            (float)(M_PI * murk_planck_radiance(&parts->band, temperature.constant));
        return MURK_OK;
    }
    float *field = emission->field ? emission->field : temperature.field;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t i = 0; i < slots; i++)
        if (medium->kappa_t[i] > 0)
            field[i] =
                (float)(murk_value(emission, i) +
                        M_PI * murk_planck_radiance(&parts->band, murk_value(&temperature, i)));
    if (field == emission->field)
        murk_free(temperature.field);
    emission->field = field;
    return MURK_OK;
}

/* Forward scattering that moves less than this part of the extinction is left out. */
static const double LEAST_FORWARD = 1e-5;

static murk_status keep_name(murk_context *context, murk_medium *medium, const char *name)
{
    if (!name)
        return MURK_OK;
    medium->extinction_grid = murk_alloc(strlen(name) + 1, 1);
    if (!medium->extinction_grid)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    strcpy(medium->extinction_grid, name);
    return MURK_OK;
}

static murk_status check_asymmetry(murk_context *context, const murk_medium_parts *parts)
{
    if (parts->asymmetry > -1 && parts->asymmetry < 1)
        return MURK_OK;
    return murk_fail(context, MURK_ERROR_INPUT,
                     "%s: asymmetry %g is not between -1 and 1; 0 scatters evenly, clouds about "
                     "0.85",
                     parts->where, parts->asymmetry);
}

murk_status murk_medium_build(murk_context *context, murk_medium_parts *parts, murk_medium **out)
{
    murk_status status = MURK_ERROR_MEMORY;
    murk_medium *medium = murk_alloc(1, sizeof *medium);
    if (!medium) {
        murk_fail(context, status, "out of memory");
        goto done;
    }
    medium->references = 1;
    medium->corner = parts->corner;
    medium->extinction_scale = parts->extinction_scale;
    medium->asymmetry = parts->asymmetry;
    status = check_asymmetry(context, parts);
    if (!status)
        status = keep_name(context, medium, parts->extinction_grid);
    if (!status)
        status = clean_extinction(context, parts, &medium->invalid_voxels);
    if (!status)
        status = make_grids(context, medium, parts);
    if (!status)
        status = take_values(context, medium, parts, &parts->albedo, parts->albedo_scale, 0,
                             parts->albedo_value, 1, "albedo", &medium->albedo);
    if (!status && !medium->albedo.field &&
        medium->albedo.constant * fabs(medium->asymmetry) < LEAST_FORWARD)
        medium->asymmetry = 0;
    if (!status)
        status = take_values(context, medium, parts, &parts->emission, parts->emission_scale, 0,
                             parts->emission_value, 1e30, "emission", &medium->emission);
    if (!status && (parts->temperature.count || parts->temperature_value > 0))
        status = add_thermal(context, medium, parts);
    if (status)
        murk_medium_release(medium);
    else
        *out = medium;
done:
    murk_bricks_clear(&parts->kappa_t);
    murk_bricks_clear(&parts->albedo);
    murk_bricks_clear(&parts->emission);
    murk_bricks_clear(&parts->temperature);
    return status;
}

bool murk_medium_same_extinction(const murk_medium *a, const murk_medium *b)
{
    return a == b || (murk_grid_same(a->grid, b->grid) &&
                      !memcmp(a->kappa_t, b->kappa_t,
                              a->grid->brick_count * MURK_BRICK_SLOTS * sizeof *a->kappa_t));
}

murk_medium *murk_medium_share(const murk_medium *medium)
{
    murk_medium *shared = (murk_medium *)medium;
    shared->references++;
    return shared;
}

void murk_medium_release(murk_medium *medium)
{
    if (!medium || --medium->references > 0)
        return;
    if (!medium->whole) {
        murk_grid_release(medium->grid);
        murk_grid_release(medium->input);
        murk_free(medium->emission.field);
        murk_free(medium->extinction_grid);
    }
    murk_medium_release(medium->whole);
    murk_free(medium->kappa_t);
    murk_free(medium->albedo.field);
    murk_free(medium);
}
