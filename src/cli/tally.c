/* SPDX-License-Identifier: Apache-2.0 */
#include "tally.h"

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

murk_status cli_worse(murk_status a, murk_status b)
{
    return badness(b) > badness(a) ? b : a;
}

static void warn_unsteady(struct cli_job *job, int frame, const char *open)
{
    cli_terminal_frame(&job->terminal, frame);
    cli_say(&job->terminal, "warning: chosen for this frame alone, so the sequence may jump: %s",
            open);
    cli_terminal_frames_end(&job->terminal);
}

void cli_tally_add(struct cli_tally *tally, struct cli_job *job, int frame,
                   const struct cli_frame_result *result)
{
    murk_status status = result->status;
    struct cli_frames *list = cli_job_failed(status)       ? &tally->failed
                              : status == MURK_NOT_REACHED ? &tally->not_reached
                                                           : NULL;
    if (list && cli_frames_add(list, frame) != MURK_OK)
        status = MURK_ERROR_MEMORY;
    tally->worst = cli_worse(tally->worst, status);
    tally->skipped += result->skipped;
    if (cli_job_failed(status) || result->skipped)
        return;
    if (!tally->told_unsteady && *result->unsteady)
        warn_unsteady(job, frame, result->unsteady);
    tally->told_unsteady = true; /* one frame leaves open what the others do */
}

murk_status cli_tally_end(struct cli_tally *tally, struct cli_job *job, size_t count)
{
    enum { LIST_SIZE = 1000 };
    char list[LIST_SIZE];
    if (tally->skipped)
        cli_say(&job->terminal,
                "%zu of %zu frames skipped: their outputs are newer than their inputs, and made by "
                "this command",
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
    cli_frames_release(&tally->failed);
    cli_frames_release(&tally->not_reached);
    return tally->worst;
}
