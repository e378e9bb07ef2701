/* SPDX-License-Identifier: Apache-2.0 */
/* What this process holds in memory (Linux; NaN elsewhere). */
#ifndef BENCH_MEMORY_H
#define BENCH_MEMORY_H

/* Gives freed memory back, forgets the peak so far and gives the bytes resident now. */
double bench_memory_start(void);

/* The most bytes resident since then. */
double bench_memory_peak(void);

#endif
