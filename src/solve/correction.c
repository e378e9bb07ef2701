/* SPDX-License-Identifier: Apache-2.0 */
#include "correction.h"

#include "apply.h"
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

/* From what has arrived of d, and of a source of 1 in all zones, net as the operator gives it. */
static void mend_band(const murk_coarse *coarse, const murk_correction *one, bool mend,
                      murk_correction *out)
{
    struct defect defect = find_defect(coarse, out->light.zone, one->light.zone);
    float add = mend && defect.leak > 0 ? (float)(defect.left / defect.leak) : 0;
    for (size_t i = 0; i < coarse->system.slots; i++)
        out->light.zone[i] =
            coarse->medium->kappa_t[i] > 0
                ? out->light.zone[i] + coarse->d.zone[i] + add * (one->light.zone[i] + 1)
                : 0;
    for (size_t j = 0; j < coarse->system.slopes; j++)
        out->light.slope[j] += coarse->d.slope[j] + add * one->light.slope[j];
    for (size_t i = 0; i < coarse->system.patches; i++)
        out->light.patch[i] += add * one->light.patch[i];
    out->net_power += add * one->net_power;
}

murk_status murk_correction_spread(murk_coarse *const band[], bool mend, murk_correction out[],
                                   int count)
{
    const murk_coarse *any = band[0];
    const murk_system *system = &any->system;
    murk_radiosity in[MURK_MOST_BANDS + 1] = {{0}};
    murk_incident arrived[MURK_MOST_BANDS + 1];
    int spread[MURK_MOST_BANDS], n = 0;
    for (int b = 0; b < count; b++) {
        if (murk_vector_zero(&band[b]->system, &band[b]->r))
            continue;
        in[n] = murk_system_sent(system, &band[b]->d);
        arrived[n] = murk_system_arriving(system, &out[b].light);
        spread[n++] = b;
    }
    if (!n)
        return MURK_OK;
    murk_correction of_one = {.net_power = 0};
    float *one = murk_alloc(system->slots, sizeof *one);
    murk_status status = murk_vector_create(system, &of_one.light);
    if (!status && !one)
        status = murk_fail(any->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           any->medium->grid->zone_count);
    for (size_t i = 0; !status && i < system->slots; i++)
        one[i] = any->medium->kappa_t[i] > 0;
    in[n] = (murk_radiosity){.zone = one};
    arrived[n] = murk_system_arriving(system, &of_one.light);
    if (!status)
        status = murk_apply(any->context, system->method, system->state, in, arrived, n + 1);
    of_one.net_power = arrived[n].net_power;
    for (int i = 0; !status && i < n; i++) {
        out[spread[i]].net_power = arrived[i].net_power;
        mend_band(band[spread[i]], &of_one, mend, &out[spread[i]]);
    }
    murk_free(one);
    murk_vector_clear(&of_one.light);
    return status;
}

void murk_correction_add(const murk_coarse *coarse, const murk_correction *correction,
                         const murk_region *region, float *net)
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
            float more = correction->light.zone[slots[s]];
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
