/* SPDX-License-Identifier: Apache-2.0 */
/* The ground: where patches are, image order, and what it refuses. */
#include "check.h"
#include "ground.h"

static murk_ground_options options_of(murk_up up, bool horizon)
{
    murk_ground_options o = MURK_GROUND_DEFAULT;
    o.up = up;
    o.horizon = horizon;
    o.extent_min[0] = -1;
    o.extent_max[0] = 2;
    o.extent_min[1] = 3;
    o.extent_max[1] = 3.7;
    o.patches[0] = 7;
    o.patches[1] = 3;
    return o;
}

/* Every point lies in the patch whose edges enclose it; edges ascend and areas add up. */
static void look_up(void **state)
{
    for (int horizon = 0; horizon < 2; horizon++) {
        const murk_ground_options o = options_of(MURK_UP_Z, horizon);
        murk_ground *ground = NULL;
        assert_int_equal(murk_ground_create(*state, &o, &ground), MURK_OK);
        uint64_t random = 22;
        double area = 0, low[2], high[2];
        for (int c = 0; c < 2; c++) {
            low[c] = ground->edge[c][0];
            high[c] = ground->edge[c][ground->count[c]];
            for (int i = 0; i < ground->count[c]; i++)
                assert_true(ground->edge[c][i + 1] > ground->edge[c][i]);
        }
        for (size_t i = 0; i < ground->patch_count; i++)
            area += murk_ground_area(ground, i);
        assert_within(area, (high[0] - low[0]) * (high[1] - low[1]), 1e-9 * area);
        for (int n = 0; n < 20000; n++) {
            double stretch = n % 2 ? 1.2 : 0.03; /* far and near */
            double a = 0.5 + stretch * (high[0] - low[0]) * (check_random(&random) - 0.5);
            double b = 3.35 + stretch * (high[1] - low[1]) * (check_random(&random) - 0.5);
            int64_t patch = murk_ground_patch(ground, a, b);
            if (a < low[0] || a >= high[0] || b < low[1] || b >= high[1]) {
                assert_int_equal(patch, horizon ? MURK_GROUND_HORIZON : MURK_GROUND_NOTHING);
                continue;
            }
            assert_true(patch >= 0);
            int ia = (int)(patch % ground->count[0]), ib = (int)(patch / ground->count[0]);
            assert_true(ground->edge[0][ia] <= a + 1e-12 && a < ground->edge[0][ia + 1] + 1e-12);
            assert_true(ground->edge[1][ib] <= b + 1e-12 && b < ground->edge[1][ib + 1] + 1e-12);
        }
        murk_ground_release(ground);
    }
}

/* Row 0 of an image is the far edge: largest y, or smallest z where y is up. */
static void image_order(void **state)
{
    float reflectance[21], emission[21];
    double mean = 0;
    for (int i = 0; i < 21; i++) {
        reflectance[i] = (float)i / 21;
        emission[i] = (float)i;
        mean += i / 21.;
    }
    for (int up_y = 0; up_y < 2; up_y++) {
        murk_ground_options o = options_of(up_y ? MURK_UP_Y : MURK_UP_Z, true);
        o.reflectance_image = reflectance;
        o.emission_image = emission;
        murk_ground *ground = NULL;
        assert_int_equal(murk_ground_create(*state, &o, &ground), MURK_OK);
        for (int row = 0; row < 3; row++)
            for (int column = 0; column < 7; column++) {
                double a = -1 + 3 * (column + 0.5) / 7;
                double b = 3 + 0.7 * ((up_y ? row : 2 - row) + 0.5) / 3;
                int64_t patch = murk_ground_patch(ground, a, b);
                assert_within(ground->reflectance[patch], (7 * row + column) / 21., 1e-7);
                assert_within(ground->emission[patch], 7 * row + column, 0);
            }
        /* Beyond the extent: the means. */
        int64_t outside = murk_ground_patch(ground, -2, 2);
        assert_true(outside >= 0);
        assert_within(ground->reflectance[outside], mean / 21, 1e-6);
        assert_within(ground->mean_emission, 10, 1e-6);
        int patches[2];
        murk_ground_patches(ground, patches);
        assert_int_equal(patches[0], 7);
        assert_int_equal(patches[1], 3);
        murk_ground_release(ground);
    }
}

static void refusals(void **state)
{
    for (int n = 0; n < 7; n++) {
        murk_ground_options o = options_of(MURK_UP_Z, true);
        static const float bad[21] = {[20] = 1.5f};
        o.extent_max[0] = n == 0 ? -1 : o.extent_max[0];
        o.extent_max[1] = n == 1 ? INFINITY : o.extent_max[1];
        o.patches[1] = n == 2 ? 0 : 3;
        o.reflectance = n == 3 ? 1.1 : 0.3;
        o.reflectance_image = n == 4 ? bad : NULL;
        o.emission = n == 5 ? -1 : 0;
        o.height = n == 6 ? NAN : 0;
        murk_ground *ground = NULL;
        assert_int_equal(murk_ground_create(*state, &o, &ground), MURK_ERROR_INPUT);
        assert_null(ground);
        assert_true(strlen(murk_context_message(*state)) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(look_up),
        cmocka_unit_test(image_order),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
