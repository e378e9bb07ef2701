/* SPDX-License-Identifier: Apache-2.0 */
/* Whether a command runs a sequence, and over which frames. */
#ifndef CLI_PLAN_H
#define CLI_PLAN_H

#include "frames.h"
#include "job.h"

/*
 * The frames that the options ask for, or else those on disk of the first pattern among INPUT,
 * the files of its scene and, to render, --radiosity; none at all: the command runs once. Leaves
 * the job described, except where INPUT itself is a pattern. Has told the user about a failure:
 * streams in a sequence, outputs without a pattern, no frames.
 */
murk_status cli_plan(struct cli_job *job, struct cli_frames *out);

#endif
