/* SPDX-License-Identifier: Apache-2.0 */
#include "run.h"

#include "error.h"
#include "memory.h"
#include "packets.h"
#include "seconds.h"
#include "statistics.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum { RENDER_WIDTH = 1920, RENDER_HEIGHT = 1080 };
enum { RESULT_COUNT = sizeof(struct bench_result) / sizeof(double) };

/* What goes through the pipe from the process of a run. */
struct answer {
    murk_status status;
    struct bench_result result;
    char kernel[16], message[512];
};

/* ---- in the process of a run --------------------------------------------------------------- */

/* Not reaching the tolerance is a result like others. */
static murk_status solve(murk_context *context, const murk_scene *scene,
                         const murk_solve_options *options, murk_solution **out)
{
    murk_status status = murk_solve(context, scene, options, out);
    return status == MURK_NOT_REACHED ? MURK_OK : status;
}

/* Loads code and starts threads, so that no measurement has to. */
static murk_status warm_up(murk_context *context, const murk_solve_options *options)
{
    const murk_array box = {
        .size = {16, 16, 16}, .voxel_size = {1, 1, 1}, .kappa_t_value = 0.1, .albedo_value = 0.5};
    murk_solve_options rough = MURK_SOLVE_DEFAULT;
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    rough.tolerance = 0.05;
    rough.method = options->method;
    murk_status status = murk_medium_from_array(context, &box, &medium);
    const murk_scene scene = {.medium = medium, .sky_radiance = 1};
    if (!status)
        status = solve(context, &scene, &rough, &solution);
    murk_solution_release(solution);
    murk_medium_release(medium);
    return status;
}

static murk_status make_scene(murk_context *context, const struct bench_run *run, murk_scene *scene,
                              murk_ground **ground)
{
    murk_medium *medium = NULL;
    murk_status status =
        bench_voxels_medium(context, run->frame ? run->frame : run->voxels, &medium);
    if (!status)
        status = run->scene(context, medium, scene, ground);
    murk_medium_release(medium);
    return status;
}

static void take_report(const murk_report *report, struct bench_result *result)
{
    result->zones = (double)report->zones;
    result->patches = (double)report->patches;
    result->bricks = (double)report->bricks;
    result->threads = report->threads;
    result->directions = report->directions;
    result->iterations = report->iterations;
    result->sweeps = report->sweeps;
    result->crossings = report->crossings > 0 ? report->crossings : NAN;
    result->tolerance = report->tolerance;
    result->estimate = report->estimate;
    result->reached = report->reached;
    result->seconds = report->seconds_setup + report->seconds_light + report->seconds_solve +
                      report->seconds_finish;
    result->seconds_setup = report->seconds_setup;
    result->seconds_light = report->seconds_light;
    result->seconds_solve = report->seconds_solve;
    result->seconds_finish = report->seconds_finish;
    result->seconds_exchange = report->seconds_exchange;
    result->ns_per_crossing = 1e9 * report->seconds_exchange * report->threads / result->crossings;
    result->multiplications = report->multiplications_window > 0 ? report->multiplications_window
                                                                 : report->multiplications;
}

static murk_status render(murk_context *context, const murk_scene *scene,
                          const murk_solution *solution, struct bench_result *result)
{
    murk_camera camera;
    murk_image *image = NULL;
    murk_status status = murk_camera_default(context, scene, &camera);
    camera.size[0] = RENDER_WIDTH;
    camera.size[1] = RENDER_HEIGHT;
    double start = bench_seconds();
    if (!status)
        status = murk_render(context, scene, solution, &camera, NULL, &image);
    result->seconds_render = bench_seconds() - start;
    murk_image_release(image);
    return status;
}

/* A solve, of a scene without its medium. */
static murk_status measure_solve(murk_context *context, const struct bench_run *run,
                                 murk_scene *scene, float *radiosity, struct answer *out)
{
    struct bench_result *result = &out->result;
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    double before = bench_memory_start(), start = bench_seconds();
    murk_status status = bench_voxels_medium(context, run->voxels, &medium);
    result->seconds_medium = bench_seconds() - start;
    scene->medium = medium;
    if (!status)
        status = solve(context, scene, &run->solve, &solution);
    if (!status) {
        const murk_report *report = murk_solution_report(solution);
        take_report(report, result);
        snprintf(out->kernel, sizeof out->kernel, "%s", report->kernel);
        result->peak_bytes = bench_memory_peak() - before;
        result->bytes_per_zone = result->peak_bytes / result->zones;
        bench_error_take(solution, run->voxels, radiosity);
    }
    if (!status && run->render)
        status = render(context, scene, solution, result);
    murk_solution_release(solution);
    murk_medium_release(medium);
    return status;
}

static murk_status measure_packets(const struct bench_run *run, const murk_scene *scene,
                                   float *radiosity, struct bench_result *result)
{
    struct bench_packets packets = {.radiosity = radiosity};
    murk_status status =
        bench_packets_run(scene, run->voxels, run->packets, run->threads, &packets);
    result->zones = (double)bench_voxels_active(run->voxels);
    result->packets = (double)run->packets;
    result->estimate = packets.error;
    result->seconds = packets.seconds;
    return status;
}

