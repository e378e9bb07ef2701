/* SPDX-License-Identifier: Apache-2.0 */
#include "coarse.h"

#include "coarsen.h"
#include "preconditioner.h"

#include <math.h>
#include <string.h>

typedef float zone_value(const murk_coarse *coarse, const void *user, size_t i, size_t o);

/* Sets a field on the coarse zones to the mean over the voxels that they cover, weighted by their
   extinction: sums of kappa_t V times the field are kept. i is a slot of the medium's grid, o the
   same of the solution's. */
static void restrict_zones(const murk_coarse *coarse, zone_value *value, const void *user,
                           float *out)
{
    const murk_medium *medium = coarse->solution->medium;
    size_t slots[MURK_BRICK_SLOTS];
    float share = 1 / (float)(1 << 3 * coarse->shift);
    memset(out, 0, coarse->system.slots * sizeof *out);
    for (size_t b = 0; b < medium->grid->brick_count; b++) {
        size_t i = b * MURK_BRICK_SLOTS, o = murk_stage_slots(coarse->stage, b);
        murk_coarse_slots(medium->grid, coarse->medium->grid, coarse->shift, b, slots);
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++)
            if (medium->kappa_t[i + s] > 0)
                out[slots[s]] += share * medium->kappa_t[i + s] * value(coarse, user, i + s, o + s);
    }
    for (size_t i = 0; i < coarse->system.slots; i++)
        if (coarse->medium->kappa_t[i] > 0)
            out[i] /= coarse->medium->kappa_t[i];
}

static float direct_value(const murk_coarse *coarse, const void *user, size_t i, size_t o)
{
    (void)user;
    return murk_stage_direct(coarse->stage, coarse->solution->medium, i, o);
}

struct residual {
    const float *net;
    const murk_region *region;
};

static float residual_value(const murk_coarse *coarse, const void *user, size_t i, size_t o)
{
    const struct residual *of = user;
    const murk_grid *grid = coarse->solution->medium->grid;
    if (!murk_region_has(of->region, grid->brick[i / MURK_BRICK_SLOTS]))
        return 0;
    const float *net = of->net, x = coarse->solution->radiosity[o];
    float albedo = murk_value(&coarse->solution->medium->albedo, i);
    return direct_value(coarse, NULL, i, o) + albedo * net[o] - (1 - albedo) * x;
}

/* Radiosity of the voxel in another solution, without what is a lamp now; where it has none, that
   of beam and emission. */
static float start_value(const murk_coarse *coarse, const void *user, size_t i, size_t o)
{
    const murk_solution *start = user;
    const int32_t *brick = coarse->solution->medium->grid->brick[i / MURK_BRICK_SLOTS];
    int32_t at = murk_grid_find(start->grid, brick[0], brick[1], brick[2]);
    int slot = (int)(i % MURK_BRICK_SLOTS);
    if (at == MURK_NO_BRICK || !murk_grid_active(start->grid, (size_t)at, slot))
        return direct_value(coarse, NULL, i, o);
    const murk_medium *medium = coarse->solution->medium;
    float lamp = (1 - murk_value(&medium->albedo, i)) *
                 (murk_value(&medium->emission, i) - murk_value(&coarse->stage->emission, i));
    return fmaxf(0, start->radiosity[(size_t)at * MURK_BRICK_SLOTS + (size_t)slot] - lamp);
}

void murk_coarse_restrict(murk_coarse *coarse, const float *net, const float *net_slope,
                          const float *incident, const murk_region *region)
{
    const murk_bent *bent = &coarse->stage->bend.zones;
    for (size_t j = 0; j < coarse->system.slopes; j++) {
        size_t i = murk_bent_slot(bent, j);
        bool there = murk_region_has(region, coarse->medium->grid->brick[i / MURK_BRICK_SLOTS]);
        coarse->r.slope[j] = there ? murk_system_left(&coarse->system, i, coarse->direct.slope[j],
                                                      net_slope[j], coarse->x.slope[j])
                                   : 0;
    }
    restrict_zones(coarse, residual_value, &(struct residual){net, region}, coarse->r.zone);
    for (size_t i = 0; i < coarse->system.patches; i++)
        coarse->r.patch[i] = coarse->direct.patch[i] +
                             coarse->system.ground->reflectance[i] * incident[i] -
                             coarse->x.patch[i];
}

/* G/4 by scattering on the coarse zones, in place of r. */
static void find_scattered(murk_coarse *coarse)
{
    for (size_t i = 0; i < coarse->system.slots; i++) {
        float albedo = murk_value(&coarse->medium->albedo, i);
        coarse->r.zone[i] = coarse->medium->kappa_t[i] > 0 && albedo > 0
                                ? (coarse->x.zone[i] - coarse->direct.zone[i]) / albedo
                                : 0;
    }
}

/* Difference of a field across a zone along one axis: to both neighbours, to the one that is there,
   or 0. */
