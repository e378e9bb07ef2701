/* SPDX-License-Identifier: Apache-2.0 */
/* Media from arrays and bricks: which voxels are zones, what they hold, what is refused. */
#include "check.h"
#include "medium.h"

enum { NX = 11, NY = 5, NZ = 9, COUNT = NX * NY * NZ };

static void zones(void **state)
{
    static float kappa_t[COUNT], albedo[COUNT], emission[COUNT];
    uint64_t random = 23;
    size_t count = 0;
    for (int i = 0; i < COUNT; i++) {
        kappa_t[i] = check_random(&random) < 0.5 ? 0 : (float)check_random(&random);
        albedo[i] = (float)check_random(&random);
        emission[i] = (float)check_random(&random);
        count += kappa_t[i] > 0;
    }
    const murk_array array = {.size = {NX, NY, NZ},
                              .voxel_size = {1, 2, 3},
                              .origin = {10, 20, 30},
                              .kappa_t = kappa_t,
                              .albedo = albedo,
                              .emission = emission};
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_array(*state, &array, &medium), MURK_OK);
    const murk_grid *grid = medium->grid;
    assert_int_equal(grid->zone_count, count);
    assert_int_equal(medium->input->zone_count, COUNT);
    for (int n = 0; n < COUNT; n++) {
        int64_t slot = murk_grid_slot(grid, n / (NY * NZ), n / NZ % NY, n % NZ);
        assert_true(slot >= 0);
        bool zone = kappa_t[n] > 0;
        assert_int_equal(murk_grid_active(grid, (size_t)slot / 512, (int)(slot % 512)), zone);
        assert_within(medium->kappa_t[slot], kappa_t[n], 0);
        if (zone) {
            assert_within(murk_value(&medium->albedo, (size_t)slot), albedo[n], 0);
            assert_within(murk_value(&medium->emission, (size_t)slot), emission[n], 0);
        }
    }
    murk_medium_info info;
    assert_int_equal(murk_medium_info_get(medium, &info), MURK_OK);
    assert_int_equal(info.zones, count);
    assert_int_equal(info.input_voxels, COUNT);
    assert_int_equal(info.invalid_voxels, 0);
    for (int a = 0; a < 3; a++) {
        assert_within(info.voxel_size[a], a + 1, 1e-12);
        assert_within(info.box_min[a], 10 * (a + 1), 1e-9);
        assert_within(info.box_max[a], 10 * (a + 1) + array.size[a] * (a + 1), 1e-9);
    }
    murk_medium *shared = murk_medium_share(medium);
    murk_medium_release(medium);
    assert_int_equal(shared->grid->zone_count, count); /* still there */
    murk_medium_release(shared);
    murk_medium_release(NULL);
}

/* Depths along the shortest axis, y here: kappa_t = 1 in one column of 3 voxels, 4 in one of 1. */
static void depths(void **state)
{
    static float kappa_t[COUNT];
    memset(kappa_t, 0, sizeof kappa_t);
    const murk_array array = {.size = {NX, NY, NZ}, .voxel_size = {1, 0.5, 1}, .kappa_t = kappa_t};
    for (int j = 0; j < 3; j++)
        kappa_t[check_at(&array, 0, j, 0)] = 1;
    kappa_t[check_at(&array, 10, 4, 8)] = 4;
    murk_medium *medium = NULL;
    murk_medium_info info;
    assert_int_equal(murk_medium_from_array(*state, &array, &medium), MURK_OK);
    assert_int_equal(murk_medium_info_get(medium, &info), MURK_OK);
    assert_within(info.kappa_t_max, 4, 0);
    assert_within(info.max_depth, 4 * 0.5, 1e-6);
    assert_within(info.mean_depth, (3 * 0.5 + 4 * 0.5) / 2, 1e-6);
    murk_medium_release(medium);
}

static void empty(void **state)
{
    const murk_array array = {.size = {4, 4, 4}, .voxel_size = {1, 1, 1}, .kappa_t_value = 0};
    murk_medium *medium = NULL;
    murk_medium_info info;
    assert_int_equal(murk_medium_from_array(*state, &array, &medium), MURK_OK);
    assert_int_equal(murk_medium_info_get(medium, &info), MURK_OK);
    assert_int_equal(info.zones, 0);
    assert_int_equal(info.input_voxels, 64);
    murk_medium_release(medium);
}