/* The part that is measured, and the error of what came out. */
static murk_status measure(murk_context *context, const struct bench_run *run, murk_scene *scene,
                           struct answer *out)
{
    struct bench_result *result = &out->result;
    float *own = run->refer ? NULL : calloc(run->voxels->count * BENCH_SLOTS, sizeof *own);
    float *radiosity = run->refer ? run->reference : own;
    murk_status status = radiosity ? MURK_OK : MURK_ERROR_MEMORY;
    if (!status && run->packets > 0)
        status = measure_packets(run, scene, radiosity, result);
    else if (!status)
        status = measure_solve(context, run, scene, radiosity, out);
    if (!status && run->reference && !run->refer)
        status =
            bench_error_find(own, run->voxels, run->reference, &result->error, &result->error_95);
    free(own);
    return status;
}

static void answer(const struct bench_run *run, struct answer *out)
{
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    murk_context *context = NULL;
    murk_ground *ground = NULL;
    murk_scene scene;
    double *numbers = (double *)&out->result;
    for (int i = 0; i < RESULT_COUNT; i++)
        numbers[i] = NAN;
    options.threads = run->threads;
    options.kernel = run->kernel;
    out->status = murk_context_create(&options, &context);
    if (!out->status)
        out->status = warm_up(context, &run->solve);
    if (!out->status)
        out->status = make_scene(context, run, &scene, &ground);
    if (!out->status)
        out->status = measure(context, run, &scene, out);
    if (out->status) {
        const char *reason = context ? murk_context_message(context) : "";
        snprintf(out->message, sizeof out->message, "%s",
                 *reason ? reason : murk_status_text(out->status));
    }
    murk_ground_release(ground);
    murk_context_release(context);
}

/* ---- in the process that measures ---------------------------------------------------------- */

static bool send(int file, const struct answer *answer)
{
    const char *at = (const char *)answer;
    for (size_t left = sizeof *answer; left > 0;) {
        ssize_t sent = write(file, at, left);
        if (sent < 0)
            return false;
        at += sent;
        left -= (size_t)sent;
    }
    return true;
}

static bool receive(int file, struct answer *answer)
{
    char *at = (char *)answer;
    for (size_t left = sizeof *answer; left > 0;) {
        ssize_t got = read(file, at, left);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        left -= (size_t)got;
    }
    return true;
}

static murk_status run_once(const struct bench_run *run, struct answer *out)
{
    int ends[2], state = 0;
    *out = (struct answer){.status = MURK_ERROR_INTERNAL};
    if (pipe(ends) != 0) {
        snprintf(out->message, sizeof out->message, "cannot make a pipe: %s", strerror(errno));
        return MURK_ERROR_INTERNAL;
    }
    fflush(NULL); /* what is buffered is to be written once */
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        answer(run, out);
        _exit(!send(ends[1], out));
    }
    int fork_error = errno;
    close(ends[1]);
    bool answered = child > 0 && receive(ends[0], out);
    close(ends[0]);
    while (child > 0 && waitpid(child, &state, 0) < 0 && errno == EINTR)
        ;
    if (child < 0)
        snprintf(out->message, sizeof out->message, "cannot fork: %s", strerror(fork_error));
    else if (!answered && WIFSIGNALED(state))
        snprintf(out->message, sizeof out->message,
                 "the run was killed by signal %d (%s); is there memory enough?", WTERMSIG(state),
                 strsignal(WTERMSIG(state)));
    else if (!answered)
        snprintf(out->message, sizeof out->message, "the run ended without a result");
    return out->status;
}

murk_status bench_run(const struct bench_run *run, int times, struct bench_outcome *out)
{
    double *numbers = malloc((size_t)(RESULT_COUNT * times) * sizeof *numbers);
    double *median = (double *)&out->median;
    struct answer answer = {.status = numbers ? MURK_OK : MURK_ERROR_MEMORY,
                            .message = "out of memory"};
    for (int t = 0; t < times && !answer.status; t++)
        if (!run_once(run, &answer))
            for (int i = 0; i < RESULT_COUNT; i++)
                numbers[i * times + t] = ((const double *)&answer.result)[i];
    for (int i = 0; i < RESULT_COUNT && !answer.status; i++)
        median[i] = bench_median(numbers + i * times, (size_t)times);
    memcpy(out->kernel, answer.kernel, sizeof out->kernel);
    memcpy(out->message, answer.message, sizeof out->message);
    free(numbers);
    return answer.status;
}

float *bench_reference_create(const struct bench_voxels *voxels)
{
    float *reference = mmap(NULL, voxels->count * BENCH_SLOTS * sizeof *reference,
                            PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return reference == MAP_FAILED ? NULL : reference;
}

void bench_reference_release(float *reference, const struct bench_voxels *voxels)
{
    if (reference)
        munmap(reference, voxels->count * BENCH_SLOTS * sizeof *reference);
}
