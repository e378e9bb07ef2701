/* SPDX-License-Identifier: Apache-2.0 */
/* The inner loop of [BG91] eq. (11): a packet of rays, brick by brick. */
#ifndef MURK_RENDER_MARCH_KERNEL_H
#define MURK_RENDER_MARCH_KERNEL_H

#include "boxes.h"
#include "packet.h"

/* The medium as rays see it. */
typedef struct murk_marched {
    const float *kappa_t; /* field on the medium's grid [1/m] */
    const float *blocks;  /* radiosity, see blocks.h */
    const murk_box *box;
} murk_marched;

/* Steps that a ray makes in one brick at most: 7 faces between voxels on each axis. */
enum { MURK_BRICK_STEPS = 22 };
/* What is behind this much transmittance cannot be seen in a float picture of eight digits. */
#define MURK_OPAQUE 1e-7

/*
 * Carries a packet through `count` bricks, in the order that they stand in, and adds to its depth,
 * tau and path; all steps are put down in the trace, with the path if it records that. Gives back
 * how many bricks there was room for: each wants MURK_BRICK_STEPS. Without a trace only the depth
 * is computed.
 */
typedef size_t murk_march_fn(const murk_marched *medium, const int32_t *brick, size_t count,
                             murk_packet *packet, murk_trace *trace);

#endif
