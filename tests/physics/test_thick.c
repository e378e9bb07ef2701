/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Optically thick voxels against the Monte Carlo that scatters light where it was extinguished, at
 * tolerances of 1 % up to 3 optical depths a voxel, and 2 % at 20.
 * The tolerance is about the zones; the ground's distance is printed.
 */
#include "thick.h"

static const struct {
    double depth, albedo, most;
} ROWS[] = {{0.3, 0.99, 0.01}, {1, 0.99, 0.01}, {3, 0.9, 0.01}, {3, 0.99, 0.01}, {20, 0.99, 0.02}};

/* Within 3 standard errors of the Monte Carlo. All rows are printed before one fails. */
static void check_rows(enum thick_shape shape, enum thick_light light)
{
    double excess[sizeof ROWS / sizeof *ROWS];
    for (size_t n = 0; n < sizeof ROWS / sizeof *ROWS; n++) {
        const struct thick_case c = {shape, light, ROWS[n].depth, ROWS[n].albedo};
        struct thick_result r;
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.tolerance = ROWS[n].most;
        thick_run(&c, &options, 400000, 2, &r);
        double most = ROWS[n].most;
        excess[n] = r.zones.squared - most * most - 3 * distance_error(&r.zones, most);
        print_message("%s, %s, albedo %g, %g a voxel: zones %.2f %% (noise %.2f %%), ground %.2f "
                      "%% (%.2f %%), estimate %.2f %%\n",
                      THICK_SHAPE_NAMES[shape], THICK_LIGHT_NAMES[light], c.albedo, c.depth,
                      100 * sqrt(fmax(0, r.zones.squared)), 100 * sqrt(r.zones.error_0),
                      100 * sqrt(fmax(0, r.ground.squared)), 100 * sqrt(r.ground.error_0),
                      100 * r.estimate);
    }
    for (size_t n = 0; n < sizeof ROWS / sizeof *ROWS; n++)
        if (!(excess[n] <= 0))
            fail_msg("albedo %g, %g a voxel: above %g %%", ROWS[n].albedo, ROWS[n].depth,
                     100 * ROWS[n].most);
}

#define ROW(name, shape, light)                                                                    \
    static void name(void **state)                                                                 \
    {                                                                                              \
        (void)state;                                                                               \
        check_rows(shape, light);                                                                  \
    }

ROW(block_sun, THICK_BLOCK, THICK_SUN)
ROW(block_thermal, THICK_BLOCK, THICK_THERMAL)
ROW(random_sun, THICK_RANDOM, THICK_SUN)
ROW(random_thermal, THICK_RANDOM, THICK_THERMAL)
ROW(cloud_sun, THICK_CLOUD, THICK_SUN)
ROW(cloud_thermal, THICK_CLOUD, THICK_THERMAL)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(block_sun),  cmocka_unit_test(block_thermal),
        cmocka_unit_test(random_sun), cmocka_unit_test(random_thermal),
        cmocka_unit_test(cloud_sun),  cmocka_unit_test(cloud_thermal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
