/* SPDX-License-Identifier: Apache-2.0 */
/* The sample case of [BG91] section 5, figure 1, against reference values that two independent
   programs agree on (data/README.md): relative accuracy 2.5e-5 or better. */
#include "check.h"

#define RELATIVE(errors) sqrt((errors)[0] / (errors)[1])

static void open_paper(struct world *w)
{
    const murk_array array = {.size = {10, 10, 10},
                              .voxel_size = {0.1, 0.1, 0.05},
                              .kappa_t_value = 0.8,
                              .albedo_value = 0.625}; /* (0.8 - 0.3) / 0.8 */
    float reflectance[100];
    for (int i = 0; i < 100; i++) /* the square is symmetric: image order does not matter */
        reflectance[i] = i % 10 >= 3 && i % 10 < 7 && i / 10 >= 3 && i / 10 < 7 ? 0.6f : 0.3f;
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = ground.patches[1] = 10;
    ground.reflectance_image = reflectance;
    ground.horizon = false;
    world_open(w, 2, &array, &ground);
    w->scene.sun = (murk_sun){{0, 0, -1}, 1};
}

/* L2 errors of the zones (all of one kappa_t V) and patches against the reference. */
static void check_paper(const struct world *w, double zones, double patches)
{
    float ground[100];
    assert_int_equal(murk_solution_ground(w->solution, ground), MURK_OK);
    FILE *file = fopen(MURK_TEST_DATA "/paper_box.csv", "r");
    assert_non_null(file);
    char line[256], type;
    double zone[2] = {0}, patch[2] = {0}, reference;
    int i, j, k, rows = 0;
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        assert_int_equal(sscanf(line, "%c,%d,%d,%d,%lf", &type, &i, &j, &k, &reference), 5);
        double value = type == 'V' ? world_b(w, i, j, k) : ground[(9 - j) * 10 + i];
        double *sum = type == 'V' ? zone : patch;
        sum[0] += (value - reference) * (value - reference);
        sum[1] += reference * reference;
        rows++;
    }
    fclose(file);
    assert_int_equal(rows, 1000 + 100);
    print_message("zones %.3f %%, ground %.3f %%\n", 100 * RELATIVE(zone), 100 * RELATIVE(patch));
    assert_at_most(RELATIVE(zone), zones);
    assert_at_most(RELATIVE(patch), patches);
}

static void lines(void **state)
{
    (void)state;
    struct world w;
    open_paper(&w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 1536;
    options.rays = 2;
    options.tolerance = 1e-4;
    world_solve(&w, &options);
    check_paper(&w, 0.005, 0.003);
    world_close(&w);
}

/* The default call: what it claims is what it gets. */
static void by_tolerance(void **state)
{
    (void)state;
    struct world w;
    open_paper(&w);
    world_solve(&w, NULL);
    const murk_report *report = murk_solution_report(w.solution);
    assert_true(report->reached);
    assert_at_most(report->estimate, 0.01);
    check_paper(&w, 0.01, 0.01);
    world_close(&w);
}

static void pairwise(void **state)
{
    (void)state;
    struct world w;
    open_paper(&w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.method = MURK_PAIRWISE;
    options.tolerance = 1e-5;
    world_solve(&w, &options);
    check_paper(&w, 0.001, 0.001);
    world_close(&w);
}

/* The paper took 13 sweeps to epsilon = 1e-9. Its printed factors are 28 % off (data/README.md) and
   leave out the self-factor, which here is solved for on the diagonal: a little fewer suffice. */
static void gauss_seidel(void **state)
{
    (void)state;
    struct world w;
    open_paper(&w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.method = MURK_PAIRWISE;
    options.solver = MURK_GAUSS_SEIDEL;
    options.epsilon = 1e-9;
    world_solve(&w, &options);
    const murk_report *report = murk_solution_report(w.solution);
    assert_in_range(report->iterations, 7, 13);
    /* [BG91] eq. (18): every zone with every zone and patch, every patch with every zone. */
    assert_within(report->multiplications, 1000. * 1000 + 2 * 1000 * 100, 0.5);
    check_paper(&w, 0.001, 0.001);
    world_close(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines),
        cmocka_unit_test(by_tolerance),
        cmocka_unit_test(pairwise),
        cmocka_unit_test(gauss_seidel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
