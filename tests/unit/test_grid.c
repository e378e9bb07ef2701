/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks: look-up, numbering, box, transform and dilation. */
#include "sparse.h"

/* Bricks on both sides of the origin: shifts and masks have to round down, not towards 0. */
static const sparse SPARSE = {
    .low = {-3, -2, -4}, .edge = 6, .bricks = 0.3, .voxels = 0.02, .voxel = {1, 1, 1}};

static bool active_at(const murk_grid *grid, int32_t i, int32_t j, int32_t k)
{
    int64_t slot = murk_grid_slot(grid, i, j, k);
    return slot >= 0 && murk_grid_active(grid, (size_t)slot / 512, (int)(slot % 512));
}

static void find(void **state)
{
    uint64_t random = 1;
    murk_grid *grid = sparse_create(*state, &SPARSE, &random);
    assert_true(grid->brick_count > 30);
    for (int32_t x = -5; x < 5; x++)
        for (int32_t y = -5; y < 6; y++)
            for (int32_t z = -6; z < 4; z++) {
                int32_t wanted = MURK_NO_BRICK;
                for (size_t b = 0; b < grid->brick_count; b++)
                    if (grid->brick[b][0] == x && grid->brick[b][1] == y && grid->brick[b][2] == z)
                        wanted = (int32_t)b;
                assert_int_equal(murk_grid_find(grid, x, y, z), wanted);
            }
    assert_int_equal(murk_grid_find(grid, INT32_MAX, INT32_MIN, 0), MURK_NO_BRICK);
    murk_grid_release(grid);
}

/* Slots, the numbering of the zones and the box, each against a loop over all voxels. */
static void numbering(void **state)
{
    uint64_t random = 2;
    murk_grid *grid = sparse_create(*state, &SPARSE, &random);
    size_t zones = 0;
    int32_t lo[3] = {INT32_MAX, INT32_MAX, INT32_MAX}, hi[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    for (size_t b = 0; b < grid->brick_count; b++) {
        assert_int_equal(grid->zone_first[b], zones);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            const int32_t at[3] = {8 * grid->brick[b][0] + slot / 64,
                                   8 * grid->brick[b][1] + slot / 8 % 8,
                                   8 * grid->brick[b][2] + slot % 8};
            assert_int_equal(murk_grid_slot(grid, at[0], at[1], at[2]), (int)b * 512 + slot);
            if (!murk_grid_active(grid, b, slot))
                continue;
            zones++;
            for (int a = 0; a < 3; a++) {
                lo[a] = at[a] < lo[a] ? at[a] : lo[a];
                hi[a] = at[a] >= hi[a] ? at[a] + 1 : hi[a];
            }
        }
    }
    assert_int_equal(grid->zone_count, zones);
    assert_int_equal(grid->zone_first[grid->brick_count], zones);
    for (int a = 0; a < 3; a++) {
        assert_int_equal(grid->lo[a], lo[a]);
        assert_int_equal(grid->hi[a], hi[a]);
    }
    murk_grid_release(grid);
}

static bool near_active(const murk_grid *grid, int margin, int32_t i, int32_t j, int32_t k)
{
    for (int x = -margin; x <= margin; x++)
        for (int y = -margin; y <= margin; y++)
            for (int z = -margin; z <= margin; z++)
                if (active_at(grid, i + x, j + y, k + z))
                    return true;
    return false;
}

static void dilation(void **state)
{
    static const int margins[] = {0, 1, 2, 8};
    const sparse s = {
        .low = {-2, -2, -2}, .edge = 4, .bricks = 0.2, .voxels = 0.004, .voxel = {1, 2, 3}};
    uint64_t random = 3;
    murk_grid *grid = sparse_create(*state, &s, &random);
    assert_true(grid->zone_count > 10);
    for (size_t n = 0; n < sizeof margins / sizeof *margins; n++) {
        murk_grid *wide = NULL;
        size_t count = 0;
        assert_int_equal(murk_grid_dilate(*state, grid, margins[n], &wide), MURK_OK);
        for (int32_t i = -24; i < 24; i++)
            for (int32_t j = -24; j < 24; j++)
                for (int32_t k = -24; k < 24; k++) {
                    bool wanted = near_active(grid, margins[n], i, j, k);
                    count += wanted;
                    assert_int_equal(active_at(wide, i, j, k), wanted);
                }
        assert_int_equal(wide->zone_count, count);
        /* The same place in the world: cell lo + corner. */
        for (int a = 0; a < 3; a++)
            assert_within(wide->corner[a] - wide->lo[a] * wide->voxel[a],
                          grid->corner[a] - grid->lo[a] * grid->voxel[a], 1e-12);
        murk_grid_release(wide);
    }
    murk_grid_release(grid);
}

