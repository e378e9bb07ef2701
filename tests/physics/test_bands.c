/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Scenes solved together: each as if it were alone. With a given number of directions the lines are
 * the same, so that rounding and the last step of an iteration are all that may differ.
 */
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

static float kappa_t[ZONES], hot[ZONES];

/* A cloud of so many optical depths, about; edges of 1 m. */
static void set_cloud(double depth)
{
    for (int n = 0; n < ZONES; n++) {
        double x = (double)(n / (SIZE * SIZE)) / SIZE, y = (double)(n / SIZE % SIZE) / SIZE,
               z = (double)(n % SIZE) / SIZE;
        kappa_t[n] = (float)(depth * (1 + 0.6 * sin(9 * x + 1) * cos(7 * y) * sin(8 * z + 2)));
    }
}

static murk_medium *make_medium(murk_context *context, const struct band *band, int size,
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

static murk_ground *make_ground(murk_context *context, const struct band *band, double height)
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

static murk_scene make_scene(murk_context *context, const struct band *band, bool ground)
{
    return (murk_scene){.medium = make_medium(context, band, SIZE, NULL),
                        .ground = ground ? make_ground(context, band, -0.1) : NULL,
                        .sun = band->sun,
                        .sky_radiance = band->sky};
}

static void release_scenes(murk_scene scene[], int count)
{
    for (int n = 0; n < count; n++) {
        murk_medium_release((murk_medium *)scene[n].medium);
        murk_ground_release((murk_ground *)scene[n].ground);
    }
}

static void release_solutions(murk_solution *solution[], int count)
{
    for (int n = 0; n < count; n++)
        murk_solution_release(solution[n]);
}

/* Where directions are given, missing the tolerance is no failure. */
static void check_status(murk_context *context, murk_status status,
                         const murk_solve_options *options)
{
    if (status && !(status == MURK_NOT_REACHED && options->directions))
        fail_msg("%s", murk_context_message(context));
}

static void solve_alone(murk_context *context, const murk_scene scene[], int count,
                        const murk_solve_options *options, murk_solution *out[])
{
    for (int n = 0; n < count; n++)
        check_status(context, murk_solve(context, &scene[n], options, &out[n]), options);
}

static void solve_together(murk_context *context, const murk_scene scene[], int count,
                           const murk_solve_options *options, murk_solution *out[])
{
    check_status(context, murk_solve_many(context, scene, (size_t)count, options, NULL, out),
                 options);
}

static size_t count_voxels(const murk_solution *solution)
{
    size_t count = 0;
    murk_solution_voxels(solution, 0, NULL, NULL, &count);
    return count;
}

static float *radiosities(const murk_solution *solution)
{
    size_t count = count_voxels(solution);
    float *b = malloc(count * sizeof *b);
    assert_non_null(b);
    murk_solution_voxels(solution, count, NULL, b, &count);
    return b;
}

/* Relative difference of two solutions, all voxels alike. */
static double difference(const murk_solution *solution, const murk_solution *wanted)
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

static double ground_difference(const murk_solution *solution, const murk_solution *wanted)
{
    float b[64], w[64];
    double apart = 0, size = 0;
    assert_int_equal(murk_solution_ground(solution, b), MURK_OK);
    assert_int_equal(murk_solution_ground(wanted, w), MURK_OK);
    for (int n = 0; n < 64; n++) {
        apart += pow(b[n] - w[n], 2);
        size += pow(w[n], 2);
    }
    return size > 0 ? sqrt(apart / size) : sqrt(apart);
}

static void check_energies(const murk_report *report, const murk_report *wanted, double within)
{
    double sources = wanted->energy_emitted + wanted->energy_sun + wanted->energy_diffuse;
    assert_at_most(report->energy_balance, 1e-5);
    assert_within(report->energy_emitted, wanted->energy_emitted, within * sources);
    assert_within(report->energy_sun, wanted->energy_sun, within * sources);
    assert_within(report->energy_diffuse, wanted->energy_diffuse, within * sources);
    assert_within(report->energy_absorbed, wanted->energy_absorbed, within * sources);
    assert_within(report->energy_escaped, wanted->energy_escaped, within * sources);
}

/* All bands together and each alone, within so much of each other. */
static void check_bands(murk_context *context, const murk_scene scene[], int count,
                        const murk_solve_options *options, double within)
{
    murk_solution *alone[MOST], *together[MOST];
    solve_alone(context, scene, count, options, alone);
    solve_together(context, scene, count, options, together);
    for (int n = 0; n < count; n++) {
        const murk_report *report = murk_solution_report(together[n]);
        const murk_report *wanted = murk_solution_report(alone[n]);
        double apart = difference(together[n], alone[n]);
        print_message("band %d: %.1e apart, %d and %d iterations\n", n, apart, wanted->iterations,
                      report->iterations);
        assert_at_most(apart, within);
        if (scene[n].ground)
            assert_at_most(ground_difference(together[n], alone[n]), within);
        assert_int_equal(report->directions, wanted->directions);
        assert_int_equal(report->subdivision, wanted->subdivision);
        assert_int_equal(report->lamps, wanted->lamps);
        if (!options->camera)
            check_energies(report, wanted, within + 1e-6);
    }
    release_solutions(alone, count);
    release_solutions(together, count);
}

/* ---- the same lines ------------------------------------------------------------------------ */

static const struct band COLOURS[MOST] = {
    {0.95, 0, 0.1, 0, {{0.3, 0.2, -1}, 1}, 0.1}, {0.5, 2, 0.6, 0.3, {{0.3, 0.2, -1}, 7}, 0},
    {0, 3, 0, 0, {{0.3, 0.2, -1}, 0.2}, 0.5},    {1, 0, 1, 0, {{-0.5, 0.1, -1}, 1}, 0},
    {0.8, 0, 0.3, 0, {{0, 0, -1}, 0}, 0}, /* no light at all */
    {0.9, 0, 0, 1, {{0, 0, -1}, 0}, 0},          {0.9, 1e-3, 0.2, 0, {{1, 0, -0.2}, 1e-3}, 0}};

static void colours(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 96;
    set_cloud(3);
    for (int ground = 0; ground < 2; ground++) {
        murk_scene scene[MOST];
        for (int n = 0; n < MOST; n++)
            scene[n] = make_scene(context, &COLOURS[n], ground);
        for (int count = 2; count <= MOST; count += 5) {
            print_message("%d bands, %s ground\n", count, ground ? "with" : "without");
            check_bands(context, scene, count, &options, 1e-5);
        }
        release_scenes(scene, MOST);
    }
    murk_context_release(context);
}

/* Where nothing scatters B is E, to the last bit, and where there is no light it is 0. */
static void closed_forms(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    const struct band bands[3] = {COLOURS[2], COLOURS[0], COLOURS[4]};
    murk_scene scene[3];
    murk_solution *solution[3];
    const murk_solve_options options = MURK_SOLVE_DEFAULT;
    set_cloud(3);
    for (int n = 0; n < 3; n++)
        scene[n] = make_scene(context, &bands[n], true);
    solve_together(context, scene, 3, &options, solution);
    for (int n = 0; n < ZONES; n++) {
        const int32_t at[3] = {n / (SIZE * SIZE), n / SIZE % SIZE, n % SIZE};
        assert_true(murk_solution_radiosity(solution[0], at) == 3);
        assert_true(murk_solution_radiosity(solution[2], at) == 0);
    }
    release_solutions(solution, 3);
    release_scenes(scene, 3);
    murk_context_release(context);
}

/* Light from six sides on one medium. */
static void suns(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_scene scene[6];
    options.directions = 96;
    set_cloud(3);
    for (int n = 0; n < 6; n++) {
        scene[n] = (murk_scene){.sun = {.irradiance = 1 + n}};
        scene[n].medium = n ? scene[0].medium : make_medium(context, &COLOURS[0], SIZE, NULL);
        scene[n].sun.direction[n / 2] = n % 2 ? -1 : 1;
    }
    check_bands(context, scene, 6, &options, 1e-5);
    release_scenes(scene, 1);
    murk_context_release(context);
}

/* A bright slab of which nothing comes to the far end, beside a faint light that is everywhere. */
static void faint_beside_bright(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    const struct band bright = {.albedo = 0}, faint = {.albedo = 0.9, .emission = 1e-16};
    options.directions = 96;
    set_cloud(300);
    for (int n = 0; n < ZONES; n++)
        hot[n] = n / (SIZE * SIZE) < 8;
    murk_scene scene[2] = {{.medium = make_medium(context, &bright, SIZE, hot)},
                           {.medium = make_medium(context, &faint, SIZE, NULL)}};
    check_bands(context, scene, 2, &options, 1e-3);
    release_scenes(scene, 2);
    murk_context_release(context);
}

/* One voxel of the second band shines: its light is gathered line of sight by line of sight. */
static void lamps(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    const struct band lit = {.albedo = 0.9, .reflectance = 0.2};
    options.directions = 96;
    set_cloud(2);
    memset(hot, 0, sizeof hot);
    hot[(8 * SIZE + 8) * SIZE + 9] = 1000;
    murk_scene scene[3] = {make_scene(context, &COLOURS[0], true),
                           {.medium = make_medium(context, &lit, SIZE, hot),
                            .ground = make_ground(context, &lit, -0.1)},
                           make_scene(context, &COLOURS[1], true)};
    murk_solution *solution[3];
    solve_together(context, scene, 3, &options, solution);
    for (int n = 0; n < 3; n++)
        assert_int_equal(murk_solution_report(solution[n])->lamps, n == 1);
    release_solutions(solution, 3);
    check_bands(context, scene, 3, &options, 1e-5);
    release_scenes(scene, 3);
    murk_context_release(context);
}

/* Close to one corner of a thick cloud: more is in sight of the camera in one band than in the
   other, and the bands get all of both. */
static void one_camera(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    const murk_camera camera = {.eye = {-0.4, -0.4, 0.5},
                                .target = {0.1, 0.1, 0.1},
                                .up = {0, 0, 1},
                                .fov = 20,
                                .size = {16, 16}};
    options.directions = 96;
    options.camera = &camera;
    set_cloud(30);
    murk_scene scene[2];
    murk_solution *alone[2], *together[2];
    for (int n = 0; n < 2; n++)
        scene[n] = make_scene(context, &COLOURS[n], false);
    solve_alone(context, scene, 2, &options, alone);
    solve_together(context, scene, 2, &options, together);
    for (int n = 0; n < 2; n++) {
        assert_true(murk_solution_report(together[n])->crossings_unseen > 0);
        assert_true(isnan(murk_solution_report(together[n])->energy_absorbed));
        const int32_t at[3] = {1, 1, 1};
        double wanted = murk_solution_radiosity(alone[n], at);
        assert_within(murk_solution_radiosity(together[n], at), wanted, 1e-3 * wanted);
    }
    release_solutions(alone, 2);
    release_solutions(together, 2);
    release_scenes(scene, 2);
    murk_context_release(context);
}

/* ---- directions and voxels of the library's choice ----------------------------------------- */

/* Each within its own estimate of what it is alone. */
static void check_estimates(murk_context *context, const murk_scene scene[], int count,
                            int subdivision)
{
    const murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_solution *alone[MOST], *together[MOST];
    solve_alone(context, scene, count, &options, alone);
    solve_together(context, scene, count, &options, together);
    for (int n = 0; n < count; n++) {
        const murk_report *report = murk_solution_report(together[n]);
        const murk_report *wanted = murk_solution_report(alone[n]);
        double apart = difference(together[n], alone[n]);
        print_message("band %d: %.2g %% apart, %d and %d directions, estimates %.2g and %.2g %%\n",
                      n, 100 * apart, wanted->directions, report->directions,
                      100 * wanted->estimate, 100 * report->estimate);
        assert_true(report->reached);
        assert_at_most(apart, wanted->estimate + report->estimate);
        assert_true(report->directions >= wanted->directions);
        assert_int_equal(report->subdivision, subdivision);
        assert_at_most(report->energy_balance, 1e-5);
    }
    release_solutions(alone, count);
    release_solutions(together, count);
}

static void within_the_tolerance(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_scene scene[3];
    set_cloud(3);
    for (int n = 0; n < 3; n++)
        scene[n] = make_scene(context, &COLOURS[n], true);
    check_estimates(context, scene, 3, 1);
    release_scenes(scene, 3);
    murk_context_release(context);
}

/* The voxels are halved for the first band, and so for all. */
static void thick(void **state)
{
    (void)state;
    enum { FEW = 12 };
    murk_context *context = check_context(0, NULL);
    const struct band bands[3] = {COLOURS[0], {.albedo = 0.2, .emission = 1}, COLOURS[2]};
    murk_scene scene[3];
    uint64_t random = 5;
    for (int n = 0; n < FEW * FEW * FEW; n++)
        kappa_t[n] = (float)(36 * check_random(&random));
    for (int n = 0; n < 3; n++)
        scene[n] = (murk_scene){.medium = make_medium(context, &bands[n], FEW, NULL),
                                .sun = bands[n].sun,
                                .sky_radiance = bands[n].sky};
    check_estimates(context, scene, 3, 2);
    release_scenes(scene, 3);
    murk_context_release(context);
}

/* Another number of threads adds up in another order; a start changes the time and not the light.
 */
static void threads_and_starts(void **state)
{
    (void)state;
    murk_context *context[2] = {check_context(1, NULL), check_context(3, NULL)};
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_solution *solution[3][3];
    murk_scene scene[3];
    options.directions = 96;
    set_cloud(3);
    for (int n = 0; n < 3; n++)
        scene[n] = make_scene(context[0], &COLOURS[n], true);
    for (int t = 0; t < 2; t++)
        solve_together(context[t], scene, 3, &options, solution[t]);
    const murk_solution *start[3] = {solution[0][0], NULL, solution[0][2]};
    check_status(context[0], murk_solve_many(context[0], scene, 3, &options, start, solution[2]),
                 &options);
    for (int n = 0; n < 3; n++) {
        assert_at_most(difference(solution[1][n], solution[0][n]), 1e-5);
        assert_at_most(difference(solution[2][n], solution[0][n]), options.tolerance);
    }
    assert_true(murk_solution_report(solution[2][0])->iterations <
                murk_solution_report(solution[0][0])->iterations);
    for (int t = 0; t < 3; t++)
        release_solutions(solution[t], 3);
    release_scenes(scene, 3);
    for (int t = 0; t < 2; t++)
        murk_context_release(context[t]);
}

/* ---- one after another --------------------------------------------------------------------- */

static char noted[4096];

static void note(void *user, murk_log_level level, const char *text)
{
    (void)user;
    if (level == MURK_LOG_INFO)
        snprintf(noted + strlen(noted), sizeof noted - strlen(noted), "%s\n", text);
}

/* The very numbers of each alone, and the log says why. */
static void check_apart(murk_context *context, const murk_scene scene[],
                        const murk_solve_options *options, const char *reason)
{
    murk_solution *alone[2], *together[2];
    solve_alone(context, scene, 2, options, alone);
    noted[0] = 0;
    solve_together(context, scene, 2, options, together);
    for (int n = 0; n < 2; n++)
        assert_true(difference(together[n], alone[n]) == 0);
    if (reason && !strstr(noted, reason))
        fail_msg("\"%s\" is not in the log: %s", reason, noted);
    release_solutions(alone, 2);
    release_solutions(together, 2);
}

static void scenes_that_differ(void **state)
{
    (void)state;
    murk_context *context = NULL;
    const murk_context_options logged = {.threads = 1, .log = note};
    assert_int_equal(murk_context_create(&logged, &context), MURK_OK);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 96;
    set_cloud(3);
    murk_scene scene[5];
    for (int n = 0; n < 3; n++)
        scene[n] = make_scene(context, &COLOURS[n], true);
    kappa_t[17] *= 1.0001f;
    scene[3] = make_scene(context, &COLOURS[1], true);
    kappa_t[17] = 0;
    scene[4] = make_scene(context, &COLOURS[1], true);
    check_apart(context, (murk_scene[]){scene[0], scene[3]}, &options, "another extinction");
    check_apart(context, (murk_scene[]){scene[0], scene[4]}, &options, "other voxels");
    murk_scene bare = scene[1], lower = scene[1];
    bare.ground = NULL;
    lower.ground = make_ground(context, &COLOURS[1], -0.2);
    check_apart(context, (murk_scene[]){scene[0], bare}, &options, "another ground");
    check_apart(context, (murk_scene[]){scene[0], lower}, &options, "another ground");
    release_scenes(&(murk_scene){.ground = lower.ground}, 1);
    release_scenes(scene, 5);
    murk_context_release(context);
}

static void pairwise(void **state)
{
    (void)state;
    enum { FEW = 5 };
    murk_context *context = check_context(1, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_scene scene[2];
    options.method = MURK_PAIRWISE;
    set_cloud(3);
    for (int n = 0; n < 2; n++)
        scene[n] = (murk_scene){.medium = make_medium(context, &COLOURS[n], FEW, NULL),
                                .sun = COLOURS[n].sun,
                                .sky_radiance = COLOURS[n].sky};
    check_apart(context, scene, &options, NULL);
    release_scenes(scene, 2);
    murk_context_release(context);
}

/* ---- failure ------------------------------------------------------------------------------- */

static void failures(void **state)
{
    (void)state;
    murk_context *context = check_context(1, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_scene scene[3];
    char none;
    murk_solution *const untouched = (murk_solution *)(void *)&none;
    murk_solution *out[3] = {untouched, untouched, untouched};
    set_cloud(3);
    for (int n = 0; n < 3; n++)
        scene[n] = make_scene(context, &COLOURS[n], false);
    scene[2].sky_radiance = -1;
    assert_int_equal(murk_solve_many(context, scene, 3, &options, NULL, out), MURK_ERROR_INPUT);
    assert_non_null(strstr(murk_context_message(context), "sky.radiance"));
    scene[2].sky_radiance = 1;
    options.tolerance = 2;
    assert_int_equal(murk_solve_many(context, scene, 3, &options, NULL, out), MURK_ERROR_INPUT);
    for (int n = 0; n < 3; n++)
        assert_ptr_equal(out[n], untouched);
    /* Of the three only the last, in which nothing scatters, is exact with so few directions. */
    options.tolerance = 1e-4;
    options.directions = 96;
    assert_int_equal(murk_solve_many(context, scene, 3, &options, NULL, out), MURK_NOT_REACHED);
    assert_non_null(strstr(murk_context_message(context), "estimated error"));
    for (int n = 0; n < 3; n++)
        assert_int_equal(murk_solution_report(out[n])->reached, n == 2);
    release_solutions(out, 3);
    assert_int_equal(murk_solve_many(context, NULL, 0, NULL, NULL, NULL), MURK_OK);
    release_scenes(scene, 3);
    murk_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(colours),
                                       cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(suns),
                                       cmocka_unit_test(faint_beside_bright),
                                       cmocka_unit_test(lamps),
                                       cmocka_unit_test(one_camera),
                                       cmocka_unit_test(within_the_tolerance),
                                       cmocka_unit_test(thick),
                                       cmocka_unit_test(threads_and_starts),
                                       cmocka_unit_test(scenes_that_differ),
                                       cmocka_unit_test(pairwise),
                                       cmocka_unit_test(failures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
