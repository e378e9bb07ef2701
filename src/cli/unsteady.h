/* SPDX-License-Identifier: Apache-2.0 */
/* What murk chooses anew for every frame of a sequence. */
#ifndef CLI_UNSTEADY_H
#define CLI_UNSTEADY_H

#include "job.h"

/* Warns where what a finished frame did not set was chosen from its medium alone, so that a film
   may jump; names what sets it. */
void cli_unsteady_warn(struct cli_job *job);

#endif
