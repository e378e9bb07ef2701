/* SPDX-License-Identifier: Apache-2.0 */
/* What murk chooses anew for every frame of a sequence. */
#ifndef CLI_UNSTEADY_H
#define CLI_UNSTEADY_H

#include "job.h"

enum { CLI_UNSTEADY_SIZE = 160 };

/* Lists what a finished frame did not set, so that it was chosen from its medium alone and a film
   may jump, each with what sets it; "" where there is no such thing. */
void cli_unsteady_text(const struct cli_job *job, char text[CLI_UNSTEADY_SIZE]);

#endif
