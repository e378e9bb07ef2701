/* SPDX-License-Identifier: Apache-2.0 */
#include "murk/bands.h"

#include "alike.h"
#include "levels.h"
#include "multiplications.h"
#include "similarity.h"
#include "solve_memory.h"

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

/* Empty solutions for all scenes. */
static murk_status create(murk_context *context, const murk_scene scene[], size_t count,
                          const murk_solve_options *options, murk_solution *solution[])
{
    for (size_t n = 0; n < count; n++) {
        double start = murk_seconds();
        murk_status status = murk_solution_create(context, &scene[n], 0, &solution[n]);
        if (status)
            return status;
        murk_report *report = &solution[n]->report;
        report->seconds_setup = murk_seconds() - start;
        count_multiplications(report, options->window);
        report->tolerance = options->tolerance;
        report->reached = true;
        report->subdivision = 1;
    }
    return MURK_OK;
}

static murk_status solve_pairwise(murk_context *context, murk_solution *solution,
                                  const murk_solve_options *options)
{
    double start = murk_seconds();
    murk_stage stage = {0};
    murk_status status = murk_stage_create(context, &solution, 1, INFINITY, &stage);
    solution->report.seconds_light = murk_seconds() - start;
    if (!status)
        status = murk_solve_pairwise(context, solution, &stage, options);
    murk_stage_clear(&stage);
    return status;
}

/* How many of the solutions, from the first on, can be found together. */
static int count_alike(murk_context *context, murk_solution *const solution[], size_t left,
                       const murk_solve_options *options)
{
    if (options->method == MURK_PAIRWISE)
        return 1;
    for (int n = 1; n < MURK_MOST_BANDS && (size_t)n < left; n++) {
        const char *other = murk_solutions_differ(solution[0], solution[n]);
        if (!other)
            continue;
        murk_note(context, "a scene has %s than the one before it: solved after it", other);
        return n;
    }
    return left < MURK_MOST_BANDS ? (int)left : MURK_MOST_BANDS;
}

static void note_report(murk_context *context, const murk_scene *scene, const murk_report *report)
{
    note_skipped(context, scene, report);
    if (report->subdivision > 1)
        murk_note(context, "thick voxels: solved on %d times smaller ones each way",
                  report->subdivision);
    if (report->lamps)
        murk_note(context,
                  "lamps: %llu emitters, their light gathered line of sight by line of sight",
                  (unsigned long long)report->lamps);
}

/* Fills all solutions, those that are alike together. */
static murk_status fill(murk_context *context, const murk_scene scene[], size_t count,
                        const murk_solve_options *options, const murk_solution *const start[],
                        murk_solution *const solution[])
{
    murk_status worst = MURK_OK;
    for (size_t first = 0, n; first < count; first += n) {
        n = (size_t)count_alike(context, solution + first, count - first, options);
        murk_progress(context, "light", 0);
        murk_status status = options->method == MURK_PAIRWISE
                                 ? solve_pairwise(context, solution[first], options)
                                 : murk_solve_lines(context, solution + first, (int)n, options,
                                                    start ? start + first : NULL);
        murk_progress(context, "solve", 1);
        if (status && status != MURK_NOT_REACHED)
            return status;
        worst = status ? status : worst;
        for (size_t i = first; i < first + n; i++)
            note_report(context, &scene[i], &solution[i]->report);
    }
    return worst;
}

static murk_status solve(murk_context *context, const murk_scene scene[], size_t count,
                         const murk_solve_options *options, const murk_solution *const start[],
                         murk_solution *out[])
{
    murk_solution **solution = murk_alloc(count, sizeof *solution);
    if (!solution)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu scenes", count);
    murk_status status = create(context, scene, count, options, solution);
    uint64_t bytes =
        status || !count ? 0 : murk_solve_memory_left(context, solution, count, options);
    if (!status)
        status = murk_memory_check(context, "solving", bytes);
    for (size_t n = 0; !status && n < count; n++)
        solution[n]->report.memory = murk_memory_used() + bytes;
    if (!status)
        status = fill(context, scene, count, options, start, solution);
    for (size_t n = 0; n < count; n++) {
        if (status && status != MURK_NOT_REACHED)
            murk_solution_release(solution[n]);
        else
            out[n] = solution[n];
    }
    murk_free(solution);
    return status;
}

