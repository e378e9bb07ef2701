/* SPDX-License-Identifier: Apache-2.0 */
#include "solve_memory.h"

#include "bend.h"
#include "coarse_bands.h"

#include <math.h>

static const double BRICK = MURK_BRICK_SLOTS * sizeof(float);

/* Sizes of what is solved for, in bricks but for the patches. */
typedef struct sizes {
    double medium, coarse, margin, bent, patches;
    int bands, threads;
} sizes;

/* Lines on their way between bricks: pages of the planes of two blocks, coarse and fine, for each
   thread. How many pages lines touch was measured on media of 10 to 220 voxels an edge. */
static double waiting(const murk_grid *grid, int bands, int threads)
{
    const double page = 64 * 64 * sizeof(float), planes = 24;
    double most = 0;
    for (int a = 0; a < 3; a++) {
        double pages = 1;
        for (int b = 0; b < 3; b++)
            pages *= b == a ? 1 : 3.2 + (double)(grid->hi[b] - grid->lo[b]) / 200;
        most = fmax(most, pages);
    }
    return threads * bands * planes * page * most;
}

static double lines_bytes(const sizes *s)
{
    const double stage = s->margin + s->bands * (s->margin + 3 * s->bent);
    /* Direct light, solution, residual and correction, and four of the conjugate gradients. */
    const double vectors = 8 * s->bands * (s->coarse + 3 * s->bent);
    const double preconditioner = 1.2 * s->bands * s->coarse;
    const double own = s->coarse < s->medium ? 2 * s->bands * s->coarse : 0;
    const double net = s->bands * (s->margin + 4 * s->bent);
    const double tallies = (s->threads - 1) * s->bands * (s->coarse + s->margin + 2 * 3 * s->bent);
    const double patches =
        s->bands * s->patches * (10 * sizeof(float) + 2 * (s->threads + 1) * sizeof(double));
    return BRICK * (stage + vectors + preconditioner + own + net + tallies) + patches;
}

static double pairwise_bytes(const murk_solution *solution)
{
    const double zones = (double)solution->medium->grid->zone_count;
    const double patches = solution->ground ? (double)solution->ground->patch_count : 0;
    return sizeof(float) * zones * (zones + patches) + 200 * (zones + patches);
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
    sizes s = {.medium = (double)medium->grid->brick_count,
               .margin = (double)solution[0]->grid->brick_count,
               .patches = ground ? (double)ground->patch_count : 0,
               .bands = (int)count,
               .threads = context->threads,
               .bent = count_bent(context, solution, count, options->tolerance)};
    /* Coarse bricks at the rim hold less: about 1.6 times as many as if all were full. */
    int shift = s.bent > 0 ? 0 : murk_coarse_choose_shift(medium);
    s.coarse = shift ? 1.6 * s.medium / (1 << 3 * shift) : s.medium;
    return s;
}

/* What cannot be told is more than any machine has. */
static uint64_t whole(double bytes)
{
    return bytes < 1e18 ? (uint64_t)bytes : UINT64_MAX;
}

uint64_t murk_solve_memory_left(murk_context *context, murk_solution *const solution[],
                                size_t count, const murk_solve_options *options)
{
    if (options->method == MURK_PAIRWISE)
        return (uint64_t)pairwise_bytes(solution[0]);
    const sizes s = measure(context, solution, count, options);
    return whole(lines_bytes(&s) + waiting(solution[0]->grid, s.bands, s.threads));
}

uint64_t murk_halved_memory(murk_context *context, murk_solution *const solution[], size_t count,
                            const murk_solve_options *options)
{
    sizes s = measure(context, solution, count, options);
    s.margin = 8 * s.medium + 4 * (s.margin - s.medium);
    s.coarse = s.medium *= 8;
    s.bent = 0;
    /* The finer solution, its medium's extinction and albedo, and its grid. */
    const double fine = BRICK * s.bands * (s.margin + 2 * s.medium);
    return whole(fine + lines_bytes(&s) + 4 * waiting(solution[0]->grid, s.bands, s.threads));
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
    uint64_t bytes = 0;
    if (made && made == together) {
        const double empty = BRICK * (double)(count * solution[0]->grid->brick_count);
        bytes = (uint64_t)empty + murk_solve_memory_left(context, solution, together, options);
    }
    for (size_t n = 0; n < made; n++)
        murk_solution_release(solution[n]);
    return bytes;
}
