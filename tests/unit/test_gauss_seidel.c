/* SPDX-License-Identifier: Apache-2.0 */
/* The iteration of the paper on its own sample case. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "exchange_box.h"
#include "gauss_seidel.h"

#ifndef MURK_TEST_DATA
#define MURK_TEST_DATA "tests/physics/data"
#endif

static const box_options PAPER = PAPER_BOX;

typedef struct paper_error {
    double zones, patches;
    int iterations;
} paper_error;

/* Relative L2 errors against the reference; *x gets the radiosities if not NULL. */
static paper_error solve_paper(const box_options *options, double *result)
{
    box_options o = *options;
    float reflectance[100];
    for (int i = 0; i < 100; i++)
        reflectance[i] = i / 10 >= 3 && i / 10 < 7 && i % 10 >= 3 && i % 10 < 7 ? 0.6f : 0.3f;
    o.reflectance = reflectance;
    box b;
    open_box(&b, &o);
    size_t n = b.zones + b.patches;
    double *source = murk_alloc(2 * n, sizeof *source), *x = source + n;
    double layer = 0.8 * 0.05; /* the sun overhead: exp(-depth), averaged over each layer */
    for (size_t k = 0; k < b.zones; k++)
        source[k] = 0.625 / 4 * exp(-layer * (9 - b.cell[k][2])) * -expm1(-layer) / layer;
    for (size_t i = 0; i < b.patches; i++)
        source[b.zones + i] = b.ground->reflectance[i] * exp(-10 * layer);
    memcpy(x, source, n * sizeof *x);
    paper_error error = {0};
    double change;
    assert_int_equal(murk_gauss_seidel(b.context, &murk_exchange_pairwise, b.operator, b.medium,
                                       b.ground, source, 1e-9, 100, x, &error.iterations, &change),
                     MURK_OK);
    assert_true(change < 1e-9);
    FILE *file = fopen(MURK_TEST_DATA "/paper_box.csv", "r");
    assert_non_null(file);
    char line[256];
    double sums[2][2] = {{0, 0}, {0, 0}};
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        char type;
        int i, j, k;
        double wanted;
        assert_int_equal(sscanf(line, "%c,%d,%d,%d,%lf", &type, &i, &j, &k, &wanted), 5);
        size_t e = b.zones + (size_t)(10 * j + i);
        for (size_t z = 0; type == 'V' && z < b.zones; z++)
            if (b.cell[z][0] == i && b.cell[z][1] == j && b.cell[z][2] == k)
                e = z;
        sums[type == 'V'][0] += (x[e] - wanted) * (x[e] - wanted);
        sums[type == 'V'][1] += wanted * wanted;
    }
    fclose(file);
    error.zones = sqrt(sums[1][0] / sums[1][1]);
    error.patches = sqrt(sums[0][0] / sums[0][1]);
    if (result)
        memcpy(result, x, n * sizeof *x);
    murk_free(source);
    close_box(&b);
    return error;
}

static void paper_by_offset(void **state)
{
    (void)state;
    paper_error error = solve_paper(&PAPER, NULL);
    print_message("error of zones %.4f %%, patches %.4f %%, %d iterations\n", 100 * error.zones,
                  100 * error.patches, error.iterations);
    assert_true(error.zones < 0.0005);
    assert_true(error.patches < 0.0005);
    assert_in_range(error.iterations, 5, 16);
}

static void paper_zone_by_zone(void **state)
{
    (void)state;
    box_options o = PAPER;
    static double table[1100], matrix[1100];
    o.perturb = true;
    paper_error error = solve_paper(&o, matrix);
    print_message("error of zones %.4f %%, patches %.4f %%, %d iterations\n", 100 * error.zones,
                  100 * error.patches, error.iterations);
    assert_true(error.zones < 0.0015);
    assert_true(error.patches < 0.0015);
    solve_paper(&PAPER, table);
    for (size_t e = 0; e < 1100; e++)
        assert_true(fabs(matrix[e] - table[e]) < 0.005 * table[e]);
}

/* A window that holds everything changes nothing; a smaller one loses light. */
static void window(void **state)
{
    (void)state;
    static double full[1100], cut[1100], wide[1100];
    box_options o = PAPER;
    solve_paper(&o, full);
    for (int a = 0; a < 3; a++)
        o.window[a] = 20;
    solve_paper(&o, wide);
    for (int a = 0; a < 3; a++)
        o.window[a] = 6;
    solve_paper(&o, cut);
    double loss = 0;
    for (size_t e = 0; e < 1100; e++) {
        assert_true(fabs(wide[e] - full[e]) < 1e-12);
        assert_true(cut[e] < full[e]);
        loss = fmax(loss, 1 - cut[e] / full[e]);
    }
    assert_true(loss > 0.01 && loss < 0.2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paper_by_offset),
        cmocka_unit_test(paper_zone_by_zone),
        cmocka_unit_test(window),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
