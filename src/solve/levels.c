/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solving by lines: the scattering orders on coarse zones and few directions (see coarse.h), the
 * number of directions that the tolerance needs from what a probe with more of them changes, and
 * then the residual on the zones themselves with that many.
 */
#include "levels.h"

#include "angular.h"
#include "audience.h"
#include "correction.h"
#include "finish.h"

#include <math.h>

enum { MOST_PASSES = 8 };

/* What a correction leaves of the error before another has told: measured 0.03 ... 0.15. */
static const double CONTRACTION = 0.2;
/* Passes that contract less than this are given up. */
static const double SLOWEST = 0.9;

struct murk_levels {
    murk_context *context;
    const murk_solve_options *options;
    murk_solution *solution;
    const murk_stage *stage;
    murk_coarse coarse;
    murk_lines *lines;    /* on the solution's grid */
    float *net;           /* on that grid */
    float *net_slope;     /* of its bent bricks */
    float *incident;      /* of the patches */
    murk_region region;   /* what is asked for */
    int directions, last; /* of the passes on the zones, and of the last probe or 0 */
    double scale;         /* the angular error of N directions is scale / sqrt(N) */
    double diffuse;       /* light of sky and ground that the medium takes, by the last probe [W] */
    double change;        /* by the first pass with these directions */
    double angular, lattice, iteration; /* estimated relative errors */
    double lattice_48;                  /* relative residual of 48 directions with other lines */
    double amplification;               /* of residuals of the angular error in the solution */
    double spatial;                     /* the same, given */
    double before;                      /* seconds spent until the coarse solution was there */
};

/* ---- directions ---------------------------------------------------------------------------- */

static double goal_of(const murk_levels *levels)
{
    return murk_angular_goal(levels->options->tolerance, levels->spatial);
}

/* Sets the estimates for levels->directions. What other lines change of the residual of 48
   directions they change of the solution as much as the probe's residual did. */
static void estimate_angular(murk_levels *levels, double c)
{
    levels->angular = c / sqrt(levels->directions);
    levels->lattice = fmin(levels->angular, levels->lattice_48 * levels->amplification *
                                                sqrt(0.5 * MURK_ORBIT / levels->directions));
}

murk_status murk_levels_probe(murk_levels *levels, int directions, int rays)
{
    int last = levels->last ? levels->last : MURK_ORBIT;
    murk_probe found;
    murk_status status = murk_coarse_probe(&levels->coarse, directions, rays,
                                           0.1 * levels->options->tolerance, &found);
    if (status)
        return status;
    levels->scale = murk_angular_scale(found.change, last, directions);
    if (!levels->last)
        levels->amplification = found.residual > 0 ? found.change / found.residual : 0;
    levels->diffuse = found.diffuse;
    levels->last = directions;
    return MURK_OK;
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
        levels->directions =
            asked ? asked
                  : murk_angular_needed(o->tolerance, goal_of(levels), levels->scale, levels->last);
        estimate_angular(levels, levels->scale);
        if (levels->directions <= levels->last || asked || !levels->coarse.shift)
            return MURK_OK;
    }
}

/* ---- passes on the zones themselves -------------------------------------------------------- */

/* One residual on the zones themselves, its correction, and the solution from both. */
static murk_status pass(murk_levels *levels, double *change)
{
    murk_coarse *coarse = &levels->coarse;
    murk_solution *solution = levels->solution;
    bool ground = solution->ground;
    const murk_radiosity in = {.zone = solution->radiosity,
                               .slope = coarse->x.slope,
                               .patch = ground ? coarse->x.patch : NULL,
                               .sky = coarse->around.sky,
                               .horizon = coarse->around.horizon};
    murk_incident out = {
        .zone = levels->net, .slope = levels->net_slope, .patch = ground ? levels->incident : NULL};
    murk_status status = murk_lines_apply(levels->context, levels->lines, &in, &out, 1);
    if (status)
        return status;
    murk_coarse_restrict(coarse, levels->net, levels->net_slope, levels->incident, &levels->region);
    double size = sqrt(murk_vector_norm2(&coarse->system, &coarse->x));
    double left = sqrt(murk_vector_norm2(&coarse->system, &coarse->r));
    solution->report.residual = size > 0 ? left / size : 0;
    status = murk_coarse_correct(coarse, 0.05 * levels->options->tolerance * size);
    murk_correction spread;
    murk_status made = murk_correction_create(coarse, &spread);
    status = status ? status : made;
    if (!status && !murk_vector_zero(&coarse->system, &coarse->r))
        status = murk_correction_spread(coarse, !levels->region.limited, &spread);
    if (!status) {
        murk_correction_add(coarse, &levels->region, levels->net);
        for (size_t i = 0; i < coarse->system.patches; i++)
            levels->incident[i] += spread.patch[i];
        for (size_t j = 0; j < coarse->system.slopes; j++) {
            float albedo =
                murk_value(&coarse->medium->albedo, murk_bent_slot(coarse->system.bent, j));
            coarse->x.slope[j] =
                coarse->direct.slope[j] +
                albedo * (levels->net_slope[j] + coarse->x.slope[j] + spread.slope[j]);
        }
        *change = murk_finish(solution, levels->stage,
                              &(murk_arrived){.net = levels->net,
                                              .incident = levels->incident,
                                              .net_power = out.net_power + spread.net_power,
                                              .diffuse = levels->diffuse,
                                              .region = levels->region},
                              false);
        for (size_t i = 0; i < coarse->system.patches; i++)
            coarse->x.patch[i] = solution->patch[i];
        if (!coarse->shift)
            for (size_t b = 0; b < coarse->medium->grid->brick_count; b++)
                for (size_t q = 0; q < 512; q++)
                    coarse->x.zone[b * 512 + q] =
                        solution->radiosity[murk_stage_slots(levels->stage, b) + q];
    }
    murk_correction_clear(&spread);
    return status;
}

