/* SPDX-License-Identifier: Apache-2.0 */
/* Lists of frames, and paths that stand for the files of a sequence. */
#include "check.h"
#include "jobs.h"
#include "pattern.h"

#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

static void check_list(const char *text, size_t count, const int *expected)
{
    struct cli_frames frames = {0};
    assert_int_equal(cli_frames_parse(text, &frames), MURK_OK);
    assert_int_equal(frames.count, count);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(frames.number[i], expected[i]);
    cli_frames_release(&frames);
}

#define CHECK_LIST(text, ...)                                                                      \
    check_list(text, sizeof((int[]){__VA_ARGS__}) / sizeof(int), (int[]){__VA_ARGS__})

static void lists(void **state)
{
    (void)state;
    CHECK_LIST("5", 5);
    CHECK_LIST("0", 0);
    CHECK_LIST("007", 7);
    CHECK_LIST("1-4", 1, 2, 3, 4);
    CHECK_LIST("4-4", 4);
    CHECK_LIST("1-6x2", 1, 3, 5);
    CHECK_LIST("1-7x2", 1, 3, 5, 7);
    CHECK_LIST("1-3x9", 1);
    CHECK_LIST("4-1", 4, 3, 2, 1);
    CHECK_LIST("10-1x4", 10, 6, 2);
    CHECK_LIST("1,3,10-12", 1, 3, 10, 11, 12);
    CHECK_LIST("-5", -5);
    CHECK_LIST("-2-1", -2, -1, 0, 1);
    CHECK_LIST("-3--5", -3, -4, -5);
    CHECK_LIST("1--3x2", 1, -1, -3);
    CHECK_LIST("999999999,-999999999", 999999999, -999999999);
    CHECK_LIST("999999999--999999999x999999999", 999999999, 0, -999999999);
}

static void repeated_frames(void **state)
{
    (void)state;
    CHECK_LIST("3,1-5", 3, 1, 2, 4, 5);
    CHECK_LIST("7,7,7", 7);
    CHECK_LIST("5-1,1-6", 5, 4, 3, 2, 1, 6);
}

static void bad_lists(void **state)
{
    (void)state;
    static const char *const BAD[] = {
        "",     ",",    "1,",    ",1",    "1,,2",    "a",       "1a",         "1-",
        "1-x2", "1-3x", "1-3x0", "5x2",   "1-3x-1",  "1-3-5",   "1 - 3",      " 1",
        "+1",   "1.5",  "--1",   "1-3y2", "1-3x2x2", "1-1e3",   "1000000000", "-1000000000",
        "1:3",  "#",    "1-a",   "1, 2",  "1;2",     "1-3x1.5", "0-1000000",  "1-600000,1-600000",
    };
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++) {
        struct cli_frames frames = {NULL, 7};
        if (cli_frames_parse(BAD[i], &frames) != MURK_ERROR_INPUT)
            fail_msg("\"%s\" is taken for a list of frames", BAD[i]);
        assert_int_equal(frames.count, 7); /* untouched */
    }
}

static void check_text(const char *list, size_t size, const char *expected)
{
    struct cli_frames frames;
    char text[64];
    memset(text, '?', sizeof text);
    assert_int_equal(cli_frames_parse(list, &frames), MURK_OK);
    cli_frames_text(&frames, text, size);
    assert_string_equal(text, expected);
    cli_frames_release(&frames);
}

static void texts(void **state)
{
    (void)state;
    check_text("3,7", 64, "3, 7");
    check_text("1-5,7,10-12", 64, "1-5, 7, 10-12");
    check_text("1,2,4", 64, "1, 2, 4");
    check_text("-3-2,9-7", 64, "-3-2, 9, 8, 7");
    check_text("1-9x2", 15, "1, 3, 5, ...");
    check_text("1-9x2", 16, "1, 3, 5, 7, ...");
    check_text("1-9x2", 19, "1, 3, 5, 7, 9");
    check_text("100-200", 6, "...");
    char text[4];
    cli_frames_text(&(struct cli_frames){0}, text, sizeof text);
    assert_string_equal(text, "");
}

static void check_path(const char *path, int frame, const char *expected)
{
    char *expanded = cli_pattern_expand(path, frame);
    assert_non_null(expanded);
    assert_string_equal(expanded, expected);
    assert_int_equal(cli_pattern_has(path), strcmp(path, expected) != 0);
    free(expanded);
}

static void paths(void **state)
{
    (void)state;
    check_path("plume.####.vdb", 7, "plume.0007.vdb");
    check_path("plume.####.vdb", 12345, "plume.12345.vdb");
    check_path("plume#.vdb", 7, "plume7.vdb");
    check_path("plume#.vdb", 120, "plume120.vdb");
    check_path("##", 7, "07");
    check_path("plume.%04d.vdb", 7, "plume.0007.vdb");
    check_path("plume.%d.vdb", 7, "plume.7.vdb");
    check_path("plume.%0d.vdb", 7, "plume.7.vdb");
    check_path("plume.$F4.vdb", 7, "plume.0007.vdb");
    check_path("plume.$F.vdb", 7, "plume.7.vdb");
    check_path("plume_$F_v2.vdb", 7, "plume_7_v2.vdb");
    check_path("$F4", 7, "0007");
    check_path("shot.##/plume.$F4.%06d.vdb", 7, "shot.07/plume.0007.000007.vdb");
    check_path("plume.####.vdb", -7, "plume.-007.vdb");
    check_path("plume.%d.vdb", -7, "plume.-7.vdb");
    check_path("plume.####.vdb", -99999, "plume.-99999.vdb");
}

