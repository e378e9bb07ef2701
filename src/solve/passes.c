/* SPDX-License-Identifier: Apache-2.0 */
/* Passes on the zones themselves: residuals with all directions, and their corrections. */
#include "angular.h"
#include "audience.h"
#include "correction.h"
#include "finish.h"
#include "levels_state.h"

#include <math.h>

enum { MOST_PASSES = 8 };

/* What a correction leaves of the error before another has told: measured 0.03 ... 0.15. */
static const double CONTRACTION = 0.2;
/* Passes that contract less than this are given up. */
static const double SLOWEST = 0.9;

/* ---- one pass ------------------------------------------------------------------------------ */

/* Applies the operator to the solutions of some bands. */
static murk_status carry(murk_levels *levels, struct murk_level_band *const band[], int count,
                         double net_power[])
{
    murk_radiosity in[MURK_MOST_BANDS] = {{0}};
    murk_incident out[MURK_MOST_BANDS];
    for (int b = 0; b < count; b++) {
        const murk_coarse *coarse = band[b]->coarse;
        bool ground = band[b]->solution->ground;
        in[b] = (murk_radiosity){.zone = band[b]->solution->radiosity,
                                 .slope = coarse->x.slope,
                                 .patch = ground ? coarse->x.patch : NULL,
                                 .sky = coarse->around.sky,
                                 .horizon = coarse->around.horizon};
        out[b] = (murk_incident){.zone = band[b]->net,
                                 .slope = band[b]->net_slope,
                                 .patch = ground ? band[b]->incident : NULL};
    }
    murk_status status = murk_lines_apply(levels->context, levels->lines, in, out, count);
    for (int b = 0; !status && b < count; b++)
        net_power[b] = out[b].net_power;
    return status;
}

/* Sets r to what is left of a band's equations; gives the norm of x. */
static double find_left(const murk_levels *levels, struct murk_level_band *band)
{
    murk_coarse *coarse = band->coarse;
    murk_coarse_restrict(coarse, band->net, band->net_slope, band->incident, &levels->region);
    double size = sqrt(murk_vector_norm2(&coarse->system, &coarse->x));
    double left = sqrt(murk_vector_norm2(&coarse->system, &coarse->r));
    band->solution->report.residual = size > 0 ? left / size : 0;
    return size;
}

/* Sets a band's solution and x by what has arrived and its correction; gives the change. */
static double renew(const murk_levels *levels, struct murk_level_band *band, double net_power,
                    const murk_correction *spread)
{
    murk_coarse *coarse = band->coarse;
    murk_solution *solution = band->solution;
    murk_correction_add(coarse, spread, &levels->region, band->net);
    for (size_t i = 0; i < coarse->system.patches; i++)
        band->incident[i] += spread->light.patch[i];
    for (size_t j = 0; j < coarse->system.slopes; j++) {
        float albedo = murk_value(&coarse->medium->albedo, murk_bent_slot(coarse->system.bent, j));
        coarse->x.slope[j] =
            coarse->direct.slope[j] +
            albedo * (band->net_slope[j] + coarse->x.slope[j] + spread->light.slope[j]);
    }
    double change = murk_finish(solution, band->stage,
                                &(murk_arrived){.net = band->net,
                                                .incident = band->incident,
                                                .net_power = net_power + spread->net_power,
                                                .diffuse = band->diffuse,
                                                .region = levels->region},
                                false);
    for (size_t i = 0; i < coarse->system.patches; i++)
        coarse->x.patch[i] = solution->patch[i];
    if (!coarse->shift)
        for (size_t b = 0; b < coarse->medium->grid->brick_count; b++)
            for (size_t q = 0; q < 512; q++)
                coarse->x.zone[b * 512 + q] =
                    solution->radiosity[murk_stage_slots(band->stage, b) + q];
    return change;
}

/* One residual on the zones themselves, its correction, and the solution from both, for some of the
   bands. */
static murk_status pass(murk_levels *levels, struct murk_level_band *const band[], int count,
                        double change[])
{
    double net_power[MURK_MOST_BANDS], absolute[MURK_MOST_BANDS];
    murk_coarse *coarse[MURK_MOST_BANDS];
    murk_correction spread[MURK_MOST_BANDS] = {{.net_power = 0}};
    murk_status status = carry(levels, band, count, net_power);
    if (status)
        return status;
    for (int b = 0; b < count; b++) {
        coarse[b] = band[b]->coarse;
        absolute[b] = 0.05 * levels->options->tolerance * find_left(levels, band[b]);
    }
    status = murk_coarse_correct(coarse, absolute, count, levels->options->max_iterations);
    for (int b = 0; !status && b < count; b++)
        status = murk_vector_create(&coarse[b]->system, &spread[b].light);
    if (!status)
        status = murk_correction_spread(coarse, !levels->region.limited, spread, count);
    for (int b = 0; b < count; b++) {
        if (!status)
            change[b] = renew(levels, band[b], net_power[b], &spread[b]);
        murk_vector_clear(&spread[b].light);
    }
    return status;
}

