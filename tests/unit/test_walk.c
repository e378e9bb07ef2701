/* SPDX-License-Identifier: Apache-2.0 */
/* The walk along a ray against cutting the ray at every voxel face there is. */
#include "sparse.h"
#include "walk.h"

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Adds the length of the ray in every voxel of an existing brick to length[slot]: all crossings
   with all faces in order, each piece in the voxel of its middle. */
static void cut(const murk_grid *grid, const double origin[3], const double direction[3],
                double t_min, double t_max, double *length)
{
    double t[512];
    int count = 0;
    t[count++] = t_min;
    t[count++] = t_max;
    for (int a = 0; a < 3; a++)
        for (int32_t i = grid->lo[a] - 8; direction[a] != 0 && i <= grid->hi[a] + 8; i++) {
            double at = ((i - grid->lo[a]) * grid->voxel[a] - origin[a]) / direction[a];
            if (at > t_min && at < t_max)
                t[count++] = at;
        }
    qsort(t, (size_t)count, sizeof *t, compare);
    for (int n = 1; n < count; n++) {
        double middle = (t[n - 1] + t[n]) / 2;
        int32_t cell[3];
        bool inside = t[n] - t[n - 1] > 1e-12;
        for (int a = 0; a < 3; a++) {
            cell[a] =
                (int32_t)floor((origin[a] + middle * direction[a]) / grid->voxel[a]) + grid->lo[a];
            inside = inside && cell[a] >= grid->lo[a] && cell[a] < grid->hi[a];
        }
        int64_t slot = inside ? murk_grid_slot(grid, cell[0], cell[1], cell[2]) : -1;
        if (slot >= 0)
            length[slot] += t[n] - t[n - 1];
    }
}

static void check_ray(const murk_grid *grid, const double origin[3], const double direction[3],
                      double t_min, double t_max)
{
    size_t slots = grid->brick_count * MURK_BRICK_SLOTS;
    double *length = murk_alloc(2 * slots, sizeof *length), *wanted = length + slots;
    cut(grid, origin, direction, t_min, t_max, wanted);
    murk_walk walk;
    murk_step step;
    double last = -INFINITY;
    murk_walk_start(&walk, grid, origin, direction, t_min, t_max);
    while (murk_walk_next(&walk, &step)) {
        assert_true(step.t0 >= last && step.t1 > step.t0);
        assert_true(step.t0 >= t_min && step.t1 <= t_max);
        last = step.t1;
        length[step.brick * MURK_BRICK_SLOTS + step.slot] += step.t1 - step.t0;
    }
    /* Rounding: lengths up to 100 in doubles. */
    for (size_t i = 0; i < slots; i++)
        assert_within(length[i], wanted[i], 1e-10);
    murk_free(length);
}

static const sparse SPARSE = {
    .low = {-2, -1, -2}, .edge = 4, .bricks = 0.4, .voxels = 0.2, .voxel = {0.5, 1, 0.25}};

static void random_rays(void **state)
{
    uint64_t random = 4;
    for (int n = 0; n < 10; n++) {
        murk_grid *grid = sparse_create(*state, &SPARSE, &random);
        for (int ray = 0; ray < 200; ray++) {
            double origin[3], direction[3];
            check_direction(&random, direction);
            for (int a = 0; a < 3; a++) /* inside and outside */
                origin[a] = (2 * check_random(&random) - 0.5) * grid->voxel[a] * 32;
            double t_min = ray % 3 ? 0 : 10 * check_random(&random);
            check_ray(grid, origin, direction, t_min,
                      t_min + (ray % 2 ? 60 : 15 * check_random(&random)));
        }
        murk_grid_release(grid);
    }
}

/* Along the axes and the diagonals, inside voxels and along faces and edges: a face belongs to the
   voxel above it, as its index is rounded down. */
