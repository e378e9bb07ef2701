/* SPDX-License-Identifier: Apache-2.0 */
#include "solve_memory.h"

#include "bend.h"
#include "coarse_bands.h"
#include "lines_memory.h"
#include "pairwise.h"
#include "quadrature.h"

#include <math.h>

static const double BRICK = MURK_BRICK_SLOTS * sizeof(float);

/* Sizes of what is solved for, in bricks but for the patches. */
typedef struct sizes {
    const murk_grid *fine; /* the solutions' */
    double medium, coarse, margin, bent, patches;
    double lamps; /* zones whose emission is taken apart: 0 or all */
    double edge;  /* of coarse zones, in voxels */
    int bands, threads, orbits;
} sizes;

static int at_once(int bands)
{
    return bands < MURK_MOST_BANDS ? bands : MURK_MOST_BANDS;
}

/* Lines on their way: those of one orbit across the coarse zones, where a correction goes along
   with the bands, and those of the last pass. `edge` is that of the voxels that are solved on. */
static double waiting(murk_context *context, const sizes *s, double edge)
{
    const bool bent = s->bent > 0;
    const murk_lines_plan coarse = {s->fine, edge * s->edge, 1, at_once(s->bands + 1), bent};
    const murk_lines_plan fine = {s->fine, edge, s->orbits, s->bands, bent};
    return murk_lines_memory(context, &coarse) + murk_lines_memory(context, &fine);
}

/* What vectors, lines and their workers have of each patch. */
static double patch_bytes(int bands, int threads)
{
    return bands * (20 * sizeof(float) + 2 * threads * sizeof(double)) +
           2 * MURK_MOST_BANDS * sizeof(double);
}

static double lines_bytes(const sizes *s)
{
    const double stage = s->margin + s->bands * (s->margin + 3 * s->bent + s->lamps);
    /* Direct light, solution, residual and correction, and four of the conjugate gradients. */
    const double vectors = 8 * s->bands * (s->coarse + 3 * s->bent);
    const double preconditioner = 1.3 * s->bands * s->coarse;
    const double own = s->coarse < s->medium ? 2 * s->bands * s->coarse : 0;
    const double net = s->bands * (s->margin + 4 * s->bent);
    const double tallies = (s->threads - 1) * (at_once(s->bands + 1) * (s->coarse + 3 * s->bent) +
                                               s->bands * (s->margin + 3 * s->bent));
    const double patches = s->patches * patch_bytes(s->bands, s->threads);
    return BRICK * (stage + vectors + preconditioner + own + net + tallies) + patches;
}

/* Results in the margin come from lines: of two fields, the second without the sky. */
static double pairwise_bytes(murk_context *context, const murk_solution *solution)
{
    enum { FINISH_ORBITS = 8, FIELDS = 2 };
    const murk_lines_plan finish = {solution->grid, 1, FINISH_ORBITS, FIELDS, false};
    const double margin = (double)solution->grid->brick_count;
    const double medium = (double)solution->medium->grid->brick_count;
    const double patches = solution->ground ? (double)solution->ground->patch_count : 0;
    /* kappa_t, beam, two fields and their tallies; b, x and what the iteration has. */
    const double bricks = (2 + FIELDS * context->threads) * margin + 8 * medium;
    return murk_pairwise_memory(solution->medium, solution->ground) + BRICK * bricks +
           murk_lines_memory(context, &finish) + patches * patch_bytes(FIELDS, context->threads);
}

/* Bricks whose zones get slopes. */
static double count_bent(murk_context *context, murk_solution *const solution[], size_t count,
                         double tolerance)
{
    const murk_medium *medium[MURK_MOST_BANDS];
    double flat[MURK_MOST_BANDS];
    const murk_grid *grid = solution[0]->medium->grid;
    murk_bend bend;
    for (size_t n = 0; n < count; n++)
        medium[n] = solution[n]->medium;
    int32_t *map = murk_alloc(grid->brick_count, sizeof *map);
    for (size_t b = 0; map && b < grid->brick_count; b++)
        map[b] = (int32_t)b;
    double bent = INFINITY; /* not even this fits */
    if (map && !murk_bend_create(context, medium, (int)count, MURK_BENT_PART * tolerance, grid, map,
                                 flat, &bend)) {
        bent = (double)bend.zones.count;
        murk_bend_clear(&bend);
    }
    murk_free(map);
    return bent;
}

