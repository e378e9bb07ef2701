/* SPDX-License-Identifier: Apache-2.0 */
/* Solving with the stored factors of `pairwise`: the paper's way, or conjugate gradients. */
#include "levels.h"

#include "conjugate_gradients.h"
#include "finish.h"
#include "gauss_seidel.h"
#include "lines.h"
#include "pairwise.h"
#include "preconditioner.h"
#include "residual.h"

#include <math.h>
#include <string.h>

/* Fields to and from the compact numbering of zones, then patches. */
static void compact(const murk_system *system, const murk_vector *from, double *to)
{
    const murk_grid *grid = system->medium->grid;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int s = 0; s < MURK_BRICK_SLOTS; s++)
            if (murk_grid_active(grid, b, s))
                *to++ = from->zone[b * MURK_BRICK_SLOTS + (size_t)s];
    for (size_t i = 0; i < system->patches; i++)
        *to++ = from->patch[i];
}

static void expand(const murk_system *system, const double *from, murk_vector *to)
{
    const murk_grid *grid = system->medium->grid;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int s = 0; s < MURK_BRICK_SLOTS; s++)
            if (murk_grid_active(grid, b, s))
                to->zone[b * MURK_BRICK_SLOTS + (size_t)s] = (float)*from++;
    for (size_t i = 0; i < system->patches; i++)
        to->patch[i] = (float)*from++;
}

static murk_status gauss_seidel(const murk_system *system, const murk_solve_options *options,
                                const murk_vector *b, murk_vector *x, murk_report *report)
{
    size_t count = system->medium->grid->zone_count + system->patches;
    double *source = murk_alloc(count, sizeof *source), *value = murk_alloc(count, sizeof *value);
    murk_status status;
    if (!source || !value) {
        status =
            murk_fail(system->context, MURK_ERROR_MEMORY, "out of memory for %zu elements", count);
    } else {
        compact(system, b, source);
        memcpy(value, source, count * sizeof *value);
        double change = 0;
        status = murk_gauss_seidel(system->context, system->method, system->state, system->medium,
                                   system->ground, source, options->epsilon,
                                   options->max_iterations, value, &report->iterations, &change);
        if (!status) {
            expand(system, value, x);
            double largest = 0;
            for (size_t i = 0; i < count; i++)
                largest = fmax(largest, value[i]);
            report->residual = largest > 0 ? change / largest : 0;
            report->estimate_iteration = report->residual;
            report->reached = change < options->epsilon;
        }
    }
    murk_free(source);
    murk_free(value);
    return status;
}

static murk_status gradients(murk_system *system, const murk_solve_options *options,
                             const murk_vector *b, murk_vector *x, murk_report *report)
{
    murk_cg cg = {.system = system, .b = b, .x = x, .relative = 0.1 * options->tolerance};
    murk_status status = murk_conjugate_gradients(&cg, 1, options->max_iterations);
    if (status)
        return status;
    report->iterations = cg.result.iterations;
    report->residual = cg.result.residual;
    report->estimate_iteration = cg.result.norm > 0 ? cg.result.error / cg.result.norm : 0;
    report->reached = report->estimate_iteration <= options->tolerance;
    return MURK_OK;
}

