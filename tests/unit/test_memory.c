/* SPDX-License-Identifier: Apache-2.0 */
/* Memory: its count, its limit, estimates of it, and what happens where it ends. */
#include "beside.h"
#include "memory.h"

#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static murk_context *context;

/* Solves and renders a volume; the status of what failed first. */
static murk_status work(const char *file, const murk_solve_options *options, murk_report *report)
{
    murk_volume *volume = NULL;
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    murk_image *image = NULL;
    murk_camera camera;
    murk_scene scene = {.sun = {.direction = {0, 0, -1}, .irradiance = 1}, .sky_radiance = 0.1};
    murk_medium_options medium_options = MURK_MEDIUM_DEFAULT;
    murk_status status = murk_volume_read(context, file, &volume);
    if (!status)
        status = murk_medium_from_volume(context, volume, &medium_options, &medium);
    scene.medium = medium;
    if (!status)
        status = murk_solve(context, &scene, options, &solution);
    if (!status && report)
        *report = *murk_solution_report(solution);
    if (!status)
        status = murk_camera_default(context, &scene, &camera);
    if (!status) {
        camera.size[0] = camera.size[1] = 16;
        status = murk_render(context, &scene, solution, &camera, NULL, &image);
    }
    murk_image_release(image);
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_volume_release(volume);
    return status;
}

static void count_returns_to_where_it_was(void **state)
{
    (void)state;
    uint64_t before = murk_memory_used();
    void *array = murk_alloc(1000, 1000);
    assert_true(murk_memory_used() >= before + 1000000);
    assert_true(murk_memory_peak() >= before + 1000000);
    murk_free(array);
    assert_true(murk_memory_used() == before);
}

static void limit_refuses_and_tells(void **state)
{
    (void)state;
    murk_memory_limit(murk_memory_used() + 1000);
    assert_null(murk_alloc(1, 2000));
    assert_int_equal(murk_fail(context, MURK_ERROR_MEMORY, "out of memory"), MURK_ERROR_MEMORY);
    assert_non_null(strstr(murk_context_message(context), "the memory limit is"));
    murk_memory_limit(0);
}

static void solve_is_refused_before_it_begins(void **state)
{
    (void)state;
    const murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_memory_limit(murk_memory_used() + (2 << 20));
    assert_int_equal(work(MURK_VOLUMES_DIR "/plume64_f045.vdb", &options, NULL), MURK_ERROR_MEMORY);
    murk_memory_limit(0);
    assert_non_null(strstr(murk_context_message(context), "solving needs about"));
}

static void machine_has_memory(void **state)
{
    (void)state;
    assert_true(murk_memory_machine() > 1 << 20);
    assert_true(murk_memory_machine() < (uint64_t)1 << 60);
}

/* Whichever array cannot be had: an error of memory, and all others are released. */
static void every_failure_is_clean(void **state)
{
    (void)state;
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.2;
    options.directions = 48;
    uint64_t before = murk_memory_used();
    bool failed = true;
    int64_t n = 0;
    for (; failed; n += 1 + n / 40) {
        murk_memory_fail_after(n);
        murk_status status = work(MURK_VOLUMES_DIR "/box.vdb", &options, NULL);
        failed = murk_memory_failed();
        if (status != (failed ? MURK_ERROR_MEMORY : MURK_OK))
            fail_msg("allocation %d: %s: %s", (int)n, murk_status_text(status),
                     murk_context_message(context));
        assert_true(murk_memory_used() == before);
    }
    murk_memory_fail_after(-1);
    assert_true(n > 100); /* arrays were made */
}

/* A signal finds the file that has a name, and takes it away. */
static void abandoned_output_is_gone(void **state)
{
    (void)state;
    char path[] = "/tmp/murk-test-XXXXXX", target[64];
    assert_non_null(mkdtemp(path));
    snprintf(target, sizeof target, "%s/out", path);
    murk_beside file;
    murk_beside_allow_nameless(false);
    assert_int_equal(murk_beside_open(context, target, &file), MURK_OK);
    assert_int_equal(murk_beside_write(context, &file, "text", 4), MURK_OK);
    assert_non_null(file.temporary);
    assert_int_equal(access(file.temporary, F_OK), 0);
    murk_outputs_abandon();
    assert_int_equal(rmdir(path), 0); /* empty */
    free(file.temporary);
    file.temporary = NULL; /* nothing of that name is left to take away */
    murk_beside_discard(&file);
    murk_beside_allow_nameless(true);
}

static void estimate_holds(const char *file, double tolerance)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    murk_report report = {.memory = 0};
    options.tolerance = tolerance;
    murk_memory_restart_peak();
    murk_status status = work(file, &options, &report);
    assert_true(status == MURK_OK || status == MURK_NOT_REACHED);
    double peak = (double)murk_memory_peak(), estimate = (double)report.memory;
    if (peak > estimate || peak < 0.6 * estimate)
        fail_msg("%s: estimated %.4g MB, taken %.4g MB", file, estimate / 1e6, peak / 1e6);
}

static void estimates_hold(void **state)
{
    (void)state;
    estimate_holds(MURK_VOLUMES_DIR "/plume64_f045.vdb", 0.05);
    estimate_holds(MURK_VOLUMES_DIR "/plume128_f038.vdb", 0.05);
    estimate_holds(MURK_VOLUMES_DIR "/fire80_f032.vdb", 0.05);
    estimate_holds(MURK_VOLUMES_DIR "/screen128_f060.vdb", 0.05);
}

static int create(void **state)
{
    (void)state;
    const murk_context_options options = {.threads = 2};
    return murk_context_create(&options, &context);
}

static int release(void **state)
{
    (void)state;
    murk_context_release(context);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(count_returns_to_where_it_was),
        cmocka_unit_test(limit_refuses_and_tells),
        cmocka_unit_test(solve_is_refused_before_it_begins),
        cmocka_unit_test(machine_has_memory),
        cmocka_unit_test(every_failure_is_clean),
        cmocka_unit_test(abandoned_output_is_gone),
        cmocka_unit_test(estimates_hold),
    };
    return cmocka_run_group_tests(tests, create, release);
}
