/* SPDX-License-Identifier: Apache-2.0 */
/* Volumes read and written: the shipped ones, odd ones, round trips. */
#include "vdb_files.h"

#include "bricks.h"
#include "context.h"
#include "vdb.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

static murk_grid_info find_grid(const murk_volume *volume, const char *name)
{
    murk_grid_info info;
    for (size_t i = 0; i < murk_volume_grid_count(volume); i++) {
        assert_int_equal(murk_volume_grid_info(volume, i, &info), MURK_OK);
        if (!strcmp(info.name, name))
            return info;
    }
    fail_msg("no grid %s", name);
    return info;
}

/* What a volume of one or more grids comes to; density NULL: none. */
typedef struct expectation {
    const char *file, *grid, *type, *density, *unreadable;
    uint64_t active, tiles, nonzero, invalid;
} expectation;

static void test_odd_grids(void **state)
{
    static const expectation all[] = {
        {"tiles", "density", "float", "density", NULL, 2097152 + 1024 + 6, 3, 2098182, 0},
        {"huge_tiles", "density", "float", NULL, "expands", (uint64_t)1 << 37, 2, 0, 0},
        {"half", "density", "half", "density", NULL, 64, 0, 64, 0},
        {"double", "density", "double", "density", NULL, 64, 0, 64, 1},
        {"same_names", "density[1]", "float", "density[0]", NULL, 64, 0, 64, 0},
        {"unnamed", "[0]", "float", "[0]", NULL, 64, 0, 64, 0},
        {"two_unnamed", "[1]", "float", NULL, NULL, 27, 0, 27, 0},
        {"rotated", "density", "float", "density", NULL, 729, 0, 729, 0},
        {"sheared", "density", "float", NULL, "sheared", 64, 0, 0, 0},
        {"frustum", "density", "float", NULL, "frustum", 64, 0, 0, 0},
        {"invalid", "density", "float", "density", NULL, 64, 0, 63, 4},
        {"empty", "density", "float", "density", NULL, 0, 0, 0, 0},
        {"active_zeros", "density", "float", "density", NULL, 512, 0, 128, 0},
        {"background", "density", "float", "density", NULL, 64, 0, 64, 0},
        {"beside", "velocity", "vec3s", "smoke", "vec3s", 64, 0, 0, 0},
        {"coloured", "radiosity", "vec3s", "density", "vec3s", 13824, 27, 0, 0},
        {"half_colours", "radiosity", "vec3s", "density", "vec3s", 576, 1, 0, 0},
        {"half_colours_stream", "density", "float", "density", NULL, 64, 0, 64, 0},
        {"coloured_frustum", "radiosity", "vec3s", "density", "frustum", 13824, 27, 0, 0},
        {"beside", "mask", "bool", "smoke", NULL, 64, 0, 64, 0},
        {"beside", "surface", "float", "smoke", NULL, 2070, 0, 739, 0},
        {"ball", "surface", "float", NULL, NULL, 30403, 0, 36088, 0},
        {"named_ball", "density", "float", "smoke", NULL, 30403, 0, 36088, 0},
        {"filled", "surface", "float", NULL, NULL, 2, 0, 2097152 + 2, 1},
        {"overfilled", "surface", "float", NULL, "inside would fill 134217727", 2, 0, 0, 0},
        {"int32", "density", "int32", NULL, NULL, 64, 0, 64, 0},
        {"int32", "long", "int64", NULL, NULL, 64, 0, 64, 0},
        {"points", "points", "point", "density", "of type point", 0, 0, 0, 0},
        {"points", "smoke", "float", "density", NULL, 64, 0, 64, 0},
        {"points_stream", "density", "float", "density", NULL, 64, 0, 64, 0},
        {"points_stream", "points", "point", "density", "of type point", 0, 0, 0, 0},
        {"points_stream", "?", "unknown", "density", "behind grid points", 0, 0, 0, 0},
        {"flames", "temperature", "float", "flames", NULL, 64, 0, 64, 0},
        {"voxel_fog", "temperature", "float", "voxel_fog_density", NULL, 64, 0, 64, 0},
        {"only", "Gas", "float", "Gas", NULL, 64, 0, 64, 0},
        {"several", "b", "float", NULL, NULL, 64, 0, 64, 0},
        {"instance", "shared", "float", "density[0]", NULL, 64, 0, 64, 0},
        {"stream", "shared", "float", "density[0]", NULL, 64, 0, 64, 0},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        const expectation *e = &all[i];
        char name[64];
        snprintf(name, sizeof name, "%s.vdb", e->file);
        murk_volume *volume = read_volume(*state, odd(name));
        murk_grid_info info = find_grid(volume, e->grid);
        const char *density = murk_volume_density(volume);
        assert_string_equal(density ? density : "none", e->density ? e->density : "none");
        assert_string_equal(info.type, e->type);
        assert_int_equal(info.readable, !e->unreadable);
        if (e->unreadable)
            assert_non_null(strstr(info.unreadable, e->unreadable));
        assert_int_equal(info.active_voxels, e->active);
        assert_int_equal(info.active_tiles, e->tiles);
        assert_int_equal(info.nonzero_voxels, e->nonzero);
        assert_int_equal(info.invalid_voxels, e->invalid);
        murk_volume_release(volume);
    }
}