/* Passes with one number of directions until the iteration is good enough. */
static murk_status passes(murk_levels *levels)
{
    const murk_solve_options *o = levels->options;
    const murk_solution *solution = levels->solution;
    if (levels->lines)
        murk_coarse_count(&levels->coarse, levels->lines);
    murk_lines_release(levels->lines);
    levels->lines = NULL;
    murk_status status =
        murk_lines_create(levels->context, solution->grid, levels->stage->kappa_t, solution->ground,
                          levels->directions, o->rays, 0, &levels->lines);
    if (!status) {
        murk_lines_limit(levels->lines, &levels->region);
        murk_lines_bend(levels->lines, &levels->stage->bend.there);
    }
    double before = 0;
    for (int n = 0; !status && n < MOST_PASSES; n++) {
        double change = 0, ratio = CONTRACTION;
        status = pass(levels, &change);
        if (!n)
            levels->change = change;
        else if (before > 0)
            ratio = fmin(SLOWEST, change / before);
        levels->iteration = change * ratio / (1 - ratio);
        before = change;
        murk_progress(levels->context, "solve", 1 - 0.5 / (n + 2)); /* one or two are the rule */
        double goal = fmax(0.1 * o->tolerance, o->tolerance - levels->angular - levels->spatial);
        if (levels->iteration <= goal || ratio >= SLOWEST)
            break;
    }
    return status;
}

static murk_status finish(murk_levels *levels)
{
    const murk_grid *grid = levels->solution->grid;
    levels->net = murk_alloc(grid->brick_count * MURK_BRICK_SLOTS, sizeof(float));
    levels->net_slope = murk_alloc(levels->coarse.system.slopes, sizeof(float));
    levels->incident = murk_alloc(levels->coarse.system.patches, sizeof(float));
    if (!levels->net || !levels->net_slope || !levels->incident)
        return murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                         grid->zone_count);
    murk_coarse_prolong(&levels->coarse, levels->solution);
    const murk_solve_options *o = levels->options;
    murk_status status = MURK_OK;
    if (o->camera)
        status = murk_audience(levels->context, levels->solution, o->camera, o->tolerance,
                               &levels->region);
    while (!status) {
        status = passes(levels);
        if (status || levels->coarse.shift || levels->directions <= levels->last)
            return status;
        int now = levels->directions;
        double c = murk_angular_scale(levels->change, levels->last, now);
        estimate_angular(levels, c);
        if (o->directions || levels->angular <= goal_of(levels) || now >= MURK_MOST_DIRECTIONS)
            return MURK_OK;
        levels->last = now;
        levels->directions = murk_angular_needed(o->tolerance, goal_of(levels), c, now);
    }
    return status;
}

/* ---- all ----------------------------------------------------------------------------------- */

static void report_levels(murk_levels *levels, murk_report *report)
{
    murk_coarse *coarse = &levels->coarse;
    murk_coarse_count(coarse, coarse->lines);
    murk_coarse_count(coarse, levels->lines);
    report->method = "lines";
    report->solver = "conjugate gradients";
    report->kernel = murk_lines_kernel(levels->lines);
    report->directions = levels->directions;
    report->iterations = coarse->iterations;
    report->crossings = coarse->traced.crossings;
    report->crossings_dark = coarse->traced.dark;
    report->crossings_unseen = coarse->traced.beyond;
    report->seconds_exchange = coarse->traced.seconds;
    report->coarsening = 1 << coarse->shift;
    double sweep = (double)report->zones * MURK_ORBIT;
    report->sweeps = sweep > 0 ? (int)ceil(report->crossings / sweep) : 0;
    report->estimate_angular = levels->angular;
    report->estimate_iteration = levels->iteration;
    report->estimate_lattice = levels->lattice;
    report->estimate_spatial = levels->spatial;
    report->estimate = levels->angular + levels->spatial + levels->iteration;
    report->reached = report->estimate <= report->tolerance;
}

murk_status murk_levels_begin(murk_context *context, murk_solution *solution,
                              const murk_stage *stage, const murk_solve_options *options,
                              const murk_solution *start, murk_levels **out)
{
    double begun = murk_seconds();
    murk_levels *levels = murk_alloc(1, sizeof *levels);
    if (!levels)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    levels->context = context;
    levels->options = options;
    levels->solution = solution;
    levels->stage = stage;
    murk_status status = murk_coarse_create(context, solution, stage, options, &levels->coarse);
    if (!status)
        status = murk_coarse_solve(&levels->coarse, start, 0.1 * options->tolerance);
    if (!status)
        status = murk_coarse_lattice(&levels->coarse, &levels->lattice_48);
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
    murk_free(levels->net);
    murk_free(levels->net_slope);
    murk_free(levels->incident);
    murk_coarse_clear(&levels->coarse);
    murk_free(levels);
}

murk_coarse *murk_levels_coarse(murk_levels *levels)
{
    return &levels->coarse;
}

murk_status murk_levels_finish(murk_levels *levels, double spatial)
{
    double start = murk_seconds();
    levels->spatial = spatial;
    murk_status status = choose_directions(levels);
    murk_progress(levels->context, "solve", 0.5);
    double solved = murk_seconds();
    if (!status)
        status = finish(levels);
    if (!status) {
        murk_report *report = &levels->solution->report;
        report->seconds_solve = levels->before + solved - start;
        report->seconds_finish = murk_seconds() - solved;
        report_levels(levels, report);
        murk_stage_add_lamps(levels->stage, 1, levels->solution->radiosity);
        murk_stage_add_patch_lamps(levels->stage, levels->solution);
    }
    return status;
}
