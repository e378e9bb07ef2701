/* SPDX-License-Identifier: Apache-2.0 */
/* Solving with the stored factors of `pairwise`: the paper's way, or conjugate gradients. */
#include "levels.h"

#include "conjugate_gradients.h"
#include "gauss_seidel.h"
#include "pairwise.h"
#include "preconditioner.h"

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
    murk_cg_result result;
    murk_status status = murk_conjugate_gradients(system, b, x, 0.1 * options->tolerance, 0,
                                                  options->max_iterations, &result);
    if (status)
        return status;
    report->iterations = result.iterations;
    report->residual = result.residual;
    report->estimate_iteration = result.norm > 0 ? result.error / result.norm : 0;
    report->reached = report->estimate_iteration <= options->tolerance;
    return MURK_OK;
}

murk_status murk_solve_pairwise(murk_context *context, murk_solution *solution,
                                const murk_stage *stage, const murk_solve_options *options)
{
    /* Directions for the margin's voxels and the energies, which the factors say nothing about. */
    enum { FINISH_DIRECTIONS = 384 };
    double start = murk_seconds();
    murk_report *report = &solution->report;
    murk_system system = {.context = context,
                          .method = &murk_exchange_pairwise,
                          .medium = solution->medium,
                          .ground = solution->ground,
                          .slots = solution->medium->grid->brick_count * MURK_BRICK_SLOTS,
                          .patches = solution->ground ? solution->ground->patch_count : 0,
                          .cost = 1};
    murk_vector b = {0}, x = {0};
    murk_outside outside;
    murk_status status =
        system.method->init(context, solution->medium, solution->ground, options, &system.state);
    if (status)
        return status;
    double ready = murk_seconds();
    report->seconds_setup += ready - start;
    status = murk_vector_create(&system, &b);
    if (!status)
        status = murk_vector_create(&system, &x);
    if (!status)
        status = murk_source_build(&system, solution, stage, &b, &outside);
    bool paper = options->solver == MURK_GAUSS_SEIDEL;
    if (!status)
        status = paper ? gauss_seidel(&system, options, &b, &x, report)
                       : gradients(&system, options, &b, &x, report);
    if (!status) {
        report->method = "pairwise";
        report->solver = paper ? "Gauss-Seidel" : "conjugate gradients";
        report->kernel = "double";
        report->sweeps = report->iterations;
        report->estimate = report->estimate_iteration;
        double solved = murk_seconds();
        report->seconds_solve = solved - ready;
        status = murk_finish(context, solution, stage,
                             &(murk_solved){.zone = x.zone,
                                            .patch = solution->ground ? x.patch : NULL,
                                            .directions = FINISH_DIRECTIONS,
                                            .rays = 1});
        for (size_t i = 0; !status && i < system.patches; i++) {
            solution->patch[i] = x.patch[i];
            float rho = solution->ground->reflectance[i];
            if (rho > 0)
                solution->patch_diffuse[i] = fmaxf(
                    0, (x.patch[i] - solution->ground->emission[i]) / rho - stage->patch_sun[i]);
        }
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