static void plain_paths(void **state)
{
    (void)state;
    static const char *const PLAIN[] = {
        "",      "plume.0007.vdb", "100%.vdb", "%4d.vdb", "%s.vdb", "%04x", "%",       "$",
        "$HOME", "$FF.vdb",        "$FPS",     "$f4.vdb", "$F12",   "a%%",  "%012d.e", "%0",
    };
    for (size_t i = 0; i < sizeof PLAIN / sizeof *PLAIN; i++)
        check_path(PLAIN[i], 7, PLAIN[i]);
}

/* Makes empty files in a new folder, and goes there. */
static char *enter_folder(const char *const *names)
{
    static char folder[] = "/tmp/murk_frames_XXXXXX", path[sizeof folder];
    assert_non_null(mkdtemp(strcpy(path, folder)));
    assert_int_equal(chdir(path), 0);
    for (; *names; names++) {
        if (strchr(*names, '/')) {
            char parent[64] = "";
            strncat(parent, *names, strcspn(*names, "/"));
            mkdir(parent, 0777);
        }
        FILE *file = fopen(*names, "w");
        assert_non_null(file);
        fclose(file);
    }
    return path;
}

static void leave_folder(const char *const *names, const char *path)
{
    for (; *names; names++) {
        assert_int_equal(unlink(*names), 0);
        if (strchr(*names, '/')) {
            char parent[64] = "";
            strncat(parent, *names, strcspn(*names, "/"));
            rmdir(parent);
        }
    }
    assert_int_equal(chdir("/"), 0);
    assert_int_equal(rmdir(path), 0);
}

static void check_found(const char *path, const char *expected)
{
    struct cli_frames frames;
    char text[64];
    assert_int_equal(cli_pattern_find(path, &frames), MURK_OK);
    cli_frames_text(&frames, text, sizeof text);
    assert_string_equal(text, expected);
    cli_frames_release(&frames);
}

static void frames_on_disk(void **state)
{
    (void)state;
    static const char *const NAMES[] = {
        "a.0002.vdb",    "a.0010.vdb",  "a.0001.vdb",    "a.12345.vdb", "a.3.vdb",
        "a.00004.vdb",   "a.0006.vdb~", "a.0007.exr",    "a.x008.vdb",  "a..vdb",
        "a.-003.vdb",    "b9",          "b10",           "b-1",         "b-0",
        "b007",          "b",           "b99999999999",  "[c] *.05",    "[c] *.x",
        "run2/d.02.vdb", "run3/d.03",   "run4/d.05.vdb", "e.%d",        NULL};
    char *folder = enter_folder(NAMES);
    check_found("a.####.vdb", "-3, 1, 2, 10, 12345");
    check_found("a.$F4.vdb", "-3, 1, 2, 10, 12345");
    check_found("a.%04d.vdb", "-3, 1, 2, 10, 12345");
    check_found("./a.%04d.vdb", "-3, 1, 2, 10, 12345");
    check_found("a.%d.vdb", "3, 12345");
    check_found("a.#####.vdb", "4, 12345");
    check_found("b#", "-1, 9, 10");
    check_found("b$F", "-1, 9, 10");
    check_found("[c] *.##", "5");
    check_found("run#/d.##.vdb", "2");
    check_found("nothing.####.vdb", "");
    check_found("nowhere/####.vdb", "");
    check_found("a.0001.vdb", "");
    char path[128];
    snprintf(path, sizeof path, "%s/run%%d/d.%%02d.vdb", folder);
    check_found(path, "2");
    assert_true(cli_pattern_is_input("a.####.vdb"));
    assert_false(cli_pattern_is_input("a.0001.vdb"));
    assert_false(cli_pattern_is_input("e.%d")); /* a file of this very name */
    leave_folder(NAMES, folder);
}

static void check_jobs(size_t count, int threads, double frame_bytes, int expected)
{
    const struct cli_options none = {.max_memory = NAN}, two = {.max_memory = 2.5 * frame_bytes};
    assert_int_equal(cli_jobs(&none, count, threads, frame_bytes), expected);
    assert_in_range(cli_jobs(&two, count, threads, frame_bytes), 1, expected < 2 ? 1 : 2);
}

static void jobs(void **state)
{
    (void)state;
    check_jobs(100, 1, 1, 1);
    check_jobs(1, 2, 1, 1);
    check_jobs(2, 2, 1, 2);
    check_jobs(3, 2, 1, 1); /* two rounds of one thread each take longer than three of both */
    check_jobs(100, 2, 1, 2);
    check_jobs(8, 64, 1, 8);
    check_jobs(100, 64, 1, 50); /* in two rounds, as 64 at once would */
    check_jobs(100, 64, 1e18, 1);
    assert_int_equal(cli_jobs(&(struct cli_options){.jobs = 7}, 100, 2, 1e18), 7);
    assert_int_equal(cli_jobs(&(struct cli_options){.jobs = 7}, 3, 2, 1), 3);
    assert_int_equal(cli_threads(&(struct cli_options){.threads = 5}), 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lists),          cmocka_unit_test(repeated_frames),
        cmocka_unit_test(bad_lists),      cmocka_unit_test(texts),
        cmocka_unit_test(paths),          cmocka_unit_test(plain_paths),
        cmocka_unit_test(frames_on_disk), cmocka_unit_test(jobs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
