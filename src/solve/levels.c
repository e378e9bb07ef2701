/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solving by lines: the scattering orders on coarse zones and few directions (see coarse.h), the
 * number of directions that the tolerance needs from what a probe with more of them changes, and
 * then the residual on the zones themselves with that many.
 */
#include "levels.h"

#include "angular.h"
#include "levels_state.h"

#include <math.h>

/* ---- directions ---------------------------------------------------------------------------- */

double murk_levels_goal(const murk_levels *levels, const struct murk_level_band *band)
{
    return murk_angular_goal(levels->options->tolerance, band->spatial);
}

int murk_levels_needed(const murk_levels *levels, int now)
{
    int needed = 0;
    for (int b = 0; b < levels->count; b++) {
        const struct murk_level_band *band = &levels->band[b];
        int own = murk_angular_needed(levels->options->tolerance, murk_levels_goal(levels, band),
                                      band->scale, now);
        needed = !band->settled && own > needed ? own : needed;
    }
    return needed;
}

/* What other lines change of the residual of 48 directions they change of the solution as much as
   the probe's residual did. */
void murk_levels_estimate(murk_levels *levels)
{
    for (int b = 0; b < levels->count; b++) {
        struct murk_level_band *band = &levels->band[b];
        if (band->settled)
            continue;
        band->directions = levels->directions;
        band->angular = band->scale / sqrt(levels->directions);
        band->lattice = fmin(band->angular, band->lattice_48 * band->amplification *
                                                sqrt(0.5 * MURK_ORBIT / levels->directions));
    }
}

murk_status murk_levels_probe(murk_levels *levels, int directions, int rays)
{
    int last = levels->last ? levels->last : MURK_ORBIT;
    murk_probe found[MURK_MOST_BANDS];
    murk_status status = murk_coarse_probe(&levels->coarse, directions, rays,
                                           0.1 * levels->options->tolerance, found);
    for (int b = 0; !status && b < levels->count; b++) {
        struct murk_level_band *band = &levels->band[b];
        band->scale = murk_angular_scale(found[b].change, last, directions);
        if (!levels->last)
            band->amplification = found[b].residual > 0 ? found[b].change / found[b].residual : 0;
        band->diffuse = found[b].diffuse;
    }
    if (!status)
        levels->last = directions;
    return status;
}

/* Probes the coarse solution with ever more directions until there are enough. On the zones
   themselves a probe costs as much as the pass that it is to save, so there one is enough. */
static murk_status choose_directions(murk_levels *levels)
{
    const murk_solve_options *o = levels->options;
    int probe = (o->tolerance < MURK_LOOSE ? 4 : 2) * MURK_ORBIT;
    /* A number that is asked for is reached over half of it: the difference of two fine quadratures
       tells more about the error than that to the coarse one. */
    int asked = (o->directions + MURK_ORBIT - 1) / MURK_ORBIT * MURK_ORBIT;
    if (asked)
        probe = MURK_ORBIT * (asked <= 4 * MURK_ORBIT ? 2 : asked / (2 * MURK_ORBIT));
    for (;;) {
        murk_status status = levels->last ? MURK_OK : murk_levels_probe(levels, probe, o->rays);
        if (!status && levels->directions > levels->last)
            status = murk_levels_probe(levels, levels->directions, o->rays);
        if (status)
            return status;
        levels->directions = asked ? asked : murk_levels_needed(levels, levels->last);
        murk_levels_estimate(levels);
        if (levels->directions <= levels->last || asked || !levels->coarse.band[0].shift)
            return MURK_OK;
    }
}

/* ---- all ----------------------------------------------------------------------------------- */

static void report_band(const murk_levels *levels, const struct murk_level_band *band)
{
    murk_report *report = &band->solution->report;
    const murk_traced *traced = &levels->coarse.traced;
    report->method = "lines";
    report->solver = "conjugate gradients";
    report->kernel = murk_lines_kernel(levels->lines);
    report->directions = band->directions;
    report->iterations = band->coarse->iterations;
    report->crossings = traced->crossings;
    report->crossings_dark = traced->dark;
    report->crossings_unseen = traced->beyond;
    report->seconds_exchange = traced->seconds;
    report->coarsening = 1 << band->coarse->shift;
    double sweep = (double)report->zones * MURK_ORBIT;
    report->sweeps = sweep > 0 ? (int)ceil(report->crossings / sweep) : 0;
    report->estimate_angular = band->angular;
    report->estimate_iteration = band->iteration;
    report->estimate_lattice = band->lattice;
    report->estimate_spatial = band->spatial;
    report->estimate = band->angular + band->spatial + band->iteration;
    report->reached = report->estimate <= report->tolerance;
}

murk_status murk_levels_begin(murk_context *context, murk_solution *const solution[],
                              const murk_stage stage[], int count,
                              const murk_solve_options *options, const murk_solution *const start[],
                              murk_levels **out)
{
    double begun = murk_seconds(), lattice[MURK_MOST_BANDS];
    murk_levels *levels = murk_alloc(1, sizeof *levels);
    if (!levels)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    levels->context = context;
    levels->options = options;
    levels->count = count;
    murk_status status =
        murk_coarse_bands_create(context, solution, stage, count, options, &levels->coarse);
    if (!status)
        status = murk_coarse_solve(&levels->coarse, start, 0.1 * options->tolerance);
    if (!status)
        status = murk_coarse_lattice(&levels->coarse, lattice);
    for (int b = 0; !status && b < count; b++)
        levels->band[b] = (struct murk_level_band){.solution = solution[b],
                                                   .stage = &stage[b],
                                                   .coarse = &levels->coarse.band[b],
                                                   .lattice_48 = lattice[b]};
    levels->before = murk_seconds() - begun;
    if (status)
        murk_levels_release(levels);
    else
        *out = levels;
    return status;
}

void murk_levels_release(murk_levels *levels)
{
    if (!levels)
        return;
    murk_lines_release(levels->lines);
    for (int b = 0; b < levels->count; b++) {
        murk_free(levels->band[b].net);
        murk_free(levels->band[b].net_slope);
        murk_free(levels->band[b].incident);
    }
    murk_coarse_bands_clear(&levels->coarse);
    murk_free(levels);
}

const murk_coarse *murk_levels_coarse(const murk_levels *levels, int band)
{
    return &levels->coarse.band[band];
}

murk_status murk_levels_finish(murk_levels *levels, const double spatial[])
{
    double start = murk_seconds();
    for (int b = 0; b < levels->count; b++)
        levels->band[b].spatial = spatial[b];
    murk_status status = choose_directions(levels);
    murk_progress(levels->context, "solve", 0.5);
    double solved = murk_seconds();
    if (!status)
        status = murk_levels_pass(levels);
    if (status)
        return status;
    murk_coarse_count(&levels->coarse, levels->coarse.lines);
    murk_coarse_count(&levels->coarse, levels->lines);
    double finished = murk_seconds();
    for (int b = 0; b < levels->count; b++) {
        const struct murk_level_band *band = &levels->band[b];
        band->solution->report.seconds_solve = levels->before + solved - start;
        band->solution->report.seconds_finish = finished - solved;
        report_band(levels, band);
        murk_stage_add_lamps(band->stage, 1, band->solution->radiosity);
        murk_stage_add_patch_lamps(band->stage, band->solution);
    }
    return MURK_OK;
}