static float slope(const murk_medium *medium, const float *field, size_t slot, int axis)
{
    float value[2], found = 0;
    for (int side = 0; side < 2; side++) {
        int64_t to = murk_grid_beside(medium->grid, slot, axis, side ? 1 : -1);
        bool there = to >= 0 && medium->kappa_t[to] > 0;
        value[side] = there ? field[to] : field[slot];
        found += there;
    }
    return found > 0 ? (value[1] - value[0]) / found : 0;
}

void murk_coarse_prolong(murk_coarse *coarse, murk_solution *solution)
{
    const murk_medium *medium = solution->medium;
    const murk_grid *grid = medium->grid;
    const float *scattered = coarse->r.zone;
    int width = 1 << coarse->shift;
    find_scattered(coarse);
#pragma omp parallel for num_threads(coarse->context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++) {
        size_t i = b * MURK_BRICK_SLOTS, o = murk_stage_slots(coarse->stage, b), last = SIZE_MAX;
        size_t slots[MURK_BRICK_SLOTS];
        float slopes[3] = {0};
        murk_coarse_slots(grid, coarse->medium->grid, coarse->shift, b, slots);
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++) {
            if (!(medium->kappa_t[i + s] > 0))
                continue;
            const int in[3] = {(int)(s >> 6), (int)(s >> 3 & 7), (int)(s & 7)};
            float value = scattered[slots[s]];
            for (int a = 0; coarse->shift && a < 3; a++) {
                int32_t at = grid->brick[b][a] * MURK_BRICK_EDGE + in[a] - grid->lo[a];
                if (slots[s] != last)
                    slopes[a] = slope(coarse->medium, scattered, slots[s], a);
                value += slopes[a] * (((float)(at & (width - 1)) + 0.5f) / (float)width - 0.5f);
            }
            last = slots[s];
            solution->radiosity[o + s] = murk_stage_direct(coarse->stage, medium, i + s, o + s) +
                                         murk_value(&medium->albedo, i + s) * fmaxf(0, value);
        }
    }
}

/* ---- one band ------------------------------------------------------------------------------ */

murk_system murk_coarse_system(const murk_coarse *coarse, murk_lines *lines)
{
    const murk_ground *ground = coarse->solution->ground;
    return (murk_system){.context = coarse->context,
                         .method = &murk_exchange_lines,
                         .state = lines,
                         .medium = coarse->medium,
                         .bent = &coarse->stage->bend.zones,
                         .slopes = coarse->stage->bend.zones.count * MURK_BENT_SLOTS,
                         .ground = ground,
                         .slots = coarse->medium->grid->brick_count * MURK_BRICK_SLOTS,
                         .patches = ground ? ground->patch_count : 0};
}

murk_status murk_coarse_create(murk_context *context, const murk_solution *solution,
                               const murk_stage *stage, int shift, murk_coarse *out)
{
    murk_coarse made = {.context = context,
                        .solution = solution,
                        .stage = stage,
                        .shift = shift,
                        .around = {M_PI * solution->sky_radiance, solution->horizon}};
    murk_status status = murk_medium_coarsen(context, solution->medium, shift, &made.medium);
    if (!status)
        made.system = murk_coarse_system(&made, NULL);
    murk_vector *vectors[] = {&made.direct, &made.x, &made.r, &made.d};
    for (size_t i = 0; !status && i < sizeof vectors / sizeof *vectors; i++)
        status = murk_vector_create(&made.system, vectors[i]);
    if (status) {
        murk_coarse_clear(&made);
        return status;
    }
    restrict_zones(&made, direct_value, NULL, made.direct.zone);
    for (size_t j = 0; j < made.system.slopes; j++)
        made.direct.slope[j] = murk_stage_direct_slope(stage, solution->medium,
                                                       murk_bent_slot(&stage->bend.zones, j), j);
    for (size_t i = 0; i < made.system.patches; i++)
        made.direct.patch[i] = stage->patch[i];
    *out = made;
    return MURK_OK;
}

void murk_coarse_clear(murk_coarse *coarse)
{
    murk_vector_clear(&coarse->direct);
    murk_vector_clear(&coarse->x);
    murk_vector_clear(&coarse->r);
    murk_vector_clear(&coarse->d);
    murk_preconditioner_release(coarse->system.preconditioner);
    murk_medium_release(coarse->medium);
    memset(coarse, 0, sizeof *coarse);
}

void murk_coarse_begin(murk_coarse *coarse, const murk_solution *start)
{
    const murk_ground *ground = coarse->system.ground;
    restrict_zones(coarse, start_value, start, coarse->x.zone);
    bool same = ground && start->ground && start->ground->patch_count == ground->patch_count;
    for (size_t i = 0; i < coarse->system.patches; i++)
        coarse->x.patch[i] = same ? start->patch[i] : coarse->direct.patch[i];
}
