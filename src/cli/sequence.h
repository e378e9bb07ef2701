/* SPDX-License-Identifier: Apache-2.0 */
/* A command's run: once, or for each frame of a sequence. */
#ifndef CLI_SEQUENCE_H
#define CLI_SEQUENCE_H

#include "job.h"

typedef murk_status cli_work_fn(struct cli_job *job);

/* What a command does. */
struct cli_steps {
    cli_work_fn *check;  /* of the outputs, before all work */
    cli_work_fn *work;   /* with a described job, up to its written outputs and its report */
    cli_work_fn *finish; /* once, after the last frame, whatever came of them; NULL: nothing */
    void *state;         /* for job->state */
    /* Of each described frame before the work on the first; the first that fails ends the run.
       NULL: nothing. */
    cli_work_fn *survey;
};

/*
 * Runs the steps on what the options ask for. The frames of a sequence run in processes of their
 * own, some at once, unless there is a survey or a last step, for which they run here one after
 * another. None depends on another, so that the result is the same whatever runs at once, is left
 * out or has been made before; one that fails, or whose process is killed, does not stop the
 * others. Gives the exit status: of a sequence the worst, where a failure of the system is worse
 * than bad input, which is worse than a tolerance that is not reached.
 */
int cli_run(const struct cli_options *options, const char *command, const char *command_line,
            const struct cli_steps *steps);

#endif
