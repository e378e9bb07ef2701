/* SPDX-License-Identifier: Apache-2.0 */
/* Wall-clock time. */
#ifndef BENCH_SECONDS_H
#define BENCH_SECONDS_H

#include <time.h>

/* Seconds since some time in the past. */
static inline double bench_seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