/* ---- all passes ---------------------------------------------------------------------------- */

/* Estimates what the iteration leaves after pass n; whether another would be of use. */
static bool goes_on(const murk_levels *levels, struct murk_level_band *band, int n, double change)
{
    double tolerance = levels->options->tolerance, ratio = CONTRACTION;
    if (!n)
        band->change = change;
    else if (band->last_change > 0)
        ratio = fmin(SLOWEST, change / band->last_change);
    band->iteration = change * ratio / (1 - ratio);
    band->last_change = change;
    double goal = fmax(0.1 * tolerance, tolerance - band->angular - band->spatial);
    return band->iteration > goal && ratio < SLOWEST;
}

static murk_status make_lines(murk_levels *levels)
{
    const struct murk_level_band *any = levels->band;
    if (levels->lines)
        murk_coarse_count(&levels->coarse, levels->lines);
    murk_lines_release(levels->lines);
    levels->lines = NULL;
    murk_status status = murk_lines_create(
        levels->context, any->solution->grid, any->stage->kappa_t, any->solution->ground,
        levels->directions, levels->options->rays, 0, &levels->lines);
    if (status)
        return status;
    murk_lines_limit(levels->lines, &levels->region);
    murk_lines_bend(levels->lines, &any->stage->bend.there);
    return MURK_OK;
}

/* Passes with one number of directions until the iteration of each band that they are for is good
   enough. */
static murk_status passes(murk_levels *levels)
{
    murk_status status = make_lines(levels);
    for (int b = 0; b < levels->count; b++)
        levels->band[b].done = levels->band[b].settled;
    for (int n = 0; !status && n < MOST_PASSES; n++) {
        struct murk_level_band *band[MURK_MOST_BANDS];
        double change[MURK_MOST_BANDS];
        int count = 0;
        for (int b = 0; b < levels->count; b++)
            if (!levels->band[b].done)
                band[count++] = &levels->band[b];
        if (!count)
            break;
        status = pass(levels, band, count, change);
        murk_progress(levels->context, "solve", 1 - 0.5 / (n + 2)); /* one or two are the rule */
        for (int b = 0; !status && b < count; b++)
            band[b]->done = !goes_on(levels, band[b], n, change[b]);
    }
    return status;
}

/* What the camera sees in any band. */
static murk_status find_audience(murk_levels *levels)
{
    const murk_solve_options *o = levels->options;
    murk_status status = MURK_OK;
    for (int b = 0; !status && b < levels->count; b++) {
        murk_region region = {0};
        status = murk_audience(levels->context, levels->band[b].solution, o->camera, o->tolerance,
                               &region);
        levels->region = b ? murk_region_both(&levels->region, &region) : region;
    }
    return status;
}

static murk_status begin(murk_levels *levels)
{
    for (int b = 0; b < levels->count; b++) {
        struct murk_level_band *band = &levels->band[b];
        const murk_grid *grid = band->solution->grid;
        band->net = murk_alloc(grid->brick_count * MURK_BRICK_SLOTS, sizeof(float));
        band->net_slope = murk_alloc(band->coarse->system.slopes, sizeof(float));
        band->incident = murk_alloc(band->coarse->system.patches, sizeof(float));
        if (!band->net || !band->net_slope || !band->incident)
            return murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                             grid->zone_count);
        murk_coarse_prolong(band->coarse, band->solution);
    }
    return levels->options->camera ? find_audience(levels) : MURK_OK;
}

/* Takes the scales from what the first pass changed, and settles the bands that have directions
   enough; whether that is all of them. */
static bool settle(murk_levels *levels)
{
    bool all = true;
    for (int b = 0; b < levels->count; b++)
        if (!levels->band[b].settled)
            levels->band[b].scale =
                murk_angular_scale(levels->band[b].change, levels->last, levels->directions);
    murk_levels_estimate(levels);
    for (int b = 0; b < levels->count; b++) {
        struct murk_level_band *band = &levels->band[b];
        band->settled =
            band->angular <= murk_levels_goal(levels, band) &&
            band->angular + band->spatial + band->iteration <= levels->options->tolerance;
        all = all && band->settled;
    }
    return all;
}

murk_status murk_levels_pass(murk_levels *levels)
{
    murk_status status = begin(levels);
    while (!status) {
        status = passes(levels);
        if (status || levels->coarse.band[0].shift || levels->directions <= levels->last)
            return status;
        int now = levels->directions;
        if (settle(levels) || levels->options->directions || now >= MURK_MOST_DIRECTIONS)
            return MURK_OK;
        levels->last = now;
        levels->directions = murk_levels_needed(levels, now);
    }
    return status;
}
