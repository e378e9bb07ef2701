/* SPDX-License-Identifier: Apache-2.0 */
/* --resume: what an earlier run has done. */
#ifndef CLI_RESUME_H
#define CLI_RESUME_H

#include "job.h"

/* Whether all outputs of a described job are there, newer than all of its inputs, and made by the
   command that is running, as they themselves tell. An output that is there is complete: murk
   renames it into place. */
bool cli_resume_done(struct cli_job *job);

#endif
