/* SPDX-License-Identifier: Apache-2.0 */
#include "sequence.h"

#include "paths.h"
#include "plan.h"
#include "report.h"
#include "resume.h"
#include "unsteady.h"

#include <stdio.h>

/* What came of the frames so far. */
struct tally {
    murk_status worst;
    size_t skipped;
    struct cli_frames failed, not_reached;
    bool told_unsteady;
};

/* One run of a described job: the only one, or that of a frame. */
static murk_status run_once(struct cli_job *job, const struct cli_steps *steps)
{
    murk_status status = steps->check(job);
    return status == MURK_OK ? steps->work(job) : status;
}

static int badness(murk_status status)
{
    switch (status) {
    case MURK_OK:
        return 0;
    case MURK_NOT_REACHED:
        return 1;
    case MURK_ERROR_INPUT:
        return 2;
    default:
        return 3;
    }
}

static void count_in(struct tally *tally, int frame, murk_status status)
{
    struct cli_frames *list = cli_job_failed(status)       ? &tally->failed
                              : status == MURK_NOT_REACHED ? &tally->not_reached
                                                           : NULL;
    if (list && cli_frames_add(list, frame) != MURK_OK)
        status = MURK_ERROR_MEMORY;
    if (badness(status) > badness(tally->worst))
        tally->worst = status;
}

/* The frame's line of --json, where the work has not printed one. */
static void report_frame(struct cli_job *job, bool skipped, murk_status status)
{
    if (!job->options->json)
        return;
    if (skipped)
        cli_report_frame(job, "skipped", NULL);
    else if (cli_job_failed(status))
        cli_report_frame(job, "failed", job->terminal.error);
    fflush(stdout); /* for whoever follows the sequence; main() tells about errors */
}

static murk_status work_on_frame(struct cli_job *job, const struct cli_steps *steps,
                                 struct tally *tally)
{
    murk_status status = cli_job_describe(job);
    bool skipped = status == MURK_OK && job->options->resume && cli_resume_done(job);
    if (status == MURK_OK && !skipped) {
        status = run_once(job, steps);
        if (!cli_job_failed(status) && !tally->told_unsteady)
            cli_unsteady_warn(job);
        tally->told_unsteady |= !cli_job_failed(status);
    }
    tally->skipped += skipped;
    report_frame(job, skipped, status);
    return status;
}

/* Makes the job one of a frame. */
static murk_status enter_frame(struct cli_job *job, const int *frame,
                               struct cli_frame_options *of_frame)
{
    murk_status status = cli_frame_options_make(job->options, job->command, *frame, of_frame);
    if (status != MURK_OK) {
        cli_error(&job->terminal, "out of memory");
        return status;
    }
    job->options = &of_frame->options;
    job->frame = frame;
    return MURK_OK;
}

static void leave_frame(struct cli_job *job, const struct cli_options *options,
                        struct cli_frame_options *of_frame, murk_status status)
{
    cli_job_next(job, status);
    job->options = options;
    job->frame = NULL;
    cli_frame_options_release(of_frame);
}

static murk_status run_frame(struct cli_job *job, const int *frame, const struct cli_steps *steps,
                             struct tally *tally)
{
    const struct cli_options *options = job->options;
    struct cli_frame_options of_frame;
    murk_status status = enter_frame(job, frame, &of_frame);
    if (status != MURK_OK)
        return status;
    status = work_on_frame(job, steps, tally);
    leave_frame(job, options, &of_frame, status);
    return status;
}

/* What would fail for every frame is told once, before the first. */
static murk_status check_first(struct cli_job *job, const int *frame, const struct cli_steps *steps)
{
    const struct cli_options *options = job->options;
    struct cli_frame_options of_frame;
    murk_status status = enter_frame(job, frame, &of_frame);
    if (status != MURK_OK)
        return status;
    status = steps->check(job);
    leave_frame(job, options, &of_frame, status);
    return status;
}

/* What has to be known of all frames before the work on the first. */
static murk_status survey(struct cli_job *job, const struct cli_frames *frames,
                          const struct cli_steps *steps)
{
    const struct cli_options *options = job->options;
    murk_status status = MURK_OK;
    for (size_t i = 0; steps->survey && i < frames->count && status == MURK_OK; i++) {
        struct cli_frame_options of_frame;
        status = enter_frame(job, &frames->number[i], &of_frame);
        if (status != MURK_OK)
            return status;
        status = cli_job_describe(job);
        if (status == MURK_OK)
            status = steps->survey(job);
        leave_frame(job, options, &of_frame, status);
    }
    return status;
}

static void say_tally(struct cli_job *job, const struct tally *tally, size_t count)
{
    enum { LIST_SIZE = 1000 };
    char list[LIST_SIZE];
    if (tally->skipped)
        cli_say(&job->terminal,
                "%zu of %zu frames skipped: their outputs are newer than their "
                "inputs",
                tally->skipped, count);
    if (tally->not_reached.count) {
        cli_frames_text(&tally->not_reached, list, sizeof list);
        cli_error(&job->terminal, "%zu of %zu frames did not reach the tolerance: %s",
                  tally->not_reached.count, count, list);
    }
    if (tally->failed.count) {
        cli_frames_text(&tally->failed, list, sizeof list);
        cli_error(&job->terminal, "%zu of %zu frames failed: %s", tally->failed.count, count, list);
    }
}

static murk_status run_frames(struct cli_job *job, const struct cli_frames *frames,
                              const struct cli_steps *steps)
{
    struct tally tally = {.worst = MURK_OK};
    murk_status status = check_first(job, &frames->number[0], steps);
    if (status == MURK_OK)
        status = survey(job, frames, steps);
    if (status != MURK_OK)
        return status;
    for (size_t i = 0; i < frames->count; i++) {
        int frame = frames->number[i];
        cli_terminal_frame(&job->terminal, frame, i + 1, frames->count);
        count_in(&tally, frame, run_frame(job, &frames->number[i], steps, &tally));
    }
    cli_terminal_frames_end(&job->terminal);
    say_tally(job, &tally, frames->count);
    cli_frames_release(&tally.failed);
    cli_frames_release(&tally.not_reached);
    return tally.worst;
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
    if (steps->finish) {
        murk_status finished = steps->finish(&job);
        status = badness(finished) > badness(status) ? finished : status;
    }
    cli_frames_release(&frames);
    return cli_job_end(&job, status);
}
