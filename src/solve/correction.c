/* SPDX-License-Identifier: Apache-2.0 */
#include "correction.h"

#include "coarsen.h"

#include <math.h>

/* Sums of kappa_t over the coarse zones. */
struct defect {
    double left; /* of r - L d: what emission and incidence differ by from absorption and escape */
    double leak; /* of L 1 */
};

static struct defect find_defect(const murk_coarse *coarse, const float *net, const float *net_one)
{
    const murk_medium *medium = coarse->medium;
    struct defect sum = {0};
    for (size_t i = 0; i < coarse->system.slots; i++) {
        double kappa_t = medium->kappa_t[i], albedo = murk_value(&medium->albedo, i);
        if (!(kappa_t > 0))
            continue;
        sum.left +=
            kappa_t * (coarse->r.zone[i] + albedo * net[i] - (1 - albedo) * coarse->d.zone[i]);
        sum.leak += kappa_t * (1 - albedo - albedo * net_one[i]);
    }
    return sum;
}

murk_status murk_correction_spread(murk_coarse *coarse, bool mend, murk_correction *out)
{
    const size_t slots = coarse->system.slots, patches = coarse->system.patches;
    const size_t slopes = coarse->system.slopes;
    bool ground = coarse->solution->ground;
    murk_status status = MURK_OK;
    float *one = murk_alloc(slots, sizeof *one), *net_one = murk_alloc(slots, sizeof *net_one);
    float *net = murk_alloc(slots, sizeof *net),
          *patch_one = murk_alloc(patches, sizeof *patch_one);
    float *slope_one = murk_alloc(slopes, sizeof *slope_one);
    if (!one || !net_one || !net || !patch_one || !slope_one)
        status = murk_fail(coarse->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           coarse->medium->grid->zone_count);
    for (size_t i = 0; !status && i < slots; i++)
        one[i] = coarse->medium->kappa_t[i] > 0;
    const murk_radiosity in[2] = {{.zone = coarse->d.zone,
                                   .slope = coarse->d.slope,
                                   .patch = ground ? coarse->d.patch : NULL},
                                  {.zone = one}};
    murk_incident arrived[2] = {
        {.zone = net, .slope = out->slope, .patch = ground ? out->patch : NULL},
        {.zone = net_one, .slope = slope_one, .patch = ground ? patch_one : NULL}};
    if (!status)
        status = murk_lines_apply(coarse->context, coarse->lines, in, arrived, 2);
    if (!status) {
        struct defect defect = find_defect(coarse, net, net_one);
        float add = mend && defect.leak > 0 ? (float)(defect.left / defect.leak) : 0;
        for (size_t i = 0; i < slots; i++)
            coarse->r.zone[i] = coarse->medium->kappa_t[i] > 0
                                    ? net[i] + coarse->d.zone[i] + add * (net_one[i] + 1)
                                    : 0;
        for (size_t j = 0; j < slopes; j++)
            out->slope[j] += coarse->d.slope[j] + add * slope_one[j];
        for (size_t i = 0; i < patches; i++)
            out->patch[i] += add * patch_one[i];
        out->net_power = arrived[0].net_power + add * arrived[1].net_power;
    }
    murk_free(one);
    murk_free(net_one);
    murk_free(net);
    murk_free(patch_one);
    murk_free(slope_one);
    return status;
}

void murk_correction_add(const murk_coarse *coarse, const murk_region *region, float *net)
{
    const murk_solution *solution = coarse->solution;
    const murk_medium *medium = solution->medium;
    const murk_stage *stage = coarse->stage;
    const murk_grid *grid = solution->grid;
    double all_added = 0, all_light = 0;
    float *ratio = murk_alloc(grid->brick_count, sizeof *ratio);
#pragma omp parallel for num_threads(coarse->context->threads) schedule(static)                    \
    reduction(+ : all_added, all_light)
    for (size_t b = 0; b < medium->grid->brick_count; b++) {
        size_t slots[MURK_BRICK_SLOTS], i = b * MURK_BRICK_SLOTS, o = murk_stage_slots(stage, b);
        double added = 0, light = 0;
        if (!murk_region_has(region, medium->grid->brick[b]))
            continue; /* net does not hold there */
        murk_coarse_slots(medium->grid, coarse->medium->grid, coarse->shift, b, slots);
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++) {
            float kappa_t = medium->kappa_t[i + s];
            if (!(kappa_t > 0))
                continue;
            float more = coarse->r.zone[slots[s]];
            light += kappa_t * (net[o + s] + solution->radiosity[o + s]);
            added += kappa_t * more;
            net[o + s] += more;
        }
        if (ratio)
            ratio[stage->map[b]] = light > 0 ? (float)(added / light) : 0;
        all_added += added;
        all_light += light;
    }
    float mean = all_light > 0 ? (float)(all_added / all_light) : 0;
#pragma omp parallel for num_threads(coarse->context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++) {
        float r = ratio && ratio[b] != 0 && fabsf(ratio[b]) < 0.5f ? ratio[b] : mean;
        for (size_t o = b * MURK_BRICK_SLOTS; o < (b + 1) * MURK_BRICK_SLOTS; o++)
            if (!(stage->kappa_t[o] > 0))
                net[o] += r * (net[o] + solution->radiosity[o]);
    }
    murk_free(ratio);
}

murk_status murk_correction_create(const murk_coarse *coarse, murk_correction *out)
{
    *out = (murk_correction){.slope = murk_alloc(coarse->system.slopes, sizeof(float)),
                             .patch = murk_alloc(coarse->system.patches, sizeof(float))};
    return out->slope && out->patch
               ? MURK_OK
               : murk_fail(coarse->context, MURK_ERROR_MEMORY, "out of memory for the ground");
}

void murk_correction_clear(murk_correction *correction)
{
    murk_free(correction->slope);
    murk_free(correction->patch);
}
