/* SPDX-License-Identifier: Apache-2.0 */
/* The process that keeps the grids of a volume: alone, and gone when it should be. */
#include "vdb_bytes.h"

#include "leftovers.h"
#include "vdb.h"

#include <errno.h>
#include <signal.h>
#include <unistd.h>

/* The number of this process's only child. */
static int find_child(void)
{
    char path[100];
    int pid = 0;
    snprintf(path, sizeof path, "/proc/self/task/%d/children", (int)getpid());
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_int_equal(fscanf(file, "%d", &pid), 1);
    fclose(file);
    return pid;
}

/* The child has one thread, whatever it is asked for; and where it dies that is one line, however
   often one asks. */
static void test_child(void **state)
{
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    char tasks[100];
    murk_volume *volume = read_volume(*state, shipped("box.vdb"));
    int child = find_child();
    snprintf(tasks, sizeof tasks, "/proc/%d/task", child);
    assert_int_equal(count_entries(tasks), 1);
    assert_int_equal(murk_medium_from_volume(*state, volume, NULL, &medium), MURK_OK);
    const murk_scene scene = {.medium = medium};
    assert_int_equal(murk_solve(*state, &scene, NULL, &solution), MURK_OK);
    murk_write_options options = MURK_WRITE_DEFAULT;
    options.source = volume;
    assert_int_equal(murk_solution_write(solution, odd("by_child.vdb"), &options), MURK_OK);
    assert_int_equal(count_entries(tasks), 1);

    kill(child, SIGSEGV);
    murk_medium *another = NULL;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(murk_medium_from_volume(*state, volume, NULL, &another), MURK_ERROR_INPUT);
        assert_message(*state, "box.vdb: OpenVDB crashed (Segmentation fault) on it");
    }
    remove(odd("by_child.vdb"));
    assert_int_equal(murk_solution_write(solution, odd("by_child.vdb"), &options),
                     MURK_ERROR_INPUT);
    assert_int_equal(access(odd("by_child.vdb"), F_OK), -1);
    murk_volume_release(volume);
    murk_solution_release(solution);
    murk_medium_release(medium);
    assert_alone();
}

/* Of a long sequence nothing is left behind, and the threads that OpenMP and TBB have by now are
   not carried over. */
static void test_sequence(void **state)
{
    size_t before = count_entries("/proc/self/fd");
    char tasks[100];
    for (int i = 0; i < 200; i++) {
        murk_vdb *vdb = NULL;
        murk_bricks bricks = {0};
        assert_int_equal(murk_vdb_read(*state, odd("half.vdb"), &vdb), MURK_OK);
        assert_int_equal(murk_vdb_bricks(*state, vdb, 0, 0, &bricks), MURK_OK);
        murk_bricks_clear(&bricks);
        snprintf(tasks, sizeof tasks, "/proc/%d/task", find_child());
        assert_int_equal(count_entries(tasks), 1);
        murk_vdb_release(vdb);
    }
    assert_int_equal(count_entries("/proc/self/fd"), before);
    assert_alone();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_child),
                                       cmocka_unit_test(test_sequence)};
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
