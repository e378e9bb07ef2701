/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* CPU sets */
#include "jobs.h"

#include "cgroup.h"

#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

/* ---- threads ------------------------------------------------------------------------------- */

static int processors(void)
{
    enum { MOST = 8192 };
    cpu_set_t *set = CPU_ALLOC(MOST);
    size_t size = CPU_ALLOC_SIZE(MOST);
    int count = set && !sched_getaffinity(0, size, set) ? CPU_COUNT_S(size, set) : 1;
    CPU_FREE(set);
    return (int)fmax(1, fmin(count, ceil(cli_cgroup_limit("cpu.max"))));
}

int cli_threads(const struct cli_options *options)
{
    const char *text = getenv("OMP_NUM_THREADS");
    long asked = text ? strtol(text, NULL, 10) : 0;
    if (options->threads > 0)
        return options->threads;
    return asked > 0 && asked <= 4096 ? (int)asked : processors();
}

/* ---- frames -------------------------------------------------------------------------------- */

/* The part of a frame's work that more threads do not speed up: reading, compressing and writing
   files, and what the solver loses between its loops. Two threads make 1.7 of one. */
static const double SERIAL = 0.18;

/* Time of the sequence in times of a frame on one thread. */
static double sequence_time(size_t count, int threads, int jobs)
{
    double rounds = (double)((count + (size_t)jobs - 1) / (size_t)jobs);
    return rounds * (SERIAL + (1.0 - SERIAL) / (threads / jobs));
}

/* That can be had without swapping [bytes]. */
static double available_memory(void)
{
    double kilobytes = INFINITY;
    char line[128];
    FILE *file = fopen("/proc/meminfo", "r");
    while (file && fgets(line, sizeof line, file) &&
           sscanf(line, "MemAvailable: %lf", &kilobytes) != 1)
        ;
    if (file)
        fclose(file);
    return fmin(1024.0 * kilobytes, cli_cgroup_limit("memory.max"));
}

double cli_jobs_frame_bytes(const char *medium_file)
{
    /* The file's size is all that may be looked at: reading it would start threads, which the
       workers, copies of this process, would not have.

       Plumes of 0.1 to 1.7 MB take 150 to 220 MB; large ones about 12 bytes of file a voxel, and
       some hundred of memory. */
    const double program = 2e8, per_byte = 100;
    struct stat info;
    bool known = medium_file && !stat(medium_file, &info);
    return program + (known ? per_byte * (double)info.st_size : 0.0);
}

int cli_jobs(const struct cli_options *options, size_t count, int threads, double frame_bytes)
{
    const double memory =
        fmin(available_memory(), isnan(options->max_memory) ? INFINITY : options->max_memory);
    const double most = fmax(1, floor(memory / frame_bytes));
    int best = 1;
    if (options->jobs > 0)
        return (size_t)options->jobs < count ? options->jobs : (int)count;
    for (int jobs = 2; jobs <= threads && (size_t)jobs <= count && jobs <= most; jobs++)
        if (sequence_time(count, threads, jobs) < sequence_time(count, threads, best))
            best = jobs;
    return best;
}
