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
 * Runs the steps on what the options ask for. The frames of a sequence run one after another, each
 * solve starting from the frame before; one that fails does not stop the others. Gives the exit
 * status: of a sequence the worst, where a failure of the system is worse than bad input, which is
 * worse than a tolerance that is not reached.
 */
int cli_run(const struct cli_options *options, const char *command, const char *command_line,
            const struct cli_steps *steps);

#endif