static void straight_rays(void **state)
{
    sparse s = SPARSE;
    for (int a = 0; a < 3; a++)
        s.voxel[a] = 1; /* a diagonal meets several faces at the same place */
    uint64_t random = 5;
    murk_grid *grid = sparse_create(*state, &s, &random);
    for (int n = 0; n < 27; n++) {
        double direction[3] = {n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
        double size = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                           direction[2] * direction[2]);
        if (n == 13)
            continue;
        for (int ray = 0; ray < 60; ray++) {
            double origin[3], unit[3];
            for (int a = 0; a < 3; a++) {
                unit[a] = direction[a] / size;
                origin[a] = floor(30 * check_random(&random)) + (ray % 2 ? 0.25 * (a + 1) : 0);
                if (ray % 3 == 0)
                    origin[a] -= 40 * direction[a];
            }
            check_ray(grid, origin, unit, 0, 200);
        }
    }
    murk_grid_release(grid);
}

/* Through a full box of 3 x 4 x 5 voxels of 0.5 x 0.25 x 2 m with kappa_t = 1 + x + 10 y + 100 z:
   the lengths are known. */
static void depth(void **state)
{
    murk_grid *grid = NULL;
    murk_bricks bricks = {.count = 1,
                          .brick = murk_alloc(1, sizeof *bricks.brick),
                          .mask = murk_alloc(1, sizeof *bricks.mask),
                          .index_to_world = {[0] = 0.5, [5] = 0.25, [10] = 2, [15] = 1}};
    float kappa_t[MURK_BRICK_SLOTS] = {0};
    for (int x = 0; x < 3; x++)
        for (int y = 0; y < 4; y++)
            for (int z = 0; z < 5; z++) {
                bricks.mask[0][x] |= (uint64_t)1 << (8 * y + z);
                kappa_t[64 * x + 8 * y + z] = (float)(1 + x + 10 * y + 100 * z);
            }
    assert_int_equal(murk_grid_create(*state, &bricks, true, &grid), MURK_OK);
    const struct {
        double origin[3], direction[3], t_min, t_max, depth;
    } rays[] = {
        /* up the column (1, 2): kappa 22, 122, 222, 322, 422 for 2 m each */
        {{0.6, 0.6, -3}, {0, 0, 1}, 0, 100, 2 * (22 + 122 + 222 + 322 + 422)},
        {{0.6, 0.6, 20}, {0, 0, -1}, 0, 100, 2 * (22 + 122 + 222 + 322 + 422)},
        /* from z = 1 to z = 5 */
        {{0.6, 0.6, 0}, {0, 0, 1}, 1, 5, 22 * 1 + 122 * 2 + 222 * 1},
        /* along x at y = 3, z = 4: kappa 431, 432, 433 for 0.5 m each */
        {{-1, 0.9, 9}, {1, 0, 0}, 0, 100, 0.5 * (431 + 432 + 433)},
        /* in the plane z = 0 at 3:4 through (0, 0): y grows by 0.25 every 0.3125 m, x by 0.5 every
           0.8333 m; out at y = 1, t = 1.25 */
        {{0, 0, 1},
         {0.6, 0.8, 0},
         0,
         100,
         0.3125 * (1 + 11) + (0.5 / 0.6 - 0.625) * 21 + (0.9375 - 0.5 / 0.6) * 22 + 0.3125 * 32},
        {{0.6, -1, 1}, {0, 0, 1}, 0, 100, 0}, /* beside the box */
        {{0.6, 1, 1}, {0, 0, 1}, 0, 100, 0},  /* on its upper face, which is not inside */
        {{0.6, 0.6, 11}, {0, 0, 1}, 0, 100, 0},
        {{0.6, 0.6, 1}, {0, 0, 1}, 3, 2, 0}, /* an empty range */
    };
    for (size_t n = 0; n < sizeof rays / sizeof *rays; n++)
        assert_within(murk_walk_depth(grid, kappa_t, rays[n].origin, rays[n].direction,
                                      rays[n].t_min, rays[n].t_max),
                      rays[n].depth, 1e-12 * (1 + rays[n].depth));
    murk_grid_release(grid);
    murk_bricks_clear(&bricks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_rays),
        cmocka_unit_test(straight_rays),
        cmocka_unit_test(depth),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
