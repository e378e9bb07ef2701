/* SPDX-License-Identifier: Apache-2.0 */
/* The media of murk bench, and its measuring. */
#include "cases.h"
#include "check.h"
#include "error.h"
#include "run.h"
#include "scenes.h"
#include "statistics.h"
#include "volume.h"

static struct bench_voxels make(int medium, double count)
{
    struct bench_voxels voxels = {0};
    assert_true(BENCH_CASES[medium].make(count, &voxels));
    return voxels;
}

/* Every case has about the voxels asked for, all of them finite, and the same ones again. */
static void cases(void **state)
{
    (void)state;
    for (int medium = 0; medium < BENCH_CASE_COUNT; medium++)
        for (double count = 1000; count < 1e5; count *= 30) {
            struct bench_voxels a = make(medium, count), b = make(medium, count);
            assert_within((double)bench_voxels_active(&a), count, 0.03 * count);
            assert_int_equal(a.count, b.count);
            assert_memory_equal(a.brick, b.brick, a.count * 3 * sizeof *a.brick);
            size_t values = a.count * BENCH_SLOTS;
            assert_memory_equal(a.kappa_t, b.kappa_t, values * sizeof *a.kappa_t);
            for (size_t i = 0; i < values; i++)
                assert_true(a.kappa_t[i] >= 0 && a.kappa_t[i] < 1e6f);
            bench_voxels_release(&a);
            bench_voxels_release(&b);
        }
}

static murk_medium_info info_of(murk_context *context, const struct bench_voxels *voxels)
{
    murk_medium *medium;
    murk_medium_info info;
    assert_int_equal(bench_voxels_medium(context, voxels, &medium), MURK_OK);
    assert_int_equal(murk_medium_info_get(medium, &info), MURK_OK);
    murk_medium_release(medium);
    return info;
}

/* What the cases are meant to be. */
static void kinds(void **state)
{
    struct bench_voxels box = make(BENCH_BOX, 8000), cloud = make(BENCH_CLOUD, 2e4),
                        checkers = make(BENCH_CHECKERBOARD, 2e4),
                        filaments = make(BENCH_FILAMENTS, 2e4);
    murk_medium_info info = info_of(*state, &box);
    assert_int_equal(info.zones, 8000);
    assert_within(info.mean_depth, 8, 1e-4);
    assert_within(info.max_depth, 8, 1e-4);
    assert_within(info.box_max[0] - info.box_min[0], 1, 1e-6);

    info = info_of(*state, &cloud); /* shortest in z, where its depth was set */
    assert_within(info.max_depth, 10, 1e-3);
    assert_int_equal(info.zones, bench_voxels_active(&cloud));

    for (size_t b = 0; b < checkers.count; b++) {
        const int32_t *at = checkers.brick + 3 * b;
        assert_int_equal((at[0] + at[1] + at[2]) % 2, 0);
    }
    assert_int_equal(bench_voxels_active(&checkers), checkers.count * BENCH_SLOTS);

    info = info_of(*state, &filaments);
    assert_true(info.zones == 20000 && info.bricks * BENCH_SLOTS > 3 * info.zones);
    assert_within(info.kappa_t_max * info.voxel_size[0], 0.3, 1e-6);
    bench_voxels_release(&box);
    bench_voxels_release(&cloud);
    bench_voxels_release(&checkers);
    bench_voxels_release(&filaments);
}

/* 16 voxels more double the box on each axis and keep its floor. */
static void widen(void **state)
{
    (void)state;
    struct bench_voxels voxels = make(BENCH_CLOUD, 3000);
    int32_t lo[2][3], hi[2][3];
    size_t active = bench_voxels_active(&voxels);
    bench_voxels_box(&voxels, lo[0], hi[0]);
    assert_true(bench_voxels_widen(&voxels));
    bench_voxels_box(&voxels, lo[1], hi[1]);
    for (int a = 0; a < 3; a++)
        assert_int_equal(hi[1][a] - lo[1][a], 2 * (hi[0][a] - lo[0][a]));
    assert_int_equal(lo[1][2], lo[0][2]);
    assert_int_equal(bench_voxels_active(&voxels), active + 16);
    bench_voxels_release(&voxels);
}

