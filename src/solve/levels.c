/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solving by lines: the scattering orders on coarse zones and few directions (see coarse.h), the
 * number of directions that the tolerance needs from what a probe with more of them changes, and
 * then the residual on the zones themselves with that many.
 */
#include "levels.h"

#include "audience.h"
#include "coarse.h"
#include "coarsen.h"
#include "finish.h"
#include "quadrature.h"

#include <math.h>

enum { MOST_DIRECTIONS = 64 * MURK_ORBIT, MOST_PASSES = 8 };

/* What a correction leaves of the error before another has told: measured 0.03 ... 0.15. */
static const double CONTRACTION = 0.2;
/* The part of the tolerance that directions may use up. */
static const double ANGULAR = 0.75;

typedef struct murk_levels {
    murk_context *context;
    const murk_solve_options *options;
    murk_solution *solution;
    const murk_stage *stage;
    murk_coarse coarse;
    murk_lines *lines;    /* on the solution's grid */
    float *net;           /* on that grid */
    float *incident;      /* of the patches */
    murk_region region;   /* what is asked for */
    int directions, last; /* of the passes on the zones, and of the last probe */
    double diffuse;       /* light of sky and ground that the medium takes, by the last probe [W] */
    double change;        /* by the first pass with these directions */
    double angular, iteration; /* estimated relative errors */
} murk_levels;

/* ---- directions ---------------------------------------------------------------------------- */

/* Independent quadratures of n and N directions differ by c sqrt(1/n + 1/N), and the error of N is
   c / sqrt(N). Sets the estimate for levels->directions by the change from `last` directions to
   `now`, and gives how many the tolerance needs. Where the light is smooth the error falls faster
   than that: no leaps. */
static int estimate_angular(murk_levels *levels, double change, int last, int now)
{
    double c = change / sqrt(1.0 / last + 1.0 / now), goal = ANGULAR * levels->options->tolerance;
    levels->angular = c / sqrt(levels->directions);
    if (levels->options->directions || levels->angular <= goal)
        return levels->directions;
    double needed = fmin(2.0 * now, fmax(pow(c / goal, 2), 1.5 * now));
    int orbits = (int)ceil(fmin(needed, MOST_DIRECTIONS) / MURK_ORBIT);
    return orbits * MURK_ORBIT;
}

/* Probes the coarse solution with ever more directions until there are enough. On the zones
   themselves a probe costs as much as the pass that it is to save, so there one is enough. */
static murk_status choose_directions(murk_levels *levels)
{
    const murk_solve_options *o = levels->options;
    int last = MURK_ORBIT, probe = (o->tolerance < 0.03 ? 4 : 2) * MURK_ORBIT;
    /* A number that is asked for is reached over half of it: the difference of two fine quadratures
       tells more about the error than that to the coarse one. */
    int asked = (o->directions + MURK_ORBIT - 1) / MURK_ORBIT * MURK_ORBIT;
    if (asked)
        probe = MURK_ORBIT * (asked <= 4 * MURK_ORBIT ? 2 : asked / (2 * MURK_ORBIT));
    for (;;) {
        double change = 0;
        murk_status status = murk_coarse_probe(&levels->coarse, probe, o->rays, 0.1 * o->tolerance,
                                               &change, &levels->diffuse);
        if (status)
            return status;
        levels->directions = asked ? asked : probe;
        int needed = estimate_angular(levels, change, last, probe);
        levels->last = probe;
        levels->directions = needed;
        if (needed <= probe || asked || !levels->coarse.shift)
            return MURK_OK;
        last = probe;
        probe = needed;
    }
}

/* ---- passes on the zones themselves -------------------------------------------------------- */

/* What the correction brings about: G/4 on the coarse zones stands in place of r. */
typedef struct murk_spread {
    float *patch; /* H */
    double net_power;
} murk_spread;

/* Sums of kappa_t over the coarse zones. */
struct defect {
    double left; /* of r - L d: what emission and incidence differ by from absorption and escape */
    double leak; /* of L 1 */
    double size; /* of x */
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
        sum.size += kappa_t * fabsf(coarse->x.zone[i]);
    }
    return sum;
}

/* Lets the coarse lines carry d, plus the constant that makes the energies balance (coarse-mesh
   rebalance with one cell); below the rounding of x there is nothing to mend. */
