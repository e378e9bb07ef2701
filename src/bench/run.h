/* SPDX-License-Identifier: Apache-2.0 */
/* One measurement: a solve, or a Monte Carlo, in a process of its own. */
#ifndef BENCH_RUN_H
#define BENCH_RUN_H

#include "scenes.h"

/* What a run gives, as numbers; NaN where there is none. Seconds are wall-clock seconds. */
#define BENCH_RESULT_LIST(X)                                                                       \
    X(zones)                                                                                       \
    X(patches)                                                                                     \
    X(packets) /* Monte Carlo: of light, from each source */                                       \
    X(bricks)                                                                                      \
    X(threads)                                                                                     \
    X(directions)                                                                                  \
    X(iterations)                                                                                  \
    X(sweeps)                                                                                      \
    X(crossings)                                                                                   \
    X(tolerance)                                                                                   \
    X(estimate)       /* of the error; Monte Carlo: its standard error, in the same norm */        \
    X(reached)        /* 0 or 1 */                                                                 \
    X(error)          /* against the reference, kappa_t-weighted relative L2 norm over zones */    \
    X(error_95)       /* 95th percentile of the relative error of a zone */                        \
    X(seconds)        /* of the solve: setup, light, solve and finish */                           \
    X(seconds_medium) /* bricks to murk_medium */                                                  \
    X(seconds_setup)                                                                               \
    X(seconds_light)                                                                               \
    X(seconds_solve)                                                                               \
    X(seconds_finish)                                                                              \
    X(seconds_exchange)                                                                            \
    X(seconds_render)  /* 1920 x 1080 pixels; NaN where not asked for */                           \
    X(ns_per_crossing) /* seconds_exchange * threads / crossings */                                \
    X(peak_bytes)      /* of medium and solve above what the process held before */                \
    X(bytes_per_zone)                                                                              \
    X(multiplications) /* [BG91] eq. (18), or (19) with a window */

struct bench_result {
#define BENCH_RESULT_FIELD(name) double name;
    BENCH_RESULT_LIST(BENCH_RESULT_FIELD)
#undef BENCH_RESULT_FIELD
};

/* What several runs came to. */
struct bench_outcome {
    struct bench_result median; /* of each number by itself */
    char kernel[16];
    char message[512]; /* one line, where they failed */
};

/* What is measured. Everything is borrowed. */
struct bench_run {
    const struct bench_voxels *voxels;
    const struct bench_voxels *frame; /* what the scene is made for; NULL: the voxels */
    bench_scene_fn *scene;
    murk_solve_options solve;
    long packets;       /* > 0: a Monte Carlo with so many in place of the solve */
    int threads;        /* 0: all */
    const char *kernel; /* NULL: the fastest */
    bool render;
    /* One radiosity for each value of voxels->kappa_t, in memory that is shared between processes:
       taken as the truth, or written where `refer` is set; may be NULL. */
    float *reference;
    bool refer;
};

/* Runs it `times` times, each in a forked process that has solved something small before, so that
   neither libraries nor threads have to be started. To be called before this process makes threads
   of its own. */
murk_status bench_run(const struct bench_run *run, int times, struct bench_outcome *out);

/* Memory for `reference`, shared with the processes of runs; NULL when there is none left. */
float *bench_reference_create(const struct bench_voxels *voxels);
void bench_reference_release(float *reference, const struct bench_voxels *voxels);

#endif
