/* SPDX-License-Identifier: Apache-2.0 */
/* How many frames of a sequence to run side by side. */
#ifndef CLI_JOBS_H
#define CLI_JOBS_H

#include "frames.h"
#include "options.h"

/* Threads for all of a command: --threads, or else OMP_NUM_THREADS, or else the processors that the
   process may use (its CPU set, and the processor time of its control group). */
int cli_threads(const struct cli_options *options);

/*
 * Frames at once, out of `count` on `threads` threads: --jobs, or else the number that ends first,
 * as far as memory holds them; frame_bytes is what one needs. Each gets threads/jobs threads.
 */
int cli_jobs(const struct cli_options *options, size_t count, int threads, double frame_bytes);

/* What the frame's files let expect of its memory [bytes]. */
double cli_jobs_frame_bytes(const char *medium_file);

#endif