static void test_shipped(void **state)
{
    murk_volume *volume = read_volume(*state, shipped("plume64_f045.vdb"));
    assert_int_equal(murk_volume_grid_count(volume), 5);
    assert_string_equal(murk_volume_density(volume), "density");
    murk_grid_info info = find_grid(volume, "density");
    const int32_t low[3] = {6, 2, 1}, high[3] = {38, 38, 62};
    assert_int_equal(info.active_voxels, 27785);
    assert_memory_equal(info.box_min, low, sizeof low);
    assert_memory_equal(info.box_max, high, sizeof high);
    assert_true(info.index_to_world[0] == 0.0625 && info.index_to_world[3] == 0);
    assert_true(info.value_max > 0.56 && info.value_max < 0.5601);
    info = find_grid(volume, "shadow");
    assert_int_equal(info.invalid_voxels, info.active_voxels);
    info = find_grid(volume, "flame");
    assert_true(info.readable && info.box_max[0] < info.box_min[0]);
    assert_int_equal(murk_volume_grid_info(volume, 5, &info), MURK_ERROR_INPUT);
    murk_volume_release(volume);
}

/* What cannot be read at all is told once, not for each frame again; vectors are no news. */
static void test_skipped(void **state)
{
    static const struct {
        const char *file;
        int warnings;
    } all[] = {{"points.vdb", 1}, {"points.vdb", 0},        {"half.vdb", 0},   {"points.vdb", 0},
               {"beside.vdb", 0}, {"points_stream.vdb", 1}, {"frustum.vdb", 0}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        warnings = 0;
        murk_volume_release(read_volume(*state, odd(all[i].file)));
        assert_int_equal(warnings, all[i].warnings);
    }
}

/* The column sums of a 2 x 3 x 4 ramp of voxels 0.5 x 0.5 x 0.25: x is shortest with 4 * 0.25. */
static void test_depth(void **state)
{
    murk_volume *volume = read_volume(*state, odd("medium.vdb"));
    murk_grid_info info = find_grid(volume, "density");
    /* Values (16 x + 4 y + z + 1) / 64 in 4^3 voxels, summed along z: the last column has most. */
    assert_float_equal(info.max_depth, (61 + 62 + 63 + 64) / 64.0 * 0.25, 1e-12);
    assert_float_equal(info.mean_depth, 32.5 / 64 * 4 * 0.25, 1e-12);
    murk_volume_release(volume);
}

