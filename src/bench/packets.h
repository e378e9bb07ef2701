/* SPDX-License-Identifier: Apache-2.0 */
/* The Monte Carlo of the zonal model on the media of murk bench. */
#ifndef BENCH_PACKETS_H
#define BENCH_PACKETS_H

#include "scenes.h"

/* What a Monte Carlo came to. */
struct bench_packets {
    float *radiosity; /* the caller's, one for each value of voxels->kappa_t */
    double error;     /* standard error, kappa_t-weighted relative L2 norm over the zones */
    double seconds;
};

/* Lights voxels in a scene of bench_scene_alone() or bench_scene_paper() with `packets` packets of
   light from each source, on `threads` threads (0: all). Fails with MURK_ERROR_MEMORY. */
murk_status bench_packets_run(const murk_scene *scene, const struct bench_voxels *voxels,
                              long packets, int threads, struct bench_packets *out);

#endif
