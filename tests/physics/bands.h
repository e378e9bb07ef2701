/* SPDX-License-Identifier: Apache-2.0 */
/* One cloud in several bands, solved together and each alone. */
#ifndef BANDS_H
#define BANDS_H

#include "check.h"

#include "murk/bands.h"

enum { SIZE = 24, ZONES = SIZE * SIZE * SIZE, MOST = 7 };

/* What differs from band to band. */
struct band {
    double albedo, emission;
    double reflectance, glow; /* of the ground */
    murk_sun sun;
    double sky;
};

static float kappa_t[ZONES];

/* A cloud of so many optical depths, about; edges of 1 m. */
static inline void set_cloud(double depth)
{
    for (int n = 0; n < ZONES; n++) {
        double x = (double)(n / (SIZE * SIZE)) / SIZE, y = (double)(n / SIZE % SIZE) / SIZE,
               z = (double)(n % SIZE) / SIZE;
        kappa_t[n] = (float)(depth * (1 + 0.6 * sin(9 * x + 1) * cos(7 * y) * sin(8 * z + 2)));
    }
}

static inline murk_medium *make_medium(murk_context *context, const struct band *band, int size,
                                       const float *emission)
{
    const murk_array array = {.size = {size, size, size},
                              .voxel_size = {1. / size, 1. / size, 1. / size},
                              .kappa_t = kappa_t,
                              .emission = emission,
                              .albedo_value = band->albedo,
                              .emission_value = band->emission};
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_array(context, &array, &medium), MURK_OK);
    return medium;
}

static inline murk_ground *make_ground(murk_context *context, const struct band *band,
                                       double height)
{
    murk_ground_options options = MURK_GROUND_DEFAULT;
    murk_ground *ground = NULL;
    options.height = height;
    options.extent_max[0] = options.extent_max[1] = 1;
    options.patches[0] = options.patches[1] = 8;
    options.reflectance = band->reflectance;
    options.emission = band->glow;
    assert_int_equal(murk_ground_create(context, &options, &ground), MURK_OK);
    return ground;
}

static inline murk_scene make_scene(murk_context *context, const struct band *band, bool ground)
{
    return (murk_scene){.medium = make_medium(context, band, SIZE, NULL),
                        .ground = ground ? make_ground(context, band, -0.1) : NULL,
                        .sun = band->sun,
                        .sky_radiance = band->sky};
}

static inline void release_scenes(murk_scene scene[], int count)
{
    for (int n = 0; n < count; n++) {
        murk_medium_release((murk_medium *)scene[n].medium);
        murk_ground_release((murk_ground *)scene[n].ground);
    }
}

static inline void release_solutions(murk_solution *solution[], int count)
{
    for (int n = 0; n < count; n++)
        murk_solution_release(solution[n]);
}

/* Where directions are given, missing the tolerance is no failure. */
static inline void check_status(murk_context *context, murk_status status,
                                const murk_solve_options *options)
{
    if (status && !(status == MURK_NOT_REACHED && options->directions))
        fail_msg("%s", murk_context_message(context));
}

static inline void solve_alone(murk_context *context, const murk_scene scene[], int count,
                               const murk_solve_options *options, murk_solution *out[])
{
    for (int n = 0; n < count; n++)
        check_status(context, murk_solve(context, &scene[n], options, &out[n]), options);
}

static inline void solve_together(murk_context *context, const murk_scene scene[], int count,
                                  const murk_solve_options *options, murk_solution *out[])
{
    check_status(context, murk_solve_many(context, scene, (size_t)count, options, NULL, out),
                 options);
}

static inline size_t count_voxels(const murk_solution *solution)
{
    size_t count = 0;
    murk_solution_voxels(solution, 0, NULL, NULL, &count);
    return count;
}

static inline float *radiosities(const murk_solution *solution)
{
    size_t count = count_voxels(solution);
    float *b = malloc(count * sizeof *b);
    assert_non_null(b);
    murk_solution_voxels(solution, count, NULL, b, &count);
    return b;
}

/* Relative difference of two solutions, all voxels alike. */
static inline double difference(const murk_solution *solution, const murk_solution *wanted)
{
    size_t count = count_voxels(wanted);
    assert_int_equal(count_voxels(solution), count);
    float *b = radiosities(solution), *w = radiosities(wanted);
    double apart = 0, size = 0;
    for (size_t n = 0; n < count; n++) {
        apart += pow(b[n] - w[n], 2);
        size += pow(w[n], 2);
    }
    free(b);
    free(w);
    return size > 0 ? sqrt(apart / size) : sqrt(apart);
}

static const struct band COLOURS[MOST] = {
    {0.95, 0, 0.1, 0, {{0.3, 0.2, -1}, 1}, 0.1}, {0.5, 2, 0.6, 0.3, {{0.3, 0.2, -1}, 7}, 0},
    {0, 3, 0, 0, {{0.3, 0.2, -1}, 0.2}, 0.5},    {1, 0, 1, 0, {{-0.5, 0.1, -1}, 1}, 0},
    {0.8, 0, 0.3, 0, {{0, 0, -1}, 0}, 0}, /* no light at all */
    {0.9, 0, 0, 1, {{0, 0, -1}, 0}, 0},          {0.9, 1e-3, 0.2, 0, {{1, 0, -0.2}, 1e-3}, 0}};

#endif
