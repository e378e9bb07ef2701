/* SPDX-License-Identifier: Apache-2.0 */
/* Radiation carried along sets of lines through the whole medium. */
#ifndef MURK_EXCHANGE_SWEEP_H
#define MURK_EXCHANGE_SWEEP_H

#include "kernel.h"
#include "plane.h"

typedef struct murk_sweep murk_sweep;

/* Lines of one set are shared out to threads in blocks of at most this many, all in one dominant
   axis and octant, so that a brick is loaded once for the block. */
enum { MURK_BLOCK = 8 };

/*
 * Prepares a set of lines for a grid with its kappa_t field and a ground (may be NULL), all kept by
 * the caller while the sweep lives. lines are copied.
 */
murk_status murk_sweep_create(murk_context *context, const murk_grid *grid, const float *kappa_t,
                              const murk_ground *ground, const murk_line *lines, int line_count,
                              murk_sweep **out);
void murk_sweep_release(murk_sweep *sweep);

const char *murk_sweep_kernel(const murk_sweep *sweep);

/*
 * Carries `incoming` and the source field (B per slot; NULL: none) along all lines.
 *   tally [slots]:        sum over lines of weight * fraction * phi * (I - B): for a full set of
 *                         directions G/4 - B, in slots without extinction G/4; NULL: not wanted
 *   patch_power [patches]: power per unit weight and area factor that arrives at each patch beyond
 *                         what would without the medium; NULL: not wanted. Overwritten.
 *   net_power:            what all lines bring in minus what they carry out [W]
 * power_factor is 4 for diffuse light (pi I over the sphere), 1 for a beam.
 * The sums over lines are in an order that depends on the number of threads: results agree to
 * 1e-6 relative for different numbers, and bitwise for the same.
 */
murk_status murk_sweep_run(murk_context *context, murk_sweep *sweep, const float *source,
                           const murk_incoming *incoming, double power_factor, float *tally,
                           double *patch_power, double *net_power);

#endif
