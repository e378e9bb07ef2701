/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solving by lines on two levels of directions. The equations are solved on a coarse quadrature,
 * and the residual on a fine one is fed back: x += L_coarse^-1 (b - L_fine x). Each correction
 * costs one fine application and cuts the difference by the ratio of the angular error to the
 * solution. The first difference between the levels also tells what the angular error is.
 */
#include "levels.h"

#include "conjugate_gradients.h"
#include "lines.h"
#include "preconditioner.h"
#include "quadrature.h"

#include <math.h>
#include <string.h>

enum { COARSE = MURK_ORBIT, MOST_DIRECTIONS = 64 * MURK_ORBIT };
enum { MOST_CORRECTIONS = 12 };

typedef struct murk_levels {
    murk_context *context;
    const murk_solve_options *options;
    murk_system coarse, fine;
    murk_lines *lines[2];
    murk_vector b, x, r, d;
    murk_outside outside;
    int iterations;
    double angular, iteration; /* estimated relative errors of x */
    double residual;           /* relative, on the fine level before the last correction */
} murk_levels;

static murk_status set_level(murk_levels *levels, const murk_solution *solution, int which,
                             int directions, int rays)
{
    murk_lines_release(levels->lines[which]);
    levels->lines[which] = NULL;
    murk_status status =
        murk_lines_create(levels->context, solution->medium->grid, solution->medium->kappa_t,
                          solution->ground, directions, rays, &levels->lines[which]);
    if (status)
        return status;
    murk_system *system = which ? &levels->fine : &levels->coarse;
    double power = system->power;
    *system = (murk_system){
        .context = levels->context,
        .method = &murk_exchange_lines,
        .state = levels->lines[which],
        .medium = solution->medium,
        .ground = solution->ground,
        .slots = solution->medium->grid->brick_count * MURK_BRICK_SLOTS,
        .patches = solution->ground ? solution->ground->patch_count : 0,
        .power = power,
        .cost = (double)murk_lines_directions(levels->lines[which]) * rays * rays / COARSE,
    };
    return MURK_OK;
}

/* x += L_coarse^-1 (b - L_fine x) until the steps are small; the first step's size is *first. */
static murk_status correct(murk_levels *levels, double goal, double *first)
{
    double before = 0;
    for (int step = 0; step < MOST_CORRECTIONS; step++) {
        murk_status status = murk_system_apply(&levels->fine, &levels->x, &levels->d);
        if (status)
            return status;
        murk_vector_copy(&levels->fine, &levels->b, &levels->r);
        murk_vector_add(&levels->fine, -1, &levels->d, &levels->r);
        double norm = sqrt(murk_vector_norm2(&levels->fine, &levels->x));
        double left = sqrt(murk_vector_norm2(&levels->fine, &levels->r));
        levels->residual = norm > 0 ? left / norm : 0;
        murk_cg_result result;
        status =
            murk_conjugate_gradients(&levels->coarse, &levels->r, &levels->d, 0.1,
                                     0.2 * goal * norm, levels->options->max_iterations, &result);
        if (status)
            return status;
        levels->iterations += result.iterations;
        murk_vector_add(&levels->fine, 1, &levels->d, &levels->x);
        double size = murk_vector_norm2(&levels->fine, &levels->x);
        double change = size > 0 ? sqrt(murk_vector_norm2(&levels->fine, &levels->d) / size) : 0;
        if (!step)
            *first = change;
        double ratio = step && before > 0 ? change / before : 0.25;
        before = change;
        levels->iteration = change * fmin(1, ratio / fmax(1e-3, 1 - ratio));
        if (result.iterations == levels->options->max_iterations && norm > 0)
            levels->iteration += result.error / norm; /* cut short: the step says too little */
        murk_progress(levels->context, "solve",
                      0.5 + 0.4 * fmin(1, log(fmax(change, 1e-12)) / log(fmin(0.5, goal))));
        if (levels->iteration <= goal || (step > 2 && ratio > 0.9))
            break;
    }
    return MURK_OK;
}

/* The solution on the coarse quadrature, with the coarse right-hand side: a scene whose solution
   the quadrature does not matter to is solved by that. */
