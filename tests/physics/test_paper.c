/* SPDX-License-Identifier: Apache-2.0 */
/* The sample case of [BG91] section 5, figure 1, against reference values that two independent
   programs agree on (data/README.md): relative accuracy 2.5e-5 or better. */
#include "references.h"

static void check_paper(const struct world *w, double zones, double patches)
{
    struct reference_error e = reference_box_error(w);
    print_message("zones %.3f %%, ground %.3f %%\n", 100 * e.zones, 100 * e.ground);
    assert_at_most(e.zones, zones);
    assert_at_most(e.ground, patches);
}

static void lines(void **state)
{
    (void)state;
    struct world w;
    reference_box_open(10, 2, &w);
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
    reference_box_open(10, 2, &w);
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
    reference_box_open(10, 2, &w);
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
    reference_box_open(10, 2, &w);
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
