/* SPDX-License-Identifier: Apache-2.0 */
/* The files that a run writes: checked before the work, written after all of it. */
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include "job.h"

/* Fails where an output is missing, has the wrong format or a folder that cannot be written. */
murk_status cli_output_check(struct cli_job *job);

/* Writes every output that the options ask for, from the job's picture and solution. */
murk_status cli_output_write(struct cli_job *job);

/* Writes the job's solutions as one VDB, by the names of bands or lights. */
murk_status cli_output_radiosity(struct cli_job *job, const char *const names[], size_t count,
                                 const char *path);

#endif
