/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solving by lines with voxels as small as the tolerance needs. Where zones are so thick that light
 * varies within them otherwise than linearly, they are halved; what the next halving changes of a
 * solution with few directions tells the error without it.
 */
#include "levels.h"

#include "coarse.h"
#include "compare.h"
#include "refine.h"
#include "solve_memory.h"
#include "spatial.h"

#include <math.h>

/* The part of the tolerance that the light's variation within zones may use up before they are
   halved, before they get slopes, and what it may use up in thin zones of halved voxels. */
static const double HALVED = 0.5, BENT = MURK_BENT_PART, LEFT = 0.05;
/* A halving divides the error by about this: measured 3.2 ... 7. */
static const double ORDER = 4;

enum { MOST_HALVINGS = 3 };
/* Voxels are not halved where there would be more of them. */
static const double MOST_ZONES = 1e7;

typedef struct murk_subdivision {
    int count;                                /* of bands */
    murk_solution *solution[MURK_MOST_BANDS]; /* of level 0 the user's */
    murk_stage stage[MURK_MOST_BANDS];
    murk_levels *levels;
    int32_t base[3]; /* of the halving that led here, in the voxels before it */
    double light;    /* seconds */
    uint64_t lamps[MURK_MOST_BANDS];
} murk_subdivision;

/* ---- levels -------------------------------------------------------------------------------- */

/* All but the solutions, which are needed to the end. */
static void leave(murk_subdivision *level)
{
    murk_levels_release(level->levels);
    for (int b = 0; b < level->count; b++)
        murk_stage_clear(&level->stage[b]);
    level->levels = NULL;
}

/* Solves a level on few directions, starting from other solutions of the user's voxels or NULL. */
static murk_status begin(murk_context *context, const murk_solve_options *options,
                         const murk_solution *const from[], bool halved, murk_subdivision *level)
{
    double start = murk_seconds(), allowed = (halved ? LEFT : BENT) * options->tolerance;
    for (int b = 0; b < level->count; b++)
        level->solution[b]->report.tolerance = options->tolerance;
    murk_status status =
        murk_stage_create(context, level->solution, level->count, allowed, level->stage);
    for (int b = 0; !status && b < level->count; b++) {
        level->stage[b].halved = halved;
        status = murk_stage_light_lamps(context, level->solution[b], &level->stage[b]);
        level->lamps[b] = level->stage[b].lamps.count;
    }
    level->light = murk_seconds() - start;
    if (!status)
        status = murk_levels_begin(context, level->solution, level->stage, level->count, options,
                                   from, &level->levels);
    return status;
}

/* One band of a level, or all of them (band < 0), on halved voxels. */
static murk_status halve(murk_context *context, const murk_subdivision *from, int band,
                         int halvings, const murk_solve_options *options, murk_subdivision *out)
{
    const int count = band < 0 ? from->count : 1;
    murk_status status = MURK_OK;
    murk_refine_base(from->solution[0]->medium->grid, out->base);
    while (!status && out->count < count) {
        const murk_solution *solution = from->solution[band < 0 ? out->count : band];
        murk_medium *medium = NULL;
        status = murk_medium_refine(context, solution->medium, &medium);
        if (status)
            return status;
        const murk_scene scene = {.medium = medium,
                                  .ground = (murk_ground *)solution->ground,
                                  .sun = solution->sun,
                                  .sky_radiance = solution->sky_radiance};
        status = murk_solution_create(context, &scene, halvings, &out->solution[out->count++]);
        murk_medium_release(medium);
    }
    return status ? status : begin(context, options, NULL, true, out);
}

/* ---- errors -------------------------------------------------------------------------------- */

/* The band whose halving tells those of all, which differ in their suns alone: the one with the
   largest estimate. -1: they differ in more, or there is one. */
static int spokesman(const murk_subdivision *level, const double spatial[])
{
    const murk_solution *first = level->solution[0];
    int most = 0;
    for (int b = 1; b < level->count; b++) {
        const murk_solution *other = level->solution[b];
        if (other->medium != first->medium || other->ground || first->ground ||
            other->sky_radiance > 0 || first->sky_radiance > 0)
            return -1;
        most = spatial[b] > spatial[most] ? b : most;
    }
    return level->count > 1 ? most : -1;
}

/* Takes a level back to where it was before it was made. */
static void discard(murk_subdivision *level)
{
    leave(level);
    for (int b = 0; b < level->count; b++)
        murk_solution_release(level->solution[b]);
    *level = (murk_subdivision){0};
}

/* How often a level may still be halved. */
static int halvings_left(const murk_subdivision *level, int last)
{
    double zones = (double)level->solution[0]->medium->grid->zone_count;
    int left = 0;
    while (last + left < MOST_HALVINGS && (zones *= 8) <= MOST_ZONES)
        left++;
    return left;
}

/* Estimates the errors by the voxels of level 0; whether those of a band are to be halved. */
static bool first_errors(const murk_subdivision *level, double goal, double spatial[])
{
    bool halve_them = false;
    for (int b = 0; b < level->count; b++) {
        const murk_coarse *coarse = murk_levels_coarse(level->levels, b);
        spatial[b] = level->stage[b].flat;
        if (!coarse->system.slopes || spatial[b] > goal) /* the rest is opaque */
            continue;
        spatial[b] += murk_spatial_linear(&coarse->system, &coarse->x, &coarse->direct);
        halve_them = halve_them || spatial[b] > goal;
    }
    return halve_them;
}

