/* SPDX-License-Identifier: Apache-2.0 */
#include "sequence.h"

#include "frame.h"
#include "jobs.h"
#include "pattern.h"
#include "plan.h"
#include "pool.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One run of a described job. */
static murk_status run_once(struct cli_job *job, const struct cli_steps *steps)
{
    murk_status status = steps->check(job);
    return status == MURK_OK ? steps->work(job) : status;
}

/* Frame after frame, where something is made of all of them. */
static void run_here(struct cli_job *job, const struct cli_frames *frames,
                     const struct cli_steps *steps, struct cli_tally *tally)
{
    for (size_t i = 0; i < frames->count; i++) {
        struct cli_frame_result result;
        cli_terminal_frame(&job->terminal, frames->number[i]);
        cli_frame_run(job, &frames->number[i], steps, &result);
        fflush(stdout); /* for whoever follows the sequence; main() tells about errors */
        cli_terminal_frames_end(&job->terminal);
        cli_tally_add(tally, job, frames->number[i], &result);
    }
}

static murk_status run_on_workers(struct cli_job *job, const struct cli_frames *frames,
                                  const struct cli_steps *steps, double frame_bytes,
                                  struct cli_tally *tally)
{
    int threads = cli_threads(job->options);
    int jobs = cli_jobs(job->options, frames->count, threads, frame_bytes);
    struct cli_crew crew = {.job = job,
                            .steps = steps,
                            .frames = frames,
                            .jobs = jobs,
                            .threads = threads > jobs ? threads / jobs : 1};
    if (job->options->verbose)
        cli_say(&job->terminal, "%d frame%s at once, each on %d thread%s", jobs,
                jobs == 1 ? "" : "s", crew.threads, crew.threads == 1 ? "" : "s");
    return cli_pool_run(&crew, (size_t)jobs, job, tally);
}

/* What the medium of a frame lets expect of the memory of each [bytes], after cli_plan(). */
static double frame_bytes(const struct cli_job *job, int frame)
{
    const struct scene_description *scene = &job->description;
    char *path =
        scene->medium_file ? scene_path(scene, scene->medium_file) : strdup(job->options->input);
    char *file = path ? cli_pattern_expand(path, frame) : NULL;
    double bytes = cli_jobs_frame_bytes(file);
    free(file);
    free(path);
    return bytes;
}

static murk_status run_frames(struct cli_job *job, const struct cli_frames *frames,
                              const struct cli_steps *steps)
{
    struct cli_tally tally = {.worst = MURK_OK};
    double bytes = frame_bytes(job, frames->number[0]);
    murk_status status = cli_frame_check(job, &frames->number[0], steps);
    for (size_t i = 0; steps->survey && i < frames->count && status == MURK_OK; i++)
        status = cli_frame_survey(job, &frames->number[i], steps);
    if (status == MURK_OK && (steps->finish || steps->survey))
        run_here(job, frames, steps, &tally);
    else if (status == MURK_OK)
        status = run_on_workers(job, frames, steps, bytes, &tally);
    return cli_worse(status, cli_tally_end(&tally, job, frames->count));
}

int cli_run(const struct cli_options *options, const char *command, const char *command_line,
            const struct cli_steps *steps)
{
    struct cli_job job;
    struct cli_frames frames = {0};
    murk_status status = cli_job_start(&job, options, command, command_line);
    job.state = steps->state;
    if (status == MURK_OK)
        status = cli_plan(&job, &frames);
    if (status == MURK_OK)
        status = frames.count ? run_frames(&job, &frames, steps) : run_once(&job, steps);
    if (steps->finish)
        status = cli_worse(status, steps->finish(&job));
    cli_frames_release(&frames);
    return cli_job_end(&job, status);
}
