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
/* Passes that contract less than this are given up. */
static const double SLOWEST = 0.9;
/* The part of the tolerance that directions and sources within zones may use up together, and the
   least that is left to directions. */
static const double ANGULAR = 0.85, LEAST_ANGULAR = 0.3;
/* Tolerances from here on begin with fewer directions. */
static const double LOOSE = 0.03;

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

static double angular_goal(const murk_levels *levels)
{
    double tolerance = levels->options->tolerance;
    return fmax(ANGULAR * tolerance - levels->spatial, LEAST_ANGULAR * tolerance);
}

/* Independent quadratures of n and N directions differ by c sqrt(1/n + 1/N), and the error of N is
   c / sqrt(N). Gives c from the change from `last` directions to `now`. */
static double angular_scale(double change, int last, int now)
{
    return change / sqrt(1.0 / last + 1.0 / now);
}

/* How many directions the tolerance needs, from those that the last probe had. Where the light is
   smooth the error falls faster than the root: no leaps, and fewer only where little is asked. */
static int needed_directions(const murk_levels *levels, double c, int now)
{
    double goal = angular_goal(levels), needed = pow(c / goal, 2);
    if (c / sqrt(now) <= goal)
        needed = fmax(needed, levels->options->tolerance < LOOSE ? now : 0.5 * now);
    else
        needed = fmin(fmin(2.0 * now, fmax(needed, 1.5 * now)), MOST_DIRECTIONS);
    return (int)ceil(needed / MURK_ORBIT) * MURK_ORBIT;
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
    levels->scale = angular_scale(found.change, last, directions);
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
    int probe = (o->tolerance < LOOSE ? 4 : 2) * MURK_ORBIT;
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
        levels->directions = asked ? asked : needed_directions(levels, levels->scale, levels->last);
        estimate_angular(levels, levels->scale);
        if (levels->directions <= levels->last || asked || !levels->coarse.shift)
            return MURK_OK;
    }
}

/* ---- passes on the zones themselves -------------------------------------------------------- */

/* What the correction brings about: G/4 on the coarse zones stands in place of r. */
typedef struct murk_spread {
    float *slope; /* of G/4 */
    float *patch; /* H */
    double net_power;
} murk_spread;

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

/* Lets the coarse lines carry d, plus the constant that makes the energies balance (coarse-mesh
   rebalance with one cell). */
static murk_status spread_correction(murk_levels *levels, murk_spread *out)
{
    murk_coarse *coarse = &levels->coarse;
    const size_t slots = coarse->system.slots, patches = coarse->system.patches;
    const size_t slopes = coarse->system.slopes;
    bool ground = levels->solution->ground;
    murk_status status = MURK_OK;
    float *one = murk_alloc(slots, sizeof *one), *net_one = murk_alloc(slots, sizeof *net_one);
    float *net = murk_alloc(slots, sizeof *net),
          *patch_one = murk_alloc(patches, sizeof *patch_one);
    float *slope_one = murk_alloc(slopes, sizeof *slope_one);
    if (!one || !net_one || !net || !patch_one || !slope_one)
        status = murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
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
        status = murk_lines_apply(levels->context, coarse->lines, in, arrived, 2);
    if (!status) {
        struct defect defect = find_defect(coarse, net, net_one);
        bool mend = !levels->region.limited && defect.leak > 0;
        float add = mend ? (float)(defect.left / defect.leak) : 0;
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
    murk_spread spread = {.slope = murk_alloc(coarse->system.slopes, sizeof(float)),
                          .patch = murk_alloc(coarse->system.patches, sizeof(float))};
    if (!status && (!spread.slope || !spread.patch))
        status = murk_fail(levels->context, MURK_ERROR_MEMORY, "out of memory for the ground");
    if (!status && !murk_vector_zero(&coarse->system, &coarse->r))
        status = spread_correction(levels, &spread);
    if (!status) {
        add_correction(levels);
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
    murk_free(spread.slope);
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
        double c = angular_scale(levels->change, levels->last, now);
        estimate_angular(levels, c);
        if (o->directions || levels->angular <= angular_goal(levels) || now >= MOST_DIRECTIONS)
            return MURK_OK;
        levels->last = now;
        levels->directions = needed_directions(levels, c, now);
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