/* The same after a halving, from what it changed and with so many left. */
static bool next_errors(const murk_solve_options *options, double goal, int left, int count,
                        const double change[], double spatial[])
{
    bool halve_them = false;
    for (int b = 0; b < count; b++) {
        spatial[b] = change[b] * ORDER / (ORDER - 1);
        bool hopeless = spatial[b] > 2 * options->tolerance * pow(ORDER, left);
        halve_them = halve_them || (spatial[b] > goal && !hopeless);
    }
    return halve_them;
}

/* Whether memory allows another halving; without it the tolerance may not be reached. */
static bool may_halve(murk_context *context, const murk_subdivision *level,
                      const murk_solve_options *options)
{
    uint64_t bytes = murk_halved_memory(context, level->solution, (size_t)level->count, options);
    char need[MURK_MEMORY_TEXT], left[MURK_MEMORY_TEXT];
    if (bytes < UINT64_MAX && bytes <= murk_memory_left())
        return true;
    murk_warn(context,
              "voxels of half the size would need about %s, the memory limit leaves %s: solved "
              "without them",
              murk_memory_text(bytes, need), murk_memory_text(murk_memory_left(), left));
    return false;
}

/* Halves voxels until their error, which is set, is small enough in each band or will not become
   so; the last level is to be solved with all directions. Who asks for a number of directions asks
   for the voxels as they are. */
static murk_status descend(murk_context *context, const murk_solve_options *options,
                           murk_subdivision level[], int *last, double spatial[])
{
    const double goal = HALVED * options->tolerance;
    const int count = level->count;
    bool go_on = first_errors(level, goal, spatial);
    for (int left;
         go_on && !options->directions && (left = halvings_left(&level[*last], *last)) > 0;) {
        double change[MURK_MOST_BANDS];
        const int alone = spokesman(&level[*last], spatial);
        murk_subdivision *next = &level[*last + 1];
        if (!may_halve(context, &level[*last], options))
            return MURK_OK;
        murk_status status = halve(context, &level[*last], alone, *last + 1, options, next);
        if (!status)
            status = murk_compare(context, options,
                                  &(murk_compared){level[*last].levels, count, next->levels,
                                                   next->count, next->base, alone},
                                  change);
        if (status)
            return status;
        if (!next_errors(options, goal, left, count, change, spatial))
            return MURK_OK;
        if (alone >= 0) {
            discard(next);
            status = halve(context, &level[*last], -1, *last + 1, options, next);
        }
        if (status)
            return status;
        leave(&level[*last]);
        ++*last;
        go_on = false;
        for (int b = 0; b < count; b++) {
            spatial[b] /= ORDER;
            go_on = go_on || spatial[b] > goal;
        }
    }
    return MURK_OK;
}

/* ---- all ----------------------------------------------------------------------------------- */

/* Brings the solution of halved voxels to those that they are halves of. */
static void gather(const murk_solution *fine, const int32_t base[3], murk_solution *to)
{
    const size_t patches = to->ground ? to->ground->patch_count : 0;
    const murk_report before = to->report;
    murk_refine_average(fine->grid, fine->radiosity, base, to->grid, to->radiosity);
    for (size_t i = 0; i < patches; i++) {
        to->patch[i] = fine->patch[i];
        to->patch_diffuse[i] = fine->patch_diffuse[i];
    }
    to->report = fine->report;
    to->report.zones = before.zones;
    to->report.bricks = before.bricks;
    to->report.multiplications = before.multiplications;
    to->report.multiplications_window = before.multiplications_window;
    to->report.seconds_setup = before.seconds_setup;
}

/* The user's solution of a band, from the last of its levels. */
static void bring_back(const murk_subdivision level[], int last, int band)
{
    for (int n = last; n > 0; n--)
        gather(level[n].solution[band], level[n].base, level[n - 1].solution[band]);
    murk_report *report = &level->solution[band]->report;
    report->subdivision = 1 << last;
    report->lamps = level->lamps[band];
    report->seconds_light = level->light;
}

static murk_status check_reached(murk_context *context, const murk_report *report)
{
    if (report->reached)
        return MURK_OK;
    return murk_fail(context, MURK_NOT_REACHED,
                     "the estimated error is %.2g %%, %.2g %% was asked for: %s",
                     100 * report->estimate, 100 * report->tolerance,
                     report->estimate_spatial > report->estimate_angular
                         ? "the voxels are too thick; use smaller ones or raise the tolerance"
                         : "raise --directions or the tolerance");
}

murk_status murk_solve_lines(murk_context *context, murk_solution *const solution[], int count,
                             const murk_solve_options *options, const murk_solution *const start[])
{
    murk_subdivision level[MOST_HALVINGS + 1] = {{.count = count}};
    double begun = murk_seconds(), spatial[MURK_MOST_BANDS];
    int last = 0;
    for (int b = 0; b < count; b++)
        level->solution[b] = solution[b];
    murk_status status = begin(context, options, start, false, level);
    murk_progress(context, "solve", 0.3);
    if (!status)
        status = descend(context, options, level, &last, spatial);
    if (!status)
        status = murk_levels_finish(level[last].levels, spatial);
    for (int b = 0; !status && b < count; b++)
        bring_back(level, last, b);
    for (int b = 0; !status && b < count; b++) {
        murk_report *report = &solution[b]->report;
        report->seconds_solve = murk_seconds() - begun - level->light - report->seconds_finish;
    }
    for (int n = 0; n <= MOST_HALVINGS; n++) {
        leave(&level[n]);
        for (int b = 0; n && b < level[n].count; b++)
            murk_solution_release(level[n].solution[b]);
    }
    for (int b = 0; !status && b < count; b++)
        status = check_reached(context, &solution[b]->report);
    return status;
}