static murk_status spread_correction(murk_levels *levels, murk_spread *out)
{
    static const double ROUNDING = 3e-7;
    murk_coarse *coarse = &levels->coarse;
    const size_t slots = coarse->system.slots, patches = coarse->system.patches;
    bool ground = levels->solution->ground;
    murk_status status = MURK_OK;
    float *one = murk_alloc(slots, sizeof *one), *net_one = murk_alloc(slots, sizeof *net_one);
    float *net = murk_alloc(slots, sizeof *net),
          *patch_one = murk_alloc(patches, sizeof *patch_one);
    if (!one || !net_one || !net || !patch_one)
        status = murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           coarse->medium->grid->zone_count);
    for (size_t i = 0; !status && i < slots; i++)
        one[i] = coarse->medium->kappa_t[i] > 0;
    const murk_radiosity in[2] = {
        {.zone = coarse->d.zone, .patch = ground ? coarse->d.patch : NULL}, {.zone = one}};
    murk_incident arrived[2] = {{.zone = net, .patch = ground ? out->patch : NULL},
                                {.zone = net_one, .patch = ground ? patch_one : NULL}};
    if (!status)
        status = murk_lines_apply(levels->context, coarse->lines, in, arrived, 2);
    if (!status) {
        struct defect defect = find_defect(coarse, net, net_one);
        bool mend = !levels->region.limited && defect.leak > 0 &&
                    fabs(defect.left) > ROUNDING * defect.size;
        float add = mend ? (float)(defect.left / defect.leak) : 0;
        for (size_t i = 0; i < slots; i++)
            coarse->r.zone[i] = coarse->medium->kappa_t[i] > 0
                                    ? net[i] + coarse->d.zone[i] + add * (net_one[i] + 1)
                                    : 0;
        for (size_t i = 0; i < patches; i++)
            out->patch[i] += add * patch_one[i];
        out->net_power = arrived[0].net_power + add * arrived[1].net_power;
    }
    murk_free(one);
    murk_free(net_one);
    murk_free(net);
    murk_free(patch_one);
    return status;
}

/* Adds the correction to the light of the zones, and to that of the margin in proportion. */
static void add_correction(murk_levels *levels)
{
    const murk_coarse *coarse = &levels->coarse;
    const murk_medium *medium = levels->solution->medium;
    const murk_stage *stage = levels->stage;
    const murk_grid *grid = levels->solution->grid;
    double all_added = 0, all_light = 0;
    float *ratio = murk_alloc(grid->brick_count, sizeof *ratio);
#pragma omp parallel for num_threads(levels->context->threads) schedule(static)                    \
    reduction(+ : all_added, all_light)
    for (size_t b = 0; b < medium->grid->brick_count; b++) {
        size_t slots[MURK_BRICK_SLOTS], i = b * MURK_BRICK_SLOTS, o = murk_stage_slots(stage, b);
        double added = 0, light = 0;
        if (!murk_region_has(&levels->region, medium->grid->brick[b]))
            continue; /* net does not hold there */
        murk_coarse_slots(medium->grid, coarse->medium->grid, coarse->shift, b, slots);
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++) {
            float kappa_t = medium->kappa_t[i + s];
            if (!(kappa_t > 0))
                continue;
            float more = coarse->r.zone[slots[s]];
            light += kappa_t * (levels->net[o + s] + levels->solution->radiosity[o + s]);
            added += kappa_t * more;
            levels->net[o + s] += more;
        }
        if (ratio)
            ratio[stage->map[b]] = light > 0 ? (float)(added / light) : 0;
        all_added += added;
        all_light += light;
    }
    float mean = all_light > 0 ? (float)(all_added / all_light) : 0;
#pragma omp parallel for num_threads(levels->context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++) {
        float r = ratio && ratio[b] != 0 && fabsf(ratio[b]) < 0.5f ? ratio[b] : mean;
        for (size_t o = b * MURK_BRICK_SLOTS; o < (b + 1) * MURK_BRICK_SLOTS; o++)
            if (!(stage->kappa_t[o] > 0))
                levels->net[o] += r * (levels->net[o] + levels->solution->radiosity[o]);
    }
    murk_free(ratio);
}