/* Voxels are found again, below 0 too. */
static void voxels(void **state)
{
    (void)state;
    struct bench_voxels voxels = {0};
    uint64_t random = 5;
    int32_t at[300][3];
    for (int n = 0; n < 300; n++) {
        for (int a = 0; a < 3; a++)
            at[n][a] = (int32_t)(2000 * check_random(&random)) - 1000;
        *bench_voxels_at(&voxels, at[n][0], at[n][1], at[n][2]) = (float)(n + 1);
    }
    for (int n = 0; n < 300; n++)
        assert_within(*bench_voxels_at(&voxels, at[n][0], at[n][1], at[n][2]), n + 1, 0);
    for (size_t i = 0; i < voxels.count * BENCH_SLOTS; i++)
        if (voxels.kappa_t[i] != 0) {
            int32_t index[3];
            bench_voxels_index(&voxels, i, index);
            assert_memory_equal(index, at[(int)voxels.kappa_t[i] - 1], sizeof index);
        }
    assert_int_equal(bench_voxels_active(&voxels), 300);
    assert_true(bench_voxels_keep(&voxels, 100, 0.5));
    assert_within((double)bench_voxels_active(&voxels), 100, 1);
    assert_true(voxels.count <= 101);
    assert_true(*bench_voxels_at(&voxels, at[299][0], at[299][1], at[299][2]) > 95);
    assert_within(*bench_voxels_at(&voxels, at[0][0], at[0][1], at[0][2]), 0, 0);
    bench_voxels_release(&voxels);
}

static void statistics(void **state)
{
    (void)state;
    double odd[] = {5, 1, 3}, even[] = {4, 1, 2, 100}, bad[] = {1, NAN, 2};
    double x[] = {1e4, 1e5, 1e6}, y[3], low[] = {0, 10, 20, 30, 40};
    assert_within(bench_median(odd, 3), 3, 0);
    assert_within(bench_median(even, 4), 3, 0);
    assert_true(isnan(bench_median(bad, 3)));
    assert_within(bench_quantile(low, 5, 0.95), 38, 1e-12);
    for (int i = 0; i < 3; i++)
        y[i] = 2e-6 * pow(x[i], 1.25);
    assert_within(bench_power(x, y, 3), 1.25, 1e-12);
    y[0] *= 2; /* ends pull with their distance from the middle of the logarithms */
    assert_within(bench_power(x, y, 3), 1.25 - log10(2) / 2, 1e-12);
    y[1] = 0;
    assert_true(isnan(bench_power(x, y, 3)));
    assert_true(isnan(bench_power(x, y, 1)));
}

/* A run gives numbers that fit together, and its error against itself is 0. */
static void runs(void **state)
{
    (void)state;
    struct bench_voxels voxels = make(BENCH_CLOUD, 500);
    struct bench_outcome outcome;
    struct bench_run run = {.voxels = &voxels,
                            .scene = bench_scene_default,
                            .solve = MURK_SOLVE_DEFAULT,
                            .threads = 1,
                            .reference = bench_reference_create(&voxels),
                            .refer = true};
    const struct bench_result *r = &outcome.median;
    run.solve.tolerance = 0.05;
    assert_non_null(run.reference);
    assert_int_equal(bench_run(&run, 1, &outcome), MURK_OK);
    assert_within(r->zones, (double)bench_voxels_active(&voxels), 0);
    assert_true(r->reached == 1 && r->estimate <= 0.05 && r->directions > 0);
    assert_true(r->seconds > 0 && r->seconds_solve <= r->seconds);
    assert_true(isnan(r->peak_bytes) || r->peak_bytes > 4 * r->zones);
    assert_true(isnan(r->error) && isnan(r->seconds_render));
    assert_true(strlen(outcome.kernel) > 0);

    run.refer = false;
    assert_int_equal(bench_run(&run, 3, &outcome), MURK_OK);
    assert_within(r->error, 0, 1e-6);
    for (size_t i = 0; i < voxels.count * BENCH_SLOTS; i++)
        run.reference[i] *= 1.25f;
    assert_int_equal(bench_run(&run, 1, &outcome), MURK_OK);
    assert_within(r->error, 0.2, 1e-6);
    assert_within(r->error_95, 0.2, 1e-6);
    bench_reference_release(run.reference, &voxels);
    bench_voxels_release(&voxels);
}

/* The Monte Carlo and lines agree within its standard error, with the paper's ground and without.
 */
