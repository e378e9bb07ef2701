/* SPDX-License-Identifier: Apache-2.0 */
/* The frames of a sequence on several processes at once. */
#ifndef CLI_POOL_H
#define CLI_POOL_H

#include "tally.h"
#include "worker.h"

/*
 * Runs the frames on `count` workers and tells of them in their order: what a frame printed on
 * standard output comes out in one piece after that of the frames before; so do its messages, line
 * by line once they have. Whoever is idle gets the next frame. One whose process is killed has
 * failed; another process takes its place. Fails with MURK_ERROR_MEMORY, or MURK_ERROR_INTERNAL
 * where the system has no more processes, and has told the user; what then was not run is in no
 * tally.
 */
murk_status cli_pool_run(const struct cli_crew *crew, size_t count, struct cli_job *job,
                         struct cli_tally *tally);

#endif
