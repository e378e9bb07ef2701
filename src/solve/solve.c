/* SPDX-License-Identifier: Apache-2.0 */
#include "murk/murk.h"

#include "levels.h"
#include "multiplications.h"
#include "similarity.h"

#include <math.h>
#include <stdio.h>

static murk_status check(murk_context *context, const murk_solve_options *o)
{
    if (!(o->tolerance > 0 && o->tolerance < 1))
        return murk_fail(context, MURK_ERROR_INPUT, "tolerance: %g is not between 0 and 100 %%",
                         100 * o->tolerance);
    if (o->directions < 0 || o->directions > 1 << 20)
        return murk_fail(context, MURK_ERROR_INPUT, "directions: %d is not between 1 and 1048576",
                         o->directions);
    if (o->rays < 0 || o->rays > 64)
        return murk_fail(context, MURK_ERROR_INPUT, "rays: %d is not between 1 and 64", o->rays);
    if (o->solver == MURK_GAUSS_SEIDEL && o->method != MURK_PAIRWISE)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "solver: Gauss-Seidel needs the rows of the system: use the pairwise "
                         "method with it, or conjugate gradients");
    if (o->solver == MURK_GAUSS_SEIDEL && !(o->epsilon > 0))
        return murk_fail(context, MURK_ERROR_INPUT, "epsilon: %g is not positive", o->epsilon);
    return MURK_OK;
}

static void count_multiplications(murk_report *report, const int window[3])
{
    double zones = (double)report->zones, patches = (double)report->patches;
    report->multiplications = murk_multiplications_full(zones, patches);
    if (window[0] > 0 && window[1] > 0 && window[2] > 0)
        report->multiplications_window = murk_multiplications_window(zones, patches, window);
}

/* What the scene did not need, in one line of the log. */
static void note_skipped(murk_context *context, const murk_scene *scene, const murk_report *report)
{
    char zones[80] = "", dark[64] = "", unseen[64] = "";
    if (report->coarsening > 1)
        snprintf(zones, sizeof zones, " zones of one voxel for scattering orders (%d an edge do);",
                 report->coarsening);
    if (report->crossings_dark > 0)
        snprintf(dark, sizeof dark, " %.0f %% of the crossings (dark);",
                 100 * report->crossings_dark / report->crossings);
    if (report->crossings_unseen > 0)
        snprintf(unseen, sizeof unseen, " %.0f %% of the crossings (out of sight);",
                 100 * report->crossings_unseen / report->crossings);
    bool sun = scene->sun.irradiance > 0, sky = scene->sky_radiance > 0;
    bool iterates = report->iterations > 0;
    if (*zones || *dark || *unseen || !sun || !sky || !scene->ground || !iterates)
        murk_note(context, "skipped:%s%s%s%s%s%s%s", zones, dark, unseen, sun ? "" : " sun;",
                  sky ? "" : " sky;", scene->ground ? "" : " ground;",
                  iterates ? "" : " iteration;");
}

static murk_status solve(murk_context *context, const murk_scene *scene,
                         const murk_solve_options *options, murk_solution **out)
{
    const murk_solve_options o = *options;
    double start = murk_seconds();
    murk_solution *solution = NULL;
    murk_stage stage = {0};
    murk_status status = murk_solution_create(context, scene, 0, &solution);
    if (status)
        return status;
    murk_report *report = &solution->report;
    double setup = murk_seconds();
    report->seconds_setup = setup - start;
    count_multiplications(report, o.window);
    report->tolerance = o.tolerance;
    report->reached = true;
    murk_progress(context, "light", 0);
    report->subdivision = 1;
    if (o.method == MURK_PAIRWISE) {
        status = murk_stage_create(context, solution, INFINITY, &stage);
        report->seconds_light = murk_seconds() - setup;
        if (!status)
            status = murk_solve_pairwise(context, solution, &stage, &o);
        murk_stage_clear(&stage);
    } else {
        status = murk_solve_lines(context, solution, &o);
    }
    murk_progress(context, "solve", 1);
    if (status && status != MURK_NOT_REACHED) {
        murk_solution_release(solution);
        return status;
    }
    note_skipped(context, scene, report);
    if (report->subdivision > 1)
        murk_note(context, "thick voxels: solved on %d times smaller ones each way",
                  report->subdivision);
    if (report->lamps)
        murk_note(context,
                  "lamps: %llu emitters, their light gathered line of sight by line of sight",
                  (unsigned long long)report->lamps);
    *out = solution;
    return status;
}

/* Solves the reduced medium; what the iteration starts from is likewise that of the reduced one. */
static murk_status solve_reduced(murk_context *context, const murk_scene *scene,
                                 const murk_solve_options *options, murk_solution **out)
{
    murk_scene similar = *scene;
    murk_solve_options o = *options;
    murk_solution start = {0}, *solution = NULL;
    murk_medium *medium = NULL;
    bool forward = o.start && o.start->medium->asymmetry != 0;
    murk_status status =
        murk_medium_reduce(context, scene->medium, scene->medium->asymmetry, &medium);
    if (!status && forward)
        status = murk_similarity_reduce(context, o.start, &start);
    if (!status) {
        similar.medium = medium;
        o.start = forward ? &start : o.start;
        status = solve(context, &similar, &o, &solution);
    }
    if (!status || status == MURK_NOT_REACHED) {
        murk_similarity_restore(solution, scene->medium);
        *out = solution;
    }
    murk_similarity_clear(&start);
    murk_medium_release(medium);
    return status;
}

murk_status murk_solve(murk_context *context, const murk_scene *scene,
                       const murk_solve_options *options, murk_solution **out)
{
    const murk_solve_options defaults = MURK_SOLVE_DEFAULT;
    murk_solve_options o = options ? *options : defaults;
    o.max_iterations = o.max_iterations > 0 ? o.max_iterations : 1000;
    o.rays = o.rays > 0 ? o.rays : 1;
    murk_status status = check(context, &o);
    if (status)
        return status;
    if (scene->medium && scene->medium->asymmetry != 0)
        return solve_reduced(context, scene, &o, out);
    return solve(context, scene, &o, out);
}