/* Bricks with values and active voxels that follow from their number. */
static murk_bricks make_bricks(size_t count, const double matrix[16])
{
    murk_bricks bricks = {.count = count,
                          .brick = murk_alloc(count, sizeof *bricks.brick),
                          .mask = murk_alloc(count, sizeof *bricks.mask),
                          .values = murk_alloc(count * MURK_BRICK_SLOTS, sizeof(float))};
    uint64_t random = 88172645463325252u;
    for (size_t b = 0; b < count; b++) {
        for (int a = 0; a < 3; a++)
            bricks.brick[b][a] = (int32_t)b * (a + 1) - 600 * (a == 1);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            random ^= random << 13, random ^= random >> 7, random ^= random << 17;
            if (!(random & 3) && slot)
                continue;
            bricks.mask[b][slot >> 6] |= (uint64_t)1 << (slot & 63);
            bricks.values[b * MURK_BRICK_SLOTS + (size_t)slot] =
                random & 12 ? (float)(random >> 40) * 0x1p-20f : 0;
        }
    }
    memcpy(bricks.index_to_world, matrix, sizeof bricks.index_to_world);
    return bricks;
}

static murk_bricks read_bricks(murk_context *context, const murk_vdb *vdb, const char *name)
{
    murk_bricks bricks = {0};
    for (size_t i = 0; i < murk_vdb_count(vdb); i++)
        if (!strcmp(murk_vdb_info(vdb, i)->name, name))
            assert_int_equal(murk_vdb_bricks(context, vdb, i, 0, &bricks), MURK_OK);
    assert_non_null(bricks.brick);
    return bricks;
}

static void assert_same_bricks(const murk_bricks *a, const murk_bricks *b, float tolerance)
{
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->brick, b->brick, a->count * sizeof *a->brick);
    assert_memory_equal(a->mask, b->mask, a->count * sizeof *a->mask);
    for (size_t i = 0; i < a->count * MURK_BRICK_SLOTS; i++)
        if (!(fabsf(a->values[i] - b->values[i]) <= tolerance * fabsf(a->values[i])))
            fail_msg("value %zu: %g became %g", i, (double)a->values[i], (double)b->values[i]);
    assert_memory_equal(a->index_to_world, b->index_to_world, sizeof a->index_to_world);
}

static const double matrices[3][16] = {
    {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1},
    {0.1, 0, 0, 1e5, 0, 0.3, 0, -2, 0, 0, 0.7, 1.0 / 3, 0, 0, 0, 1},
    {0.08, -0.12, 0, 5, 0.06, 0.16, 0, -7, 0, 0, 0.31, 11, 0, 0, 0, 1},
};

static void test_round_trip(void **state)
{
    for (int m = 0; m < 3; m++)
        for (int half = 0; half < 2; half++) {
            murk_bricks bricks = make_bricks(37, matrices[m]);
            const murk_vdb_grid grid = {.name = "radiosity", .bricks = &bricks};
            const murk_vdb_meta meta[2] = {{"units", "W/m^2", 0}, {"number", NULL, 0.25}};
            const char *path = odd("written.vdb");
            assert_int_equal(murk_vdb_write(*state, path, &grid, 1, meta, 2, NULL, 0, half),
                             MURK_OK);
            murk_vdb *vdb = NULL;
            assert_int_equal(murk_vdb_read(*state, path, &vdb), MURK_OK);
            const murk_grid_info *info = murk_vdb_info(vdb, 0);
            assert_string_equal(info->type, half ? "half" : "float");
            assert_string_equal(info->grid_class, "fog volume");
            assert_int_equal(info->active_tiles, 0);
            murk_bricks again = read_bricks(*state, vdb, "radiosity");
            assert_true(again.background == 0);
            assert_same_bricks(&bricks, &again, half ? 0x1p-10f : 0);
            murk_bricks_clear(&bricks);
            murk_bricks_clear(&again);
            murk_vdb_release(vdb);
        }
}

