/* SPDX-License-Identifier: Apache-2.0 */
/* One frame of a sequence. */
#ifndef CLI_FRAME_H
#define CLI_FRAME_H

#include "sequence.h"
#include "unsteady.h"

/* What a frame came to. */
struct cli_frame_result {
    murk_status status;
    bool skipped;                     /* --resume: an earlier run has finished it */
    char unsteady[CLI_UNSTEADY_SIZE]; /* what it left open; "" where nothing, or it failed */
};

/* Runs the steps on a frame, up to its line of --json. It depends on no other frame. */
void cli_frame_run(struct cli_job *job, const int *frame, const struct cli_steps *steps,
                   struct cli_frame_result *out);

/* What would fail for every frame, found by its name. */
murk_status cli_frame_check(struct cli_job *job, const int *frame, const struct cli_steps *steps);

/* What has to be known of each frame before the work on the first. */
murk_status cli_frame_survey(struct cli_job *job, const int *frame, const struct cli_steps *steps);

#endif
