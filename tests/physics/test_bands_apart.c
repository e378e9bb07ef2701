/* SPDX-License-Identifier: Apache-2.0 */
/* Scenes solved together where directions and voxels are the library's choice, scenes that cannot
   be, and what cannot be solved at all. */
#include "bands.h"

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
    const struct CMUnitTest tests[] = {cmocka_unit_test(within_the_tolerance),
                                       cmocka_unit_test(thick),
                                       cmocka_unit_test(scenes_that_differ),
                                       cmocka_unit_test(pairwise), cmocka_unit_test(failures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