static void refusals(void **state)
{
    static float bad[8];
    static const float values[] = {NAN, INFINITY, -1};
    for (int n = 0; n < 11; n++) {
        murk_array array = {
            .size = {2, 2, 2}, .voxel_size = {1, 1, 1}, .kappa_t_value = 1, .albedo_value = 0.5};
        bad[3] = n < 9 ? values[n % 3] : 0;
        array.kappa_t = n < 3 ? bad : NULL;
        array.albedo = n >= 3 && n < 6 ? bad : NULL;
        array.emission = n >= 6 && n < 9 ? bad : NULL;
        array.albedo_value = n == 9 ? 1.01 : 0.5;
        array.size[1] = n == 10 ? 0 : 2;
        murk_medium *medium = NULL;
        assert_int_equal(murk_medium_from_array(*state, &array, &medium), MURK_ERROR_INPUT);
        assert_null(medium);
        assert_true(strlen(murk_context_message(*state)) > 0);
    }
}

/* The bricks of an array, the last of them first, give what the array does; zeros are not active.
 */
static void bricks(void **state)
{
    enum { BRICKS = 2 * 1 * 2, SLOTS = 512 };
    static float dense[3][COUNT], sparse[3][BRICKS * SLOTS];
    int32_t brick[3 * BRICKS];
    uint64_t random = 29;
    for (int n = 0; n < COUNT; n++)
        for (int f = 0; f < 3; f++)
            dense[f][n] = check_random(&random) < 0.5 ? 0 : (float)check_random(&random);
    const murk_array array = {.size = {NX, NY, NZ},
                              .voxel_size = {1, 2, 3},
                              .origin = {10, 20, 30},
                              .kappa_t = dense[0],
                              .albedo = dense[1],
                              .emission = dense[2]};
    for (int b = 0; b < BRICKS; b++) {
        int32_t *at = &brick[3 * (BRICKS - 1 - b)];
        at[0] = b / 2;
        at[1] = 0;
        at[2] = b % 2;
    }
    for (int n = 0; n < COUNT; n++) {
        int i = n / (NY * NZ), j = n / NZ % NY, k = n % NZ;
        int b = BRICKS - 1 - (2 * (i / 8) + k / 8);
        for (int f = 0; f < 3; f++)
            sparse[f][SLOTS * b + 64 * (i % 8) + 8 * j + k % 8] = dense[f][n];
    }
    murk_brick_array from = {.count = BRICKS,
                             .brick = brick,
                             .voxel_size = {1, 2, 3},
                             .origin = {10, 20, 30},
                             .kappa_t = sparse[0],
                             .albedo = sparse[1],
                             .emission = sparse[2]};
    murk_medium *a = NULL, *b = NULL;
    murk_medium_info info, wanted;
    assert_int_equal(murk_medium_from_array(*state, &array, &a), MURK_OK);
    assert_int_equal(murk_medium_from_bricks(*state, &from, &b), MURK_OK);
    murk_medium_info_get(a, &wanted);
    murk_medium_info_get(b, &info);
    assert_int_equal(info.input_voxels, wanted.zones);
    wanted.input_voxels = info.input_voxels;
    assert_memory_equal(&info, &wanted, sizeof info);
    size_t slots = a->grid->brick_count * SLOTS;
    assert_memory_equal(a->grid->mask, b->grid->mask, slots / 8);
    assert_memory_equal(a->kappa_t, b->kappa_t, slots * sizeof(float));
    assert_memory_equal(a->albedo.field, b->albedo.field, slots * sizeof(float));
    assert_memory_equal(a->emission.field, b->emission.field, slots * sizeof(float));
    murk_medium_release(a);
    murk_medium_release(b);

    b = NULL;
    sparse[0][5] = NAN;
    assert_int_equal(murk_medium_from_bricks(*state, &from, &b), MURK_ERROR_INPUT);
    sparse[0][5] = 0;
    memcpy(&brick[3], &brick[9], 3 * sizeof *brick);
    assert_int_equal(murk_medium_from_bricks(*state, &from, &b), MURK_ERROR_INPUT);
    assert_string_equal(murk_context_message(*state), "bricks: brick (0, 0, 0) is there twice");
    assert_null(b);
    from.count = 0;
    assert_int_equal(murk_medium_from_bricks(*state, &from, &b), MURK_OK);
    murk_medium_info_get(b, &info);
    assert_int_equal(info.zones, 0);
    murk_medium_release(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zones),    cmocka_unit_test(depths), cmocka_unit_test(empty),
        cmocka_unit_test(refusals), cmocka_unit_test(bricks),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
