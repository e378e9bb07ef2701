/* SPDX-License-Identifier: Apache-2.0 */
/* The inner loop of a sweep: the lines of one direction through one brick. */
#ifndef MURK_EXCHANGE_KERNEL_H
#define MURK_EXCHANGE_KERNEL_H

#include "lattice.h"

/*
 * kappa_t, source and tally are 8 layers of 8 rows (v) of 8 voxels (u), 64-byte aligned. plane
 * points to the state of line (brick's first u, brick's first v) - shift 0, rows `stride` apart;
 * layer to the pattern of the brick's layer 0. With x = kappa_t * length and
 * phi = (1 - exp(-x)) / x each segment does
 *     t = phi (I - B);   tally += weight * fraction * t;   I -= x t
 * so that what a zone takes from a line is exactly what the line loses, at any optical depth.
 */
typedef struct murk_kernel_job {
    const float *kappa_t; /* 1/m */
    const float *source;  /* B [W/m^2] */
    float *tally;         /* G/4 - B [W/m^2] */
    float *plane;         /* I [W/m^2], pi times the radiance on each line */
    ptrdiff_t stride;
    const murk_layer *layer;
    int sign; /* of travel through the layers */
    float weight;
    bool thin; /* all x stay below MURK_THIN: phi by its series */
} murk_kernel_job;

#define MURK_THIN 0.3f

typedef void murk_kernel_fn(const murk_kernel_job *job);

/* The kernel by name, or for NULL the fastest that this processor runs; *name is set to the name.
 */
murk_status murk_kernel_choose(murk_context *context, murk_kernel_fn **kernel, const char **name);

#endif