/* One residual on the zones themselves, its correction, and the solution from both. */
static murk_status pass(murk_levels *levels, double *change)
{
    murk_coarse *coarse = &levels->coarse;
    murk_solution *solution = levels->solution;
    bool ground = solution->ground;
    const murk_radiosity in = {.zone = solution->radiosity,
                               .patch = ground ? coarse->x.patch : NULL,
                               .sky = coarse->around.sky,
                               .horizon = coarse->around.horizon};
    murk_incident out = {.zone = levels->net, .patch = ground ? levels->incident : NULL};
    murk_status status = murk_lines_apply(levels->context, levels->lines, &in, &out, 1);
    if (status)
        return status;
    murk_coarse_restrict(coarse, levels->net, levels->incident, &levels->region);
    double size = sqrt(murk_vector_norm2(&coarse->system, &coarse->x));
    double left = sqrt(murk_vector_norm2(&coarse->system, &coarse->r));
    solution->report.residual = size > 0 ? left / size : 0;
    status = murk_coarse_correct(coarse, 0.05 * levels->options->tolerance * size);
    murk_spread spread = {.patch = murk_alloc(coarse->system.patches, sizeof(float))};
    if (!status && !spread.patch)
        status = murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for the ground");
    if (!status && !murk_vector_zero(&coarse->system, &coarse->r))
        status = spread_correction(levels, &spread);
    if (!status) {
        add_correction(levels);
        for (size_t i = 0; i < coarse->system.patches; i++)
            levels->incident[i] += spread.patch[i];
        *change = murk_finish(solution, levels->stage,
                              &(murk_arrived){.net = levels->net,
                                              .incident = levels->incident,
                                              .net_power = out.net_power + spread.net_power,
                                              .diffuse = levels->diffuse,
                                              .region = levels->region},
                              false);
        for (size_t i = 0; i < coarse->system.patches; i++)
            coarse->x.patch[i] = solution->patch[i];
    }
    murk_free(spread.patch);
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
                          levels->directions, o->rays, &levels->lines);
    if (!status)
        murk_lines_limit(levels->lines, &levels->region);
    double before = 0;
    for (int n = 0; !status && n < MOST_PASSES; n++) {
        double change = 0, ratio = CONTRACTION;
        status = pass(levels, &change);
        if (!n)
            levels->change = change;
        else if (before > 0)
            ratio = fmin(0.99, change / before);
        levels->iteration = change * ratio / (1 - ratio);
        before = change;
        murk_progress(levels->context, "solve", 1 - 0.5 / (n + 2)); /* one or two are the rule */
        double goal = fmax(0.1 * o->tolerance, o->tolerance - levels->angular);
        if (levels->iteration <= goal || ratio > 0.9)
            break;
    }
    return status;
}

static murk_status finish(murk_levels *levels)
{
    const murk_grid *grid = levels->solution->grid;
    levels->net = murk_alloc(grid->brick_count * MURK_BRICK_SLOTS, sizeof(float));
    levels->incident = murk_alloc(levels->coarse.system.patches, sizeof(float));
    if (!levels->net || !levels->incident)
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
        int now = levels->directions,
            needed = estimate_angular(levels, levels->change, levels->last, now);
        if (needed <= now)
            return MURK_OK;
        levels->last = now;
        levels->directions = needed;
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
    report->estimate = levels->angular + levels->iteration;
    report->reached = report->estimate <= report->tolerance;
}

murk_status murk_solve_lines(murk_context *context, murk_solution *solution,
                             const murk_stage *stage, const murk_solve_options *options)
{
    double start = murk_seconds();
    murk_levels levels = {
        .context = context, .options = options, .solution = solution, .stage = stage};
    murk_status status = murk_coarse_create(context, solution, stage, options, &levels.coarse);
    if (!status)
        status = murk_coarse_solve(&levels.coarse, options->start, 0.1 * options->tolerance);
    murk_progress(context, "solve", 0.3);
    if (!status)
        status = choose_directions(&levels);
    murk_progress(context, "solve", 0.5);
    double solved = murk_seconds();
    if (!status)
        status = finish(&levels);
    if (!status) {
        solution->report.seconds_solve = solved - start;
        solution->report.seconds_finish = murk_seconds() - solved;
        report_levels(&levels, &solution->report);
        murk_stage_add_lamps(stage, 1, solution->radiosity);
        murk_stage_add_patch_lamps(stage, solution);
    }
    murk_lines_release(levels.lines);
    murk_free(levels.net);
    murk_free(levels.incident);
    murk_coarse_clear(&levels.coarse);
    if (!status && !solution->report.reached)
        status = murk_fail(context, MURK_NOT_REACHED,
                           "the estimated error is %.2g %%, %.2g %% was asked for: raise "
                           "--directions or the tolerance",
                           100 * solution->report.estimate, 100 * options->tolerance);
    return status;
}