/* A grid passes through as it was, and lends its transform. */
static void test_pass_through(void **state)
{
    static const char *const files[] = {"rotated.vdb", "half.vdb", "tiles.vdb", "background.vdb",
                                        "far.vdb"};
    murk_bricks far = make_bricks(2, matrices[1]);
    const murk_vdb_grid density = {.name = "density", .bricks = &far};
    assert_int_equal(murk_vdb_write(*state, odd("far.vdb"), &density, 1, NULL, 0, NULL, 0, false),
                     MURK_OK);
    murk_bricks_clear(&far);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        murk_vdb *source = NULL, *written = NULL;
        assert_int_equal(murk_vdb_read(*state, odd(files[i]), &source), MURK_OK);
        murk_bricks bricks = make_bricks(3, matrices[2]);
        const murk_vdb_grid grids[2] = {{.name = "radiosity", .bricks = &bricks},
                                        {.pass = source, .pass_index = 0}};
        const char *path = odd("passed.vdb");
        assert_int_equal(murk_vdb_write(*state, path, grids, 2, NULL, 0, source, 0, true), MURK_OK);
        assert_int_equal(murk_vdb_read(*state, path, &written), MURK_OK);
        murk_bricks before = read_bricks(*state, source, "density");
        murk_bricks after = read_bricks(*state, written, "density");
        murk_bricks lit = read_bricks(*state, written, "radiosity");
        assert_same_bricks(&before, &after, 0);
        assert_true(before.background == after.background);
        assert_memory_equal(lit.index_to_world, before.index_to_world, sizeof lit.index_to_world);
        size_t passed = !strcmp(murk_vdb_info(written, 0)->name, "density") ? 0 : 1;
        assert_string_equal(murk_vdb_info(written, passed)->type, murk_vdb_info(source, 0)->type);
        assert_int_equal(murk_vdb_info(written, passed)->active_tiles,
                         murk_vdb_info(source, 0)->active_tiles);
        murk_bricks_clear(&bricks);
        murk_bricks_clear(&before);
        murk_bricks_clear(&after);
        murk_bricks_clear(&lit);
        murk_vdb_release(source);
        murk_vdb_release(written);
    }
}

static size_t count_bytes(const char *path)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    fclose(file);
    return (size_t)size;
}

/* What cannot be written leaves the old file as it was and nothing beside it. */
static void test_failed_write(void **state)
{
    murk_context *context = *state;
    murk_bricks bricks = make_bricks(200, matrices[0]);
    const murk_vdb_grid grid = {.name = "radiosity", .bricks = &bricks};
    const char *path = odd("kept.vdb");
    assert_int_equal(murk_vdb_write(context, path, &grid, 1, NULL, 0, NULL, 0, true), MURK_OK);
    size_t size = count_bytes(path);

    struct rlimit limit, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    small = limit;
    small.rlim_cur = 100000;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    murk_status status = murk_vdb_write(context, path, &grid, 1, NULL, 0, NULL, 0, false);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    assert_int_equal(status, MURK_ERROR_IO);
    assert_non_null(strstr(murk_context_message(context), "kept.vdb"));
    assert_non_null(strstr(murk_context_message(context), strerror(EFBIG)));
    assert_int_equal(count_bytes(path), size);
    char beside[600];
    snprintf(beside, sizeof beside, "%s/.kept.vdb.%ld-0.tmp", odd("."), (long)getpid());
    assert_int_equal(access(beside, F_OK), -1);

    status = murk_vdb_write(context, odd("no/such/folder.vdb"), &grid, 1, NULL, 0, NULL, 0, false);
    assert_int_equal(status, MURK_ERROR_IO);
    assert_non_null(strstr(murk_context_message(context), strerror(ENOENT)));
    assert_int_equal(murk_vdb_write(context, odd("."), &grid, 1, NULL, 0, NULL, 0, false),
                     MURK_ERROR_INPUT);
    assert_int_equal(murk_vdb_write(context, "/dev/full", &grid, 1, NULL, 0, NULL, 0, false),
                     MURK_ERROR_IO);
    assert_int_equal(access("/dev/full", W_OK), 0);

    bricks.values[0] = 70000; /* more than a half float holds */
    assert_int_equal(murk_vdb_write(context, path, &grid, 1, NULL, 0, NULL, 0, true),
                     MURK_ERROR_INPUT);
    assert_int_equal(count_bytes(path), size);
    murk_bricks_clear(&bricks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_odd_grids),    cmocka_unit_test(test_shipped),
        cmocka_unit_test(test_depth),        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_pass_through), cmocka_unit_test(test_failed_write),
        cmocka_unit_test(test_skipped),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