static sizes measure(murk_context *context, murk_solution *const solution[], size_t count,
                     const murk_solve_options *options)
{
    const murk_medium *medium = solution[0]->medium;
    const murk_ground *ground = solution[0]->ground;
    if (count > MURK_MOST_BANDS)
        count = MURK_MOST_BANDS;
    sizes s = {.fine = solution[0]->grid,
               .medium = (double)medium->grid->brick_count,
               .margin = (double)solution[0]->grid->brick_count,
               .patches = ground ? (double)ground->patch_count : 0,
               .bands = (int)count,
               .threads = context->threads,
               .bent = count_bent(context, solution, count, options->tolerance)};
    /* Coarse bricks at the rim hold less: about 1.6 times as many as if all were full. */
    int shift = s.bent > 0 ? 0 : murk_coarse_choose_shift(medium);
    s.coarse = shift ? 1.6 * s.medium / (1 << 3 * shift) : s.medium;
    s.lamps = medium->emission.field ? s.medium : 0;
    s.edge = 1 << shift;
    s.orbits = options->directions ? (options->directions + MURK_ORBIT - 1) / MURK_ORBIT : 4;
    return s;
}

/* With what is too small to be listed: directions, names, tables. What cannot be told is more than
 * any machine has. */
static uint64_t whole(double bytes)
{
    const double rest = 3e5, part = 0.03;
    return bytes < 1e18 ? (uint64_t)(rest + (1 + part) * bytes) : UINT64_MAX;
}

uint64_t murk_solve_memory_left(murk_context *context, murk_solution *const solution[],
                                size_t count, const murk_solve_options *options)
{
    if (options->method == MURK_PAIRWISE)
        return whole(pairwise_bytes(context, solution[0]));
    const sizes s = measure(context, solution, count, options);
    return whole(lines_bytes(&s) + waiting(context, &s, 1));
}

uint64_t murk_halved_memory(murk_context *context, murk_solution *const solution[], size_t count,
                            const murk_solve_options *options)
{
    sizes s = measure(context, solution, count, options);
    s.margin = 8 * s.medium + 4 * (s.margin - s.medium);
    s.coarse = s.medium *= 8;
    s.bent = 0;
    s.edge = 1;
    /* The finer solution, its medium's extinction and albedo, and its grid. */
    const double fine = BRICK * s.bands * (s.margin + 2 * s.medium);
    return whole(fine + lines_bytes(&s) + waiting(context, &s, 0.5));
}

/* The media that stand in for those that scatter forward. */
static double reduced_bytes(const murk_scene scene[], size_t count)
{
    double fields = 0;
    for (size_t n = 0; n < count; n++)
        if (scene[n].medium && scene[n].medium->asymmetry != 0)
            fields += (scene[n].medium->albedo.field ? 2. : 1.) *
                      (double)scene[n].medium->grid->brick_count;
    return BRICK * fields;
}

/* A solution that is empty: its radiosity, and its grid and what made it. */
static double empty_bytes(const murk_solution *solution)
{
    const double each = 1 << 14, brick = BRICK + 256, patch = 2 * sizeof(float);
    const double patches = solution->ground ? (double)solution->ground->patch_count : 0;
    return each + brick * (double)solution->grid->brick_count + patch * patches;
}

uint64_t murk_solve_memory(murk_context *context, const murk_scene scene[], size_t count,
                           const murk_solve_options *options)
{
    const murk_solve_options defaults = MURK_SOLVE_DEFAULT;
    murk_solution *solution[MURK_MOST_BANDS] = {NULL};
    size_t together = count < MURK_MOST_BANDS ? count : MURK_MOST_BANDS, made = 0;
    if (!options)
        options = &defaults;
    while (made < together && !murk_solution_create(context, &scene[made], 0, &solution[made]))
        made++;
    double bytes = made < together ? INFINITY : 0;
    if (made && made == together)
        bytes = (double)count * empty_bytes(solution[0]) + reduced_bytes(scene, count) +
                (double)murk_solve_memory_left(context, solution, together, options);
    for (size_t n = 0; n < made; n++)
        murk_solution_release(solution[n]);
    return whole(bytes);
}