static void packets(void **state)
{
    static const int media[] = {BENCH_FIGURE_1, BENCH_CLOUD};
    (void)state;
    for (int m = 0; m < 2; m++) {
        struct bench_voxels voxels = make(media[m], 400);
        struct bench_outcome outcome;
        struct bench_run run = {.voxels = &voxels,
                                .scene = m == 0 ? bench_scene_paper : bench_scene_alone,
                                .solve = MURK_SOLVE_DEFAULT,
                                .reference = bench_reference_create(&voxels),
                                .refer = true};
        const struct bench_result *r = &outcome.median;
        assert_non_null(run.reference);
        run.solve.directions = 1536;
        run.solve.rays = 2;
        assert_int_equal(bench_run(&run, 1, &outcome), MURK_OK);
        run.refer = false;
        run.packets = 50000;
        assert_int_equal(bench_run(&run, 1, &outcome), MURK_OK);
        assert_within(r->zones, (double)bench_voxels_active(&voxels), 0);
        assert_within(r->packets, 50000, 0);
        assert_true(r->seconds > 0 && r->estimate > 0.005 && r->estimate < 0.05);
        assert_within(r->error, r->estimate, 0.25 * r->estimate);
        bench_reference_release(run.reference, &voxels);
        bench_voxels_release(&voxels);
    }
}

/* A file's extinction is its density times the scale that murk chooses. */
static void volume(void **state)
{
    murk_volume *volume;
    murk_medium *medium;
    murk_medium_info want, got;
    struct bench_voxels voxels = {0};
    const char *path = MURK_VOLUMES_DIR "/plume64_f045.vdb";
    assert_int_equal(murk_volume_read(*state, path, &volume), MURK_OK);
    assert_int_equal(murk_medium_from_volume(*state, volume, NULL, &medium), MURK_OK);
    assert_int_equal(murk_medium_info_get(medium, &want), MURK_OK);
    assert_int_equal(bench_volume_read(*state, path, &voxels), MURK_OK);
    got = info_of(*state, &voxels);
    assert_int_equal(got.zones, want.zones);
    assert_within(got.kappa_t_max, want.kappa_t_max, 1e-6 * want.kappa_t_max);
    assert_within(got.max_depth, want.max_depth, 1e-6 * want.max_depth);
    assert_within(got.mean_depth, want.mean_depth, 1e-6 * want.mean_depth);
    bench_voxels_release(&voxels);
    murk_medium_release(medium);
    murk_volume_release(volume);
    assert_int_equal(bench_volume_read(*state, "nowhere.vdb", &voxels), MURK_ERROR_INPUT);
    bench_voxels_release(&voxels);
}

/* What goes wrong in a run is told. */
static void failures(void **state)
{
    (void)state;
    struct bench_voxels voxels = make(BENCH_BOX, 500);
    struct bench_outcome outcome;
    const struct bench_run run = {
        .voxels = &voxels, .scene = bench_scene_default, .solve = MURK_SOLVE_DEFAULT};
    voxels.albedo = 2;
    assert_int_equal(bench_run(&run, 2, &outcome), MURK_ERROR_INPUT);
    assert_string_equal(outcome.message, "bricks: albedo 2 is not in [0, 1]");
    bench_voxels_release(&voxels);
}

/* Figure 1's light meets [BG91]'s ground: a patch a column, the bright square in the middle. */
static void paper(void **state)
{
    struct bench_voxels voxels = make(BENCH_FIGURE_1, 0);
    murk_medium *medium;
    murk_ground *ground;
    murk_scene scene;
    int patches[2];
    assert_int_equal(bench_voxels_medium(*state, &voxels, &medium), MURK_OK);
    assert_int_equal(bench_scene_paper(*state, medium, &scene, &ground), MURK_OK);
    murk_ground_patches(ground, patches);
    assert_true(patches[0] == 10 && patches[1] == 10);
    assert_true(scene.medium == medium && scene.ground == ground && scene.sky_radiance == 0);
    assert_within(scene.sun.direction[2], -1, 0);
    assert_int_equal(info_of(*state, &voxels).zones, 1000);
    murk_ground_release(ground);
    murk_medium_release(medium);
    bench_voxels_release(&voxels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs), /* first: before any thread */
        cmocka_unit_test(packets),    cmocka_unit_test(failures), cmocka_unit_test(cases),
        cmocka_unit_test(kinds),      cmocka_unit_test(widen),    cmocka_unit_test(voxels),
        cmocka_unit_test(statistics), cmocka_unit_test(paper),    cmocka_unit_test(volume),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
