/* SPDX-License-Identifier: Apache-2.0 */
#include "work.h"

#include "murk/memory.h"
#include "output.h"
#include "report.h"
#include "sequence.h"
#include "show.h"

#include <string.h>

/* From a described job to a scene. */
static murk_status prepare(struct cli_job *job)
{
    murk_status status = cli_job_read(job);
    return status == MURK_OK ? cli_job_build(job) : status;
}

/* Whether the camera can take the picture that is asked for, before any long work. */
static murk_status aim(struct cli_job *job)
{
    murk_status status = cli_job_fail(
        job, murk_camera_check(job->context, &job->scene.band[0].scene, &job->scene.camera));
    return status == MURK_OK ? cli_show_check_channel(job) : status;
}

/* Whether the pictures that are asked for fit into memory. */
static murk_status afford(struct cli_job *job)
{
    const struct scene *scene = &job->scene;
    const murk_scene *first = &scene->band[0].scene;
    const size_t bands = scene->band[0].name ? scene->band_count : 0;
    double bytes = (double)murk_render_memory(first, &scene->camera, bands);
    if (job->options->deep)
        bytes += (double)murk_render_deep_memory(first, &scene->camera, bands);
    return cli_job_afford(job, scene->band_count,
                          job->options->deep ? "the picture with its --deep one" : "the picture",
                          bytes);
}

/* Writes everything and tells what came out. */
static murk_status conclude(struct cli_job *job, murk_status status)
{
    if (cli_job_failed(status))
        return status;
    murk_status written = cli_output_write(job);
    if (written != MURK_OK)
        return written;
    cli_report_say(job, status);
    if (job->options->json)
        cli_report_json(job, status);
    return status;
}

static murk_status image(struct cli_job *job)
{
    murk_status status = prepare(job);
    if (!cli_job_failed(status))
        status = aim(job);
    if (!cli_job_failed(status))
        status = afford(job);
    if (!cli_job_failed(status))
        status = cli_job_solve(job);
    if (!cli_job_failed(status)) {
        murk_status rendered = cli_job_render(job);
        status = rendered == MURK_OK ? status : rendered;
    }
    return conclude(job, status);
}

static murk_status solve(struct cli_job *job)
{
    murk_status status = prepare(job);
    if (!cli_job_failed(status) && job->options->usd)
        status = aim(job);
    if (!cli_job_failed(status))
        status = cli_job_solve(job);
    return conclude(job, status);
}

/* The solution of an earlier run, from its VDB. */
static murk_status read_solution(struct cli_job *job)
{
    murk_volume *volume = NULL;
    double start = cli_seconds();
    murk_status status = murk_volume_read(job->context, job->options->radiosity, &volume);
    for (size_t n = 0; n < job->scene.band_count && status == MURK_OK; n++) {
        const struct scene_band *band = &job->scene.band[n];
        status = murk_solution_from_volume_band(job->context, &band->scene, volume, band->name,
                                                &job->solution[n]);
    }
    murk_volume_release(volume);
    cli_terminal_clear(&job->terminal);
    job->seconds_read += cli_seconds() - start;
    return cli_job_fail(job, status);
}

static murk_status render(struct cli_job *job)
{
    murk_status status = prepare(job);
    if (status == MURK_OK)
        status = aim(job);
    if (status == MURK_OK)
        status = afford(job);
    if (status == MURK_OK)
        status = read_solution(job);
    if (status == MURK_OK)
        status = cli_job_render(job);
    return conclude(job, status);
}

int cli_image(const struct cli_options *options, const char *command_line)
{
    static const struct cli_steps STEPS = {.check = cli_output_check, .work = image};
    return cli_run(options, "image", command_line, &STEPS);
}

int cli_solve(const struct cli_options *options, const char *command_line)
{
    static const struct cli_steps STEPS = {.check = cli_output_check, .work = solve};
    return cli_run(options, "solve", command_line, &STEPS);
}

int cli_render(const struct cli_options *options, const char *command_line)
{
    static const struct cli_steps STEPS = {.check = cli_output_check, .work = render};
    struct cli_terminal terminal;
    cli_terminal_init(&terminal, options->quiet, options->verbose);
    if (!options->radiosity) {
        cli_error(&terminal, "render: needs --radiosity FILE.vdb, which murk solve writes");
        return 1;
    }
    if (!strcmp(options->radiosity, "-") && !strcmp(options->input, "-")) {
        cli_error(&terminal, "INPUT and --radiosity cannot both be standard input");
        return 1;
    }
    return cli_run(options, "render", command_line, &STEPS);
}
