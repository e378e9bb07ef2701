/* SPDX-License-Identifier: Apache-2.0 */
#include "frame.h"

#include "paths.h"
#include "report.h"
#include "resume.h"

#include <stdio.h>

/* Makes the job one of a frame. */
static murk_status enter(struct cli_job *job, const int *frame, struct cli_frame_options *of_frame)
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

static void leave(struct cli_job *job, const struct cli_options *options,
                  struct cli_frame_options *of_frame)
{
    cli_job_next(job);
    job->options = options;
    job->frame = NULL;
    cli_frame_options_release(of_frame);
}

/* The frame's line of --json, where the work has not printed one. */
static void report(const struct cli_job *job, const struct cli_frame_result *result)
{
    if (!job->options->json)
        return;
    if (result->skipped)
        cli_report_frame(*job->frame, "skipped", NULL);
    else if (cli_job_failed(result->status))
        cli_report_frame(*job->frame, "failed", job->terminal.error);
}

static void work(struct cli_job *job, const struct cli_steps *steps, struct cli_frame_result *out)
{
    out->status = cli_job_describe(job);
    out->skipped = out->status == MURK_OK && job->options->resume && cli_resume_done(job);
    if (out->status != MURK_OK || out->skipped)
        return;
    out->status = steps->check(job);
    if (out->status == MURK_OK)
        out->status = steps->work(job);
    if (!cli_job_failed(out->status))
        cli_unsteady_text(job, out->unsteady);
}

void cli_frame_run(struct cli_job *job, const int *frame, const struct cli_steps *steps,
                   struct cli_frame_result *out)
{
    const struct cli_options *options = job->options;
    struct cli_frame_options of_frame;
    *out = (struct cli_frame_result){.status = enter(job, frame, &of_frame)};
    if (out->status != MURK_OK)
        return;
    work(job, steps, out);
    report(job, out);
    leave(job, options, &of_frame);
}

static murk_status visit(struct cli_job *job, const int *frame, cli_work_fn *step, bool described)
{
    const struct cli_options *options = job->options;
    struct cli_frame_options of_frame;
    murk_status status = enter(job, frame, &of_frame);
    if (status != MURK_OK)
        return status;
    if (described)
        status = cli_job_describe(job);
    if (status == MURK_OK)
        status = step(job);
    leave(job, options, &of_frame);
    return status;
}

murk_status cli_frame_check(struct cli_job *job, const int *frame, const struct cli_steps *steps)
{
    return visit(job, frame, steps->check, false);
}

murk_status cli_frame_survey(struct cli_job *job, const int *frame, const struct cli_steps *steps)
{
    return visit(job, frame, steps->survey, true);
}
