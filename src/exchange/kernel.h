/* SPDX-License-Identifier: Apache-2.0 */
/* The inner loop of a sweep: the lines of one lattice through one brick. */
#ifndef MURK_EXCHANGE_KERNEL_H
#define MURK_EXCHANGE_KERNEL_H

#include "lattice.h"
#include "murk/exchange.h"

/* Lines are worked through in pairs of rows: 16 voxels, 4 chunks a layer, 32 a brick. */
enum { MURK_CHUNK = 16, MURK_LAYER_CHUNKS = 4 };

/* How 1 - exp(-x) is computed, by the largest x there is. */
typedef enum murk_depth { MURK_DEPTH_FAINT, MURK_DEPTH_THIN, MURK_DEPTH_ANY } murk_depth;

static inline murk_depth murk_depth_of(double x)
{
    return x < 0.07 ? MURK_DEPTH_FAINT : x < 0.3 ? MURK_DEPTH_THIN : MURK_DEPTH_ANY;
}

/*
 * kappa_t is 8 layers of 8 rows (v) of 8 voxels (u), source and tally as much for each band; all
 * are 64-byte aligned. Each segment does, with x = kappa_t * length,
 *     t = (1 - exp(-x)) (I - B);   tally += weight t;   I -= t
 * so that what a zone takes from a line is exactly what the line loses, at any optical depth. The
 * tally is left to be divided by kappa_t.
 *
 * With slopes the source is B + slope . p at p, in voxels from the zone's middle. A segment with
 * its middle at m, that goes c far, sees D = I - B - slope . m and g = slope . c, and does, with
 * e = 1 - exp(-x), q = 1/2 + 1/x and h = e q - 1,
 *     t0 = e D + h g;   t1 = h D + q h g;   tally += weight t0;   I -= t0
 *     slope_tally += weight (m t0 + c t1),
 * the integrals of kappa_t (I - source) and of that times p: exact, and symmetric in source and
 * tally (EQUATIONS.md, "Sources that vary within a zone").
 */
typedef struct murk_kernel_job {
    const float *kappa_t; /* > 0 [1/m] */
    const float *source;  /* B [W/m^2] */
    float *tally;
    /* Along u, v and the dominant axis, each like source, for each band; NULL: none. */
    const float *slope;
    float *slope_tally;
    uint32_t chunks; /* bit 4 layer + chunk: the chunk holds something */
    int bands;
    murk_depth depth;
    float *plane; /* I [W/m^2], pi times radiance, of line (brick's first u, v) - shift 0 */
    ptrdiff_t stride, band;  /* between rows of lines, and between bands */
    const murk_layer *layer; /* pattern of the brick's layer 0 ... 7 */
    int sign;                /* of travel through the layers */
    float weight;            /* of a line, over its length within a layer */
} murk_kernel_job;

typedef void murk_kernel_fn(const murk_kernel_job *job);

/* The kernel by name, or for NULL the fastest that this processor runs; *name is set to the name.
 */
murk_status murk_kernel_choose(murk_context *context, murk_kernel_fn **kernel, const char **name);

#endif