static murk_status begin(murk_levels *levels, const murk_solution *solution,
                         const murk_stage *stage, double goal)
{
    murk_cg_result result;
    murk_status status =
        murk_source_build(&levels->coarse, solution, stage, &levels->b, &levels->outside);
    if (!status)
        status = murk_conjugate_gradients(&levels->coarse, &levels->b, &levels->x, goal, 0,
                                          levels->options->max_iterations, &result);
    if (!status)
        levels->iterations += result.iterations;
    return status;
}

/* Chooses ever finer quadratures until the angular part fits into the tolerance. */
static murk_status refine(murk_levels *levels, murk_solution *solution, const murk_stage *stage)
{
    const murk_solve_options *o = levels->options;
    double goal = 0.1 * o->tolerance;
    /* A number that is asked for is reached over half of it: the difference of two fine quadratures
       tells more about the error than that to the coarse one. */
    int last = COARSE, directions = (o->tolerance < 0.03 ? 4 : 2) * COARSE;
    if (o->directions)
        directions = o->directions < 8 * COARSE ? o->directions : o->directions / 2;
    murk_status status = begin(levels, solution, stage, goal);
    for (;;) {
        if (!status)
            status = set_level(levels, solution, 1, directions, o->rays);
        if (!status)
            status =
                murk_source_build(&levels->fine, solution, stage, &levels->b, &levels->outside);
        double first = 0;
        if (!status)
            status = correct(levels, goal, &first);
        if (status)
            return status;
        /* Two independent quadratures of n and N directions differ by c sqrt(1/n + 1/N). */
        double fine = murk_lines_directions(levels->lines[1]);
        double c = first / sqrt(1.0 / last + 1 / fine);
        levels->angular = c / sqrt(fine);
        last = (int)fine;
        if (o->directions) {
            if (directions == o->directions)
                return MURK_OK;
            directions = o->directions;
            continue;
        }
        if (levels->angular + levels->iteration <= o->tolerance || fine >= MOST_DIRECTIONS)
            return MURK_OK;
        /* Where the light is smooth the error falls faster than that: no leaps. */
        double needed = pow(c / (0.8 * o->tolerance), 2);
        directions = (int)fmin(MOST_DIRECTIONS, fmin(2 * fine, fmax(needed, 1.5 * fine)));
    }
}

static void report_levels(const murk_levels *levels, murk_report *report)
{
    report->method = "lines";
    report->solver = "conjugate gradients";
    report->kernel = murk_lines_kernel(levels->lines[1]);
    report->directions = murk_lines_directions(levels->lines[1]);
    report->iterations = levels->iterations;
    report->sweeps = (int)ceil(levels->coarse.power + levels->fine.power);
    report->residual = levels->residual;
    report->estimate_angular = levels->angular;
    report->estimate_iteration = levels->iteration;
    report->estimate = levels->angular + levels->iteration;
    report->reached = report->estimate <= report->tolerance;
}

murk_status murk_solve_lines(murk_context *context, murk_solution *solution,
                             const murk_stage *stage, const murk_solve_options *options)
{
    double start = murk_seconds();
    murk_levels levels = {.context = context, .options = options};
    murk_status status = set_level(&levels, solution, 0, COARSE, 1);
    murk_vector *vectors[] = {&levels.b, &levels.x, &levels.r, &levels.d};
    for (size_t i = 0; !status && i < sizeof vectors / sizeof *vectors; i++)
        status = murk_vector_create(&levels.coarse, vectors[i]);
    if (!status)
        status = refine(&levels, solution, stage);
    if (!status) {
        report_levels(&levels, &solution->report);
        double solved = murk_seconds();
        solution->report.seconds_solve = solved - start;
        status = murk_finish(context, solution, stage,
                             &(murk_solved){.zone = levels.x.zone,
                                            .patch = solution->ground ? levels.x.patch : NULL,
                                            .source = levels.b.zone,
                                            .outside = levels.outside,
                                            .directions = murk_lines_directions(levels.lines[1]),
                                            .rays = options->rays});
        solution->report.seconds_finish = murk_seconds() - solved;
    }
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++)
        murk_vector_clear(vectors[i]);
    murk_preconditioner_release(levels.coarse.preconditioner);
    murk_lines_release(levels.lines[0]);
    murk_lines_release(levels.lines[1]);
    if (!status && !solution->report.reached)
        status = murk_fail(context, MURK_NOT_REACHED,
                           "the estimated error is %.2g %%, %.2g %% was asked for: raise "
                           "--directions or the tolerance",
                           100 * solution->report.estimate, 100 * options->tolerance);
    return status;
}
