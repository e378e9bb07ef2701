/* SPDX-License-Identifier: Apache-2.0 */
#include "similarity.h"

#include "finish.h"

#include <math.h>

/* A zone's, or a voxel's of the margin, which holds albedo G/4 alone. */
typedef struct coefficients {
    double albedo, emission;
} coefficients;

/* kappa_t' B' = kappa_s (1 - g) G/4 + kappa_a E, with kappa_t' = kappa_t (1 - albedo g). */
static double reduced(coefficients of, double g, double b)
{
    return ((1 - g) * b + g * (1 - of.albedo) * of.emission) / (1 - of.albedo * g);
}

static double restored(coefficients of, double g, double b)
{
    return fmax(0, ((1 - of.albedo * g) * b - g * (1 - of.albedo) * of.emission) / (1 - g));
}

typedef double convert_fn(coefficients of, double g, double b);

static void convert(const murk_solution *solution, const murk_medium *medium, convert_fn *function,
                    const float *from, float *to)
{
    const murk_grid *grid = solution->grid;
    const double mean = murk_mean_albedo(medium);
#pragma omp parallel for num_threads(solution->context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++) {
        const int32_t *at = grid->brick[b];
        int32_t zones = murk_grid_find(medium->grid, at[0], at[1], at[2]);
        for (int s = 0; s < MURK_BRICK_SLOTS; s++) {
            size_t o = b * MURK_BRICK_SLOTS + (size_t)s;
            size_t i = zones == MURK_NO_BRICK ? 0 : (size_t)zones * MURK_BRICK_SLOTS + (size_t)s;
            coefficients of = {0};
            if (!murk_grid_active(grid, b, s))
                continue;
            if (zones != MURK_NO_BRICK && medium->kappa_t[i] > 0) {
                of = (coefficients){murk_value(&medium->albedo, i),
                                    murk_value(&medium->emission, i)};
            } else {
                const int32_t voxel[3] = {at[0] * 8 + (s >> 6), at[1] * 8 + (s >> 3 & 7),
                                          at[2] * 8 + (s & 7)};
                of.albedo = murk_margin_albedo(medium, voxel, mean);
            }
            to[o] = (float)function(of, medium->asymmetry, from[o]);
        }
    }
}

murk_status murk_similarity_reduce(murk_context *context, const murk_solution *solution,
                                   murk_solution *out)
{
    murk_medium *medium;
    murk_status status =
        murk_medium_reduce(context, solution->medium, solution->medium->asymmetry, &medium);
    if (status)
        return status;
    float *radiosity =
        murk_alloc(solution->grid->brick_count * MURK_BRICK_SLOTS, sizeof *radiosity);
    if (!radiosity) {
        murk_medium_release(medium);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu voxels",
                         solution->grid->zone_count);
    }
    convert(solution, solution->medium, reduced, solution->radiosity, radiosity);
    *out = *solution;
    out->medium = medium;
    out->radiosity = radiosity;
    return MURK_OK;
}

void murk_similarity_clear(murk_solution *reduced)
{
    murk_medium_release((murk_medium *)reduced->medium);
    murk_free(reduced->radiosity);
    reduced->medium = NULL;
    reduced->radiosity = NULL;
}

void murk_similarity_restore(murk_solution *solution, const murk_medium *medium)
{
    convert(solution, medium, restored, solution->radiosity, solution->radiosity);
    murk_medium_release((murk_medium *)solution->medium);
    solution->medium = murk_medium_share(medium);
}
