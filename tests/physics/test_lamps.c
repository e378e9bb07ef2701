/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Small bright sources by lines: no ray effects. Held against pairwise, whose factors know no
 * directions, and in a larger medium against many more directions.
 */
#include "check.h"

enum { MOST = 32 };

static float kappa_t[MOST * MOST * MOST], emission[MOST * MOST * MOST];

/* A cloud of so many optical depths, about, and perhaps eight hot voxels in it; edges of 1 m. */
static murk_medium *make_cloud(murk_context *context, int size, double depth, bool hot)
{
    for (int n = 0; n < size * size * size; n++) {
        double x = (double)(n / (size * size)) / size, y = (double)(n / size % size) / size,
               z = (double)(n % size) / size;
        kappa_t[n] = (float)(depth * (1 + 0.6 * sin(9 * x + 1) * cos(7 * y) * sin(8 * z + 2)));
        emission[n] = 0;
    }
    int at = size / 3;
    for (int n = 0; hot && n < 8; n++)
        emission[((at + (n & 1)) * size + at + (n >> 1 & 1)) * size + at + (n >> 2)] = 100;
    const murk_array array = {.size = {size, size, size},
                              .voxel_size = {1. / size, 1. / size, 1. / size},
                              .kappa_t = kappa_t,
                              .emission = hot ? emission : NULL,
                              .albedo_value = 0.9};
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_array(context, &array, &medium), MURK_OK);
    return medium;
}

/* The part of the zones and patches that is within 5 % of another solution. */
static double within(const murk_solution *solution, const murk_solution *wanted, int size)
{
    int good = 0;
    for (int n = 0; n < size * size * size; n++) {
        const int32_t at[3] = {n / (size * size), n / size % size, n % size};
        double b = murk_solution_radiosity(wanted, at);
        good += fabs(murk_solution_radiosity(solution, at) - b) <= 0.05 * b;
    }
    return (double)good / (size * size * size);
}

static murk_solution *solve(murk_context *context, const murk_scene *scene,
                            const murk_solve_options *options)
{
    murk_solution *solution = NULL;
    murk_status status = murk_solve(context, scene, options, &solution);
    assert_true(status == MURK_OK || status == MURK_NOT_REACHED);
    return solution;
}

/* Lines at a tolerance of 1 % against pairwise; gives the number of lamps. */
static uint64_t check_pairwise(murk_context *context, const murk_scene *scene, int size)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_solution *lines = solve(context, scene, &options);
    options.method = MURK_PAIRWISE;
    murk_solution *pairwise = solve(context, scene, &options);
    const murk_report *report = murk_solution_report(lines);
    const murk_report *wanted = murk_solution_report(pairwise);
    double good = within(lines, pairwise, size);
    print_message("%g %% of the zones within 5 %%, %d directions\n", 100 * good,
                  report->directions);
    assert_true(good >= 0.95);
    assert_true(report->reached);
    assert_at_most(report->energy_balance, 1e-5);
    assert_within(report->energy_absorbed / wanted->energy_absorbed, 1, 0.01);
    assert_within(report->energy_escaped / wanted->energy_escaped, 1, 0.01);
    assert_within(report->energy_emitted, wanted->energy_emitted, 1e-6 * wanted->energy_emitted);
    assert_within(report->energy_diffuse, wanted->energy_diffuse, 0.01 * wanted->energy_diffuse);
    assert_int_equal(wanted->lamps, 0);
    uint64_t lamps = report->lamps;
    murk_solution_release(lines);
    murk_solution_release(pairwise);
    return lamps;
}

/* So thin a voxel that pairwise has no need of slopes. */
static void hot_spot(void **state)
{
    (void)state;
    enum { SIZE = 11 };
    murk_context *context = check_context(0, NULL);
    murk_medium *medium = make_cloud(context, SIZE, 2, true);
    assert_int_equal(check_pairwise(context, &(murk_scene){.medium = medium}, SIZE), 8);
    murk_medium_release(medium);
    murk_context_release(context);
}

/* One patch of 256 shines. */
static void bright_patch(void **state)
{
    (void)state;
    enum { SIZE = 11, PATCHES = 16 };
    float glow[PATCHES * PATCHES] = {0};
    glow[5 * PATCHES + 9] = 100;
    murk_context *context = check_context(0, NULL);
    murk_medium *medium = make_cloud(context, SIZE, 4, false);
    murk_ground_options options = MURK_GROUND_DEFAULT;
    murk_ground *ground = NULL;
    options.height = -0.2;
    for (int c = 0; c < 2; c++) {
        options.extent_max[c] = 1;
        options.patches[c] = PATCHES;
    }
    options.emission_image = glow;
    options.horizon = false;
    assert_int_equal(murk_ground_create(context, &options, &ground), MURK_OK);
    const murk_scene scene = {.medium = medium, .ground = ground};
    assert_int_equal(check_pairwise(context, &scene, SIZE), 1);
    murk_ground_release(ground);
    murk_medium_release(medium);
    murk_context_release(context);
}

static void hot_spot_in_a_large_cloud(void **state)
{
    (void)state;
    murk_context *context = check_context(0, NULL);
    murk_medium *medium = make_cloud(context, MOST, 4, true);
    const murk_scene scene = {.medium = medium};
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_solution *lines = solve(context, &scene, &options);
    options.tolerance = 1e-3;
    options.directions = 4800;
    murk_solution *wanted = solve(context, &scene, &options);
    double good = within(lines, wanted, MOST);
    print_message("%g %% of the zones within 5 %%\n", 100 * good);
    assert_true(good >= 0.95);
    assert_int_equal(murk_solution_report(lines)->lamps, 8);
    assert_at_most(murk_solution_report(lines)->energy_balance, 1e-5);
    murk_solution_release(lines);
    murk_solution_release(wanted);
    murk_medium_release(medium);
    murk_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(hot_spot), cmocka_unit_test(bright_patch),
                                       cmocka_unit_test(hot_spot_in_a_large_cloud)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
