/* SPDX-License-Identifier: Apache-2.0 */
/* Truncated, flipped, foreign and piped VDBs: one line that says why, and never a crash. */
#include "vdb_bytes.h"

#include "murk/bands.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

static void assert_refused(murk_context *context, const char *path, const char *part)
{
    murk_volume *volume = (murk_volume *)context; /* must stay as it is */
    if (murk_volume_read(context, path, &volume) != MURK_ERROR_INPUT)
        fail_msg("%s is not refused", path);
    assert_ptr_equal(volume, context);
    assert_message(context, part);
    assert_message(context, path);
}

static void test_foreign(void **state)
{
    const char *path = odd("foreign.vdb");
    assert_refused(*state, odd("not_there.vdb"), "No such file");
    assert_refused(*state, odd("."), "directory");
    save(path, (const unsigned char *)"", 0);
    assert_refused(*state, path, "empty");
    save(path, (const unsigned char *)"solid stl\nfacet normal 0 0 0", 28);
    assert_refused(*state, path, "not a VDB file");
    content whole = load(odd("half.vdb"));
    whole.bytes[8] = 230; /* the format's version */
    save(path, whole.bytes, whole.size);
    assert_refused(*state, path, "230");
    free(whole.bytes);
}

static void test_truncated(void **state)
{
    content whole = load(shipped("plume64_f045.vdb"));
    const char *path = odd("truncated.vdb");
    const size_t lengths[] = {0,     1,      7,      8,      12,     20,     30,
                              57,    61,     65,     66,     80,     110,    134,
                              138,   200,    395,    1000,   5000,   18000,  18303,
                              50000, 100000, 185000, 186032, 250000, 300000, 390000};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        save(path, whole.bytes, lengths[i]);
        assert_refused(*state, path, "truncated.vdb");
    }
    save(path, whole.bytes, whole.size - 1);
    assert_refused(*state, path, "truncated");
    save(path, whole.bytes, whole.size);
    murk_volume_release(read_volume(*state, path));
    free(whole.bytes);
}

/* Reads bytes that may be damaged, and all that a volume is good for. */
static murk_status try_bytes(murk_context *context, const unsigned char *bytes, size_t size)
{
    const char *path = odd("flipped.vdb");
    murk_volume *volume = NULL;
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    save(path, bytes, size);
    murk_status status = murk_volume_read(context, path, &volume);
    if (status) {
        assert_int_equal(status, MURK_ERROR_INPUT);
        assert_message(context, path);
        return status;
    }
    if (!murk_medium_from_volume(context, volume, NULL, &medium)) {
        const murk_scene scene = {.medium = medium};
        if (!murk_solution_from_volume_band(context, &scene, volume, "G", &solution))
            murk_solution_release(solution);
        else
            assert_message(context, path);
        murk_medium_release(medium);
    }
    murk_volume_release(volume);
    return MURK_OK;
}

static void flip(murk_context *context, const char *file, size_t region, int times)
{
    content whole = load(file);
    uint32_t random = 12345;
    int refused = 0;
    for (int i = 0; i < times; i++) {
        random = random * 1664525u + 1013904223u;
        size_t at = (random >> 8) % (region < whole.size ? region : whole.size);
        unsigned char before = whole.bytes[at];
        random = random * 1664525u + 1013904223u;
        whole.bytes[at] ^= (unsigned char)(random >> 29 ? 1u << (random >> 29) : 255);
        refused += try_bytes(context, whole.bytes, whole.size) != MURK_OK;
        whole.bytes[at] = before;
    }
    assert_true(refused > 0 && refused < times);
    assert_int_equal(try_bytes(context, whole.bytes, whole.size), MURK_OK);
    free(whole.bytes);
}

static void test_flipped(void **state)
{
    flip(*state, shipped("plume64_f045.vdb"), 420, 120);
    flip(*state, odd("half.vdb"), 700, 100);
    flip(*state, odd("stream.vdb"), 700, 100);
    flip(*state, odd("half_colours.vdb"), 700, 100);
}