/* Sets the rest of the solution, which the factors say nothing about, by lines. */
static murk_status finish(murk_context *context, murk_solution *solution, const murk_stage *stage,
                          const murk_vector *x)
{
    enum { DIRECTIONS = 384 };
    const murk_ground *ground = solution->ground;
    size_t slots = solution->grid->brick_count * MURK_BRICK_SLOTS;
    size_t patches = ground ? ground->patch_count : 0;
    murk_lines *lines = NULL;
    float *net[2], *incident[2];
    murk_status status = MURK_OK;
    for (int b = 0; b < 2; b++) {
        net[b] = murk_alloc(slots, sizeof(float));
        incident[b] = murk_alloc(patches, sizeof(float));
        if (!net[b] || !incident[b])
            status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu voxels",
                               solution->grid->zone_count);
    }
    if (!status)
        status = murk_lines_create(context, solution->grid, stage->kappa_t, ground, DIRECTIONS, 1,
                                   0, &lines);
    murk_stage_spread(stage, solution->medium->grid, x->zone, solution->radiosity);
    const double sky = M_PI * solution->sky_radiance;
    const murk_radiosity in[2] = {
        {.zone = solution->radiosity,
         .patch = ground ? x->patch : NULL,
         .sky = sky,
         .horizon = solution->horizon},
        {.patch = ground ? x->patch : NULL, .sky = sky, .horizon = solution->horizon}};
    murk_incident out[2] = {{.zone = net[0], .patch = ground ? incident[0] : NULL},
                            {.zone = net[1], .patch = ground ? incident[1] : NULL}};
    if (!status)
        status = murk_lines_apply(context, lines, in, out, 2);
    if (!status)
        murk_finish(solution, stage,
                    &(murk_arrived){.net = net[0],
                                    .incident = incident[0],
                                    .net_power = out[0].net_power,
                                    .diffuse = out[1].net_power},
                    true);
    for (size_t i = 0; !status && i < patches; i++) {
        solution->patch[i] = x->patch[i];
        if (ground->reflectance[i] > 0)
            solution->patch_diffuse[i] =
                fmaxf(0, (x->patch[i] - stage->patch[i]) / ground->reflectance[i]);
    }
    for (int b = 0; b < 2; b++) {
        murk_free(net[b]);
        murk_free(incident[b]);
    }
    murk_lines_release(lines);
    return status;
}

/* What b is made of by the beam and emission alone. */
static void set_direct(const murk_system *system, const murk_stage *stage, murk_vector *direct)
{
    for (size_t i = 0; i < system->slots; i++) {
        size_t o = murk_stage_slots(stage, i / MURK_BRICK_SLOTS) + i % MURK_BRICK_SLOTS;
        direct->zone[i] = murk_stage_direct(stage, system->medium, i, o);
    }
    for (size_t i = 0; i < system->patches; i++)
        direct->patch[i] = stage->patch[i];
}

murk_status murk_solve_pairwise(murk_context *context, murk_solution *solution,
                                const murk_stage *stage, const murk_solve_options *options)
{
    double start = murk_seconds();
    murk_report *report = &solution->report;
    murk_system system = {.context = context,
                          .method = &murk_exchange_pairwise,
                          .medium = solution->medium,
                          .ground = solution->ground,
                          .slots = solution->medium->grid->brick_count * MURK_BRICK_SLOTS,
                          .patches = solution->ground ? solution->ground->patch_count : 0};
    const murk_around around = {M_PI * solution->sky_radiance, solution->horizon};
    murk_vector b = {0}, x = {0};
    murk_status status =
        system.method->init(context, solution->medium, solution->ground, options, &system.state);
    if (status)
        return status;
    double ready = murk_seconds();
    report->seconds_setup += ready - start;
    status = murk_vector_create(&system, &b);
    if (!status)
        status = murk_vector_create(&system, &x);
    if (!status) {
        set_direct(&system, stage, &x);
        status = murk_system_residual(
            &(murk_residual){.system = &system, .direct = &x, .around = &around, .r = &b}, 1);
    }
    bool paper = options->solver == MURK_GAUSS_SEIDEL;
    if (!status)
        status = paper ? gauss_seidel(&system, options, &b, &x, report)
                       : gradients(&system, options, &b, &x, report);
    if (!status) {
        report->method = "pairwise";
        report->solver = paper ? "Gauss-Seidel" : "conjugate gradients";
        report->kernel = "double";
        report->sweeps = report->iterations;
        report->coarsening = 1;
        report->estimate = report->estimate_iteration;
        double solved = murk_seconds();
        report->seconds_solve = solved - ready;
        status = finish(context, solution, stage, &x);
        report->seconds_finish = murk_seconds() - solved;
    }
    murk_vector_clear(&b);
    murk_vector_clear(&x);
    murk_preconditioner_release(system.preconditioner);
    system.method->release(system.state);
    if (!status && !report->reached)
        status = murk_fail(context, MURK_NOT_REACHED,
                           "%s did not converge in %d iterations: raise --max-iterations",
                           report->solver, report->iterations);
    return status;
}
