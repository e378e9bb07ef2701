/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange factors against independent values and against what they must sum to. */
#include "context.h"
#include "factor_far.h"
#include "factor_offset.h"
#include "multiplications.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#ifndef MURK_TEST_DATA
#define MURK_TEST_DATA "tests/physics/data"
#endif

static void assert_close(double value, double wanted, double relative)
{
    if (!(fabs(value - wanted) <= relative * fabs(wanted)))
        fail_msg("%.12g is not %.12g within %g", value, wanted, relative);
}

static void fractions_of_a_cube(void **state)
{
    (void)state;
    FILE *file = fopen(MURK_TEST_DATA "/exchange_fractions_cube.csv", "r");
    assert_non_null(file);
    char line[512];
    assert_non_null(fgets(line, sizeof line, file));
    static const int offset[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, -1}, {1, -1, 1}};
    static const double size[3] = {0.5, 0.5, 0.5};
    int rows = 0;
    while (fgets(line, sizeof line, file)) {
        double tau, wanted[4];
        assert_int_equal(
            sscanf(line, "%lf,%lf,%lf,%lf,%lf", &tau, wanted, wanted + 1, wanted + 2, wanted + 3),
            5);
        for (int i = 0; i < 4; i++) {
            double kappa = tau / size[0];
            double factor = kappa * kappa * murk_factor_offset_zone(size, offset[i], kappa);
            assert_close(factor / (4 * kappa * 0.125), wanted[i], 1e-6);
        }
        rows++;
    }
    fclose(file);
    assert_int_equal(rows, 21);
}

/* In an endless medium a zone exchanges all its light with zones. */
static double row_sum(const double size[3], const int reach[3], double kappa)
{
    double sum = 0;
    for (int x = 0; x <= reach[0]; x++)
        for (int y = 0; y <= reach[1]; y++)
            for (int z = 0; z <= reach[2]; z++) {
                const int offset[3] = {x, y, z};
                int images = (x ? 2 : 1) * (y ? 2 : 1) * (z ? 2 : 1);
                sum += images * murk_factor_offset_zone(size, offset, kappa);
            }
    return sum * kappa / (4 * size[0] * size[1] * size[2]);
}

static void endless_medium(void **state)
{
    (void)state;
    assert_close(row_sum((double[]){1, 1, 1}, (int[]){30, 30, 30}, 0.8), 1, 1e-7);
    assert_close(row_sum((double[]){0.1, 0.1, 0.05}, (int[]){8, 8, 16}, 30), 1, 1e-7);
    assert_close(row_sum((double[]){1, 0.5, 0.05}, (int[]){8, 16, 160}, 3), 1, 1e-7);
    assert_close(row_sum((double[]){1, 1, 1}, (int[]){3, 3, 3}, 50), 1, 1e-7);
}

/* Under an endless layer all light of a patch meets zones. */
static void endless_layer(void **state)
{
    (void)state;
    static const double size[3] = {1, 1, 0.5}, gaps[] = {0, 0.001, 0.03};
    for (size_t g = 0; g < 3; g++) {
        double sum = 0, kappa = 2;
        for (int x = 0; x <= 30; x++)
            for (int y = 0; y <= 30; y++)
                for (int z = 0; z < 24; z++) {
                    const int offset[3] = {x, y, z};
                    sum += (x ? 2 : 1) * (y ? 2 : 1) *
                           murk_factor_offset_patch(size, offset, gaps[g], kappa);
                }
        /* Light more than 30 patches off without having met the layer is missing. */
        assert_close(kappa * sum, 1, 2e-6);
    }
}

/* A face is a patch: what a zone sends through its bottom is what the layer below takes. */
static void patch_and_zones_agree(void **state)
{
    (void)state;
    static const double size[3] = {1, 0.7, 0.4};
    double kappa = 1.3, through = 0, below = 0;
    for (int x = -24; x <= 24; x++)
        for (int y = -34; y <= 34; y++) {
            const int offset[3] = {x, y, 1};
            through += murk_factor_offset_patch(size, offset, 0, kappa);
            for (int z = 0; z < 60; z++) {
                const int zone[3] = {x, y, 2 + z};
                below += kappa * murk_factor_offset_zone(size, zone, kappa);
            }
        }
    assert_close(below, through, 1e-6);
}

static void far_matches_near(void **state)
{
    (void)state;
    static const double size[3] = {1, 0.8, 0.5};
    static const int offset[4][3] = {{8, 0, 0}, {0, 0, 16}, {6, 7, 3}, {20, 10, -30}};
    for (int i = 0; i < 4; i++) {
        double distance[3];
        for (int a = 0; a < 3; a++)
            distance[a] = offset[i][a] * size[a];
        assert_close(murk_far_geometry(size, distance), murk_factor_offset_zone(size, offset[i], 0),
                     1e-4);
    }
}

static void multiplications(void **state)
{
    (void)state;
    static const int m[3] = {10, 10, 4}; /* the paper's 100 x 100 x 10 zones, section 5 */
    assert_close(murk_multiplications_full(1e5, 1e4), 1.2e10, 1e-12);
    assert_close(murk_multiplications_window(1e5, 1e4, m), 6e7, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fractions_of_a_cube), cmocka_unit_test(endless_medium),
        cmocka_unit_test(endless_layer),       cmocka_unit_test(patch_and_zones_agree),
        cmocka_unit_test(far_matches_near),    cmocka_unit_test(multiplications),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
