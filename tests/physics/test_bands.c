/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Scenes solved together: each as if it were alone. With a given number of directions the lines are
 * the same, so that rounding and the last step of an iteration are all that may differ.
 */
#include "bands.h"

static float hot[ZONES]; /* emission [W/m^2] */

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

/* Where voxels are thick one sun tells the others what smaller ones would change: no less than each
   finds by itself. */
static void thick_suns(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    const murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_scene scene[3];
    murk_solution *alone[3], *together[3];
    int told = 0;
    set_cloud(40);
    for (int n = 0; n < 3; n++) {
        scene[n] = (murk_scene){.sun = {.irradiance = 1}};
        scene[n].medium = n ? scene[0].medium : make_medium(context, &COLOURS[0], SIZE, NULL);
        scene[n].sun.direction[0] = n - 1;
        scene[n].sun.direction[2] = -n;
    }
    solve_alone(context, scene, 3, &options, alone);
    solve_together(context, scene, 3, &options, together);
    for (int n = 0; n < 3; n++) {
        const murk_report *report = murk_solution_report(together[n]);
        const murk_report *wanted = murk_solution_report(alone[n]);
        print_message("spatial error %.5f, alone %.5f\n", report->estimate_spatial,
                      wanted->estimate_spatial);
        assert_at_most(difference(together[n], alone[n]), report->estimate + wanted->estimate);
        assert_true(report->estimate_spatial >= wanted->estimate_spatial);
        told += report->estimate_spatial > 1.01 * wanted->estimate_spatial;
    }
    assert_int_equal(told, 2);
    release_solutions(alone, 3);
    release_solutions(together, 3);
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(colours),
                                       cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(suns),
                                       cmocka_unit_test(thick_suns),
                                       cmocka_unit_test(faint_beside_bright),
                                       cmocka_unit_test(lamps),
                                       cmocka_unit_test(one_camera),
                                       cmocka_unit_test(threads_and_starts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