/* Every byte of the small file's tables: counts, masks and sizes of blocks. */
static void test_flipped_tree(void **state)
{
    flip(*state, odd("rotated.vdb"), (size_t)1 << 30, 400);
    flip(*state, odd("stream.vdb"), (size_t)1 << 30, 200);
    flip(*state, odd("colours.vdb"), (size_t)1 << 30, 200);
    flip(*state, odd("half_colours.vdb"), (size_t)1 << 30, 400);
    flip(*state, odd("half_colours_stream.vdb"), (size_t)1 << 30, 200);
}

/* A damaged density is not replaced by another grid in silence. */
static void test_damaged_density(void **state)
{
    content whole = load(odd("medium.vdb"));
    size_t at = 0; /* the first block's size follows the node masks of the first grid */
    while (memcmp(whole.bytes + at, "UniformScaleMap", 15) &&
           memcmp(whole.bytes + at, "ScaleMap", 8) && memcmp(whole.bytes + at, "AffineMap", 9))
        at++;
    for (size_t i = at + 160; i < at + 400; i++)
        whole.bytes[i] = 0xff;
    save(odd("flipped.vdb"), whole.bytes, whole.size);
    murk_volume *volume = read_volume(*state, odd("flipped.vdb"));
    murk_grid_info info;
    assert_int_equal(murk_volume_grid_info(volume, 0, &info), MURK_OK);
    assert_false(info.readable);
    assert_non_null(strstr(info.unreadable, "damaged"));
    assert_int_equal(murk_volume_grid_info(volume, 1, &info), MURK_OK);
    assert_true(info.readable);
    assert_null(murk_volume_density(volume));
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_volume(*state, volume, NULL, &medium), MURK_ERROR_INPUT);
    assert_message(*state, "grid density: cannot be used: damaged");
    murk_volume_release(volume);
    free(whole.bytes);
}

/* Reads "-" with a file, or a pipe that a child fills, as standard input. */
static murk_volume *read_standard_input(murk_context *context, const char *path, size_t length,
                                        bool piped)
{
    content whole = load(path);
    int ends[2], kept = dup(STDIN_FILENO);
    if (length > whole.size)
        length = whole.size;
    if (piped) {
        assert_int_equal(pipe(ends), 0);
        if (!fork()) {
            close(ends[0]);
            for (size_t i = 0; i < length;) {
                ssize_t n = write(ends[1], whole.bytes + i, length - i);
                if (n <= 0)
                    break;
                i += (size_t)n;
            }
            _exit(0);
        }
        close(ends[1]);
    } else {
        save(odd("redirected.vdb"), whole.bytes, length);
        ends[0] = open(odd("redirected.vdb"), O_RDONLY);
    }
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    murk_volume *volume = NULL;
    murk_status status = murk_volume_read(context, "-", &volume);
    dup2(kept, STDIN_FILENO);
    close(kept);
    if (piped)
        wait(NULL);
    free(whole.bytes);
    assert_int_equal(status, volume ? MURK_OK : MURK_ERROR_INPUT);
    return volume;
}

static void test_standard_input(void **state)
{
    static const char *const files[] = {"stream.vdb", "instance.vdb"};
    for (int i = 0; i < 2; i++)
        for (int piped = 0; piped < 2; piped++) {
            murk_volume *volume = read_standard_input(*state, odd(files[i]), SIZE_MAX, piped);
            murk_grid_info info;
            assert_non_null(volume);
            assert_int_equal(murk_volume_grid_count(volume), 4);
            assert_int_equal(murk_volume_grid_info(volume, 1, &info), MURK_OK);
            assert_string_equal(info.name, "density[1]");
            assert_true(info.value_max == 128);
            assert_string_equal(murk_volume_density(volume), "density[0]");
            murk_volume_release(volume);
            assert_null(read_standard_input(*state, odd(files[i]), 9000, piped));
            assert_message(*state, "standard input");
        }
    murk_volume *volume = read_standard_input(*state, shipped("plume64_f045.vdb"), SIZE_MAX, true);
    assert_non_null(volume);
    murk_volume_release(volume);
    assert_null(read_standard_input(*state, odd("stream.vdb"), 0, true));
    assert_message(*state, "empty");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_foreign),         cmocka_unit_test(test_truncated),
        cmocka_unit_test(test_flipped),         cmocka_unit_test(test_flipped_tree),
        cmocka_unit_test(test_damaged_density), cmocka_unit_test(test_standard_input),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