/* ---- forward scattering -------------------------------------------------------------------- */

static bool scatters_forward(const murk_medium *medium)
{
    return medium && medium->asymmetry != 0;
}

/* The scenes that are solved in place of those whose media scatter forward, and where their
   iterations start. What is not such a medium or start is 0 here. */
typedef struct similar {
    murk_scene *scene;
    murk_medium **medium;
    murk_solution *begun;
    const murk_solution **start;
} similar;

static murk_status reduce(murk_context *context, const murk_scene *scene,
                          const murk_solution *start, size_t n, similar *to)
{
    murk_status status = MURK_OK;
    to->scene[n] = *scene;
    to->start[n] = start;
    if (scatters_forward(scene->medium)) {
        status =
            murk_medium_reduce(context, scene->medium, scene->medium->asymmetry, &to->medium[n]);
        to->scene[n].medium = to->medium[n];
    }
    if (!status && start && scatters_forward(start->medium)) {
        status = murk_similarity_reduce(context, start, &to->begun[n]);
        to->start[n] = &to->begun[n];
    }
    return status;
}

static murk_status solve_similar(murk_context *context, const murk_scene scene[], size_t count,
                                 const murk_solve_options *options,
                                 const murk_solution *const start[], murk_solution *out[])
{
    similar to = {.scene = murk_alloc(count, sizeof *to.scene),
                  .medium = murk_alloc(count, sizeof(murk_medium *)),
                  .begun = murk_alloc(count, sizeof *to.begun),
                  .start = murk_alloc(count, sizeof(murk_solution *))};
    murk_status status = MURK_OK;
    if (!to.scene || !to.medium || !to.begun || !to.start) {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu scenes", count);
        count = 0;
    }
    for (size_t n = 0; !status && n < count; n++)
        status = reduce(context, &scene[n], start ? start[n] : NULL, n, &to);
    if (!status)
        status = solve(context, to.scene, count, options, to.start, out);
    for (size_t n = 0; n < count; n++) {
        if (to.medium[n] && (!status || status == MURK_NOT_REACHED))
            murk_similarity_restore(out[n], scene[n].medium);
        if (to.start[n] == &to.begun[n])
            murk_similarity_clear(&to.begun[n]);
        murk_medium_release(to.medium[n]);
    }
    murk_free(to.scene);
    murk_free(to.medium);
    murk_free(to.begun);
    murk_free(to.start);
    return status;
}

murk_status murk_solve_many(murk_context *context, const murk_scene scene[], size_t count,
                            const murk_solve_options *options, const murk_solution *const start[],
                            murk_solution *out[])
{
    const murk_solve_options defaults = MURK_SOLVE_DEFAULT;
    murk_solve_options o = options ? *options : defaults;
    o.max_iterations = o.max_iterations > 0 ? o.max_iterations : 1000;
    o.rays = o.rays > 0 ? o.rays : 1;
    murk_status status = check(context, &o);
    if (status)
        return status;
    bool forward = false;
    for (size_t n = 0; n < count; n++)
        forward = forward || scatters_forward(scene[n].medium) ||
                  (start && start[n] && scatters_forward(start[n]->medium));
    return forward ? solve_similar(context, scene, count, &o, start, out)
                   : solve(context, scene, count, &o, start, out);
}

murk_status murk_solve(murk_context *context, const murk_scene *scene,
                       const murk_solve_options *options, murk_solution **out)
{
    return murk_solve_many(context, scene, 1, options, options ? &options->start : NULL, out);
}
