/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

size_t bench_mc_zones(const struct bench_mc_scene *scene)
{
    return (size_t)scene->size[0] * (size_t)scene->size[1] * (size_t)scene->size[2];
}

size_t bench_mc_patches(const struct bench_mc_scene *scene)
{
    return (size_t)scene->patches[0] * (size_t)scene->patches[1];
}

void bench_mc_radiosity(const struct bench_mc_scene *scene, const struct bench_mc_tally *tally,
                        double *zone, double *patch)
{
    const struct bench_mc_scene *s = scene;
    size_t patches = bench_mc_patches(s);
    double volume = s->voxel[0] * s->voxel[1] * s->voxel[2];
    for (size_t n = 0; n < bench_mc_zones(s); n++)
        zone[n] = s->kappa_t[n] > 0 ? s->albedo[n] * tally->zone[n] / (4 * s->kappa_t[n] * volume) +
                                          (1 - s->albedo[n]) * s->emission[n]
                                    : 0;
    double area = (s->ground_high[0] - s->ground_low[0]) * (s->ground_high[1] - s->ground_low[1]) /
                  (double)patches;
    for (size_t n = 0; n < patches; n++)
        patch[n] = s->ground_emission[n] + s->ground_reflectance[n] * tally->patch[n] / area;
}

/* Adds the n-th sample, from 0 on, to means and sums of squared deviations (Welford 1962). */
static void add(double n, const double *sample, size_t count, double *mean, double *squares)
{
    for (size_t i = 0; i < count; i++) {
        double off = sample[i] - mean[i];
        mean[i] += off / (n + 1);
        squares[i] += off * (sample[i] - mean[i]);
    }
}

bool bench_mc_solve(const struct bench_mc_scene *scene, bool exact, long packets, int batches,
                    int threads, struct bench_mc_result *result)
{
    size_t zones = bench_mc_zones(scene), patches = bench_mc_patches(scene), all = zones + patches;
    bool done = true;
    memset(result->zone, 0, zones * sizeof(double));
    memset(result->zone_error, 0, zones * sizeof(double));
    if (patches) {
        memset(result->patch, 0, patches * sizeof(double));
        memset(result->patch_error, 0, patches * sizeof(double));
    }
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_max_threads())
    {
        double *power = malloc(2 * all * sizeof *power);
#pragma omp for ordered schedule(dynamic, 1)
        for (int n = 0; n < batches; n++) {
            struct bench_mc_tally tally = {.zone = power, .patch = power + zones};
            double *b = power + all;
            bool ran = power != NULL;
            if (ran) {
                memset(power, 0, all * sizeof *power);
                ran = bench_mc_run(scene, exact, (uint64_t)n + 1, packets / batches, &tally);
            }
            if (ran)
                bench_mc_radiosity(scene, &tally, b, b + zones);
#pragma omp ordered
            if (ran) {
                add(n, b, zones, result->zone, result->zone_error);
                add(n, b + zones, patches, result->patch, result->patch_error);
            } else {
                done = false;
            }
        }
        free(power);
    }
    double pairs = (double)batches * (batches - 1);
    for (size_t i = 0; i < zones; i++)
        result->zone_error[i] = sqrt(result->zone_error[i] / pairs);
    for (size_t i = 0; i < patches; i++)
        result->patch_error[i] = sqrt(result->patch_error[i] / pairs);
    return done;
}
