/* SPDX-License-Identifier: Apache-2.0 */
/* --resume: what an earlier run has done. */
#ifndef CLI_RESUME_H
#define CLI_RESUME_H

#include "job.h"

/* Whether all outputs of a described job are there and newer than all of its inputs. An output that
   is there is complete: murk renames it into place. */
bool cli_resume_done(struct cli_job *job);

#endif