static murk_bricks one_brick(const double matrix[16])
{
    murk_bricks bricks = {.count = 1,
                          .brick = murk_alloc(1, sizeof *bricks.brick),
                          .mask = murk_alloc(1, sizeof *bricks.mask)};
    bricks.brick[0][0] = 2;
    bricks.mask[0][3] = 1; /* the voxel (19, 0, 0) */
    memcpy(bricks.index_to_world, matrix, sizeof bricks.index_to_world);
    return bricks;
}

/* Turned by 30 degrees about z, voxels 1 x 2 x 3, shifted: the low corner of the voxel (19, 0, 0)
   and a direction there and back. */
static void transform(void **state)
{
    const double c = cos(M_PI / 6), s = sin(M_PI / 6);
    const double matrix[16] = {c, -2 * s, 0, 10, s, 2 * c, 0, 20, 0, 0, 3, 30, 0, 0, 0, 1};
    for (int corner = 0; corner < 2; corner++) {
        murk_bricks bricks = one_brick(matrix);
        murk_grid *grid = NULL;
        assert_int_equal(murk_grid_create(*state, &bricks, corner, &grid), MURK_OK);
        double shift = corner ? 0 : 0.5;
        const double low[3] = {19 - shift, -shift, -shift}, zero[3] = {0};
        double world[3], back[3];
        murk_grid_to_world(grid, zero, world);
        for (int r = 0; r < 3; r++)
            assert_within(world[r],
                          matrix[4 * r] * low[0] + matrix[4 * r + 1] * low[1] +
                              matrix[4 * r + 2] * low[2] + matrix[4 * r + 3],
                          1e-12);
        for (int a = 0; a < 3; a++)
            assert_within(grid->voxel[a], a + 1, 1e-12);
        assert_within(grid->volume, 6, 1e-12);
        const double direction[3] = {0.6, 0, 0.8};
        murk_grid_direction_to_world(grid, direction, world);
        assert_within(world[0], 0.6 * c, 1e-12);
        assert_within(world[1], 0.6 * s, 1e-12);
        assert_within(world[2], 0.8, 1e-12);
        murk_grid_direction_from_world(grid, world, back);
        for (int a = 0; a < 3; a++)
            assert_within(back[a], direction[a], 1e-12);
        murk_grid_to_world(grid, direction, world);
        murk_grid_from_world(grid, world, back);
        for (int a = 0; a < 3; a++)
            assert_within(back[a], direction[a], 1e-12);
        murk_grid_release(grid);
        murk_bricks_clear(&bricks);
    }
}

static void bad_transforms(void **state)
{
    static const double bad[][16] = {
        {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},        /* no size on x */
        {1, 0.3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},      /* sheared */
        {1, 0, 0, INFINITY, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, /* nowhere */
        {NAN, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
    };
    for (size_t n = 0; n < sizeof bad / sizeof *bad; n++) {
        murk_bricks bricks = one_brick(bad[n]);
        murk_grid *grid = NULL;
        assert_int_equal(murk_grid_create(*state, &bricks, false, &grid), MURK_ERROR_INPUT);
        assert_null(grid);
        assert_true(strlen(murk_context_message(*state)) > 0);
        murk_bricks_clear(&bricks);
    }
}

/* Without an active voxel there is no brick and no box. */
static void empty(void **state)
{
    const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    murk_bricks bricks = one_brick(identity);
    bricks.mask[0][3] = 0;
    murk_grid *grid = NULL, *wide = NULL;
    assert_int_equal(murk_grid_create(*state, &bricks, false, &grid), MURK_OK);
    assert_int_equal(murk_grid_dilate(*state, grid, 2, &wide), MURK_OK);
    assert_int_equal(wide->brick_count, 0);
    assert_int_equal(grid->brick_count, 0);
    assert_int_equal(grid->zone_count, 0);
    assert_int_equal(murk_grid_find(grid, 2, 0, 0), MURK_NO_BRICK);
    for (int a = 0; a < 3; a++)
        assert_int_equal(grid->lo[a], grid->hi[a]);
    murk_grid_release(wide);
    murk_grid_release(grid);
    murk_bricks_clear(&bricks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(find),      cmocka_unit_test(numbering),      cmocka_unit_test(dilation),
        cmocka_unit_test(transform), cmocka_unit_test(bad_transforms), cmocka_unit_test(empty),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
