/* SPDX-License-Identifier: Apache-2.0 */
/* The light that a correction of the coarse solution brings to the zones themselves. */
#ifndef MURK_SOLVE_CORRECTION_H
#define MURK_SOLVE_CORRECTION_H

#include "coarse.h"

/* What arrives of it. */
typedef struct murk_correction {
    murk_vector light; /* G/4 of the coarse zones, its slopes, and H of the patches */
    double net_power;
} murk_correction;

/* Lets the coarse lines carry d of each band whose r is not 0, plus, where it is to be mended, the
   constant that makes the energies balance (coarse-mesh rebalance with one cell). The vectors of
   `out` hold 0, and keep it where nothing is carried. */
murk_status murk_correction_spread(murk_coarse *const band[], bool mend, murk_correction out[],
                                   int count);

/* Adds it to the net light of the region's zones, and to that of the margin in proportion; net is
   on the solution's grid. */
void murk_correction_add(const murk_coarse *coarse, const murk_correction *correction,
                         const murk_region *region, float *net);

#endif
