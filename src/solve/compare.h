/* SPDX-License-Identifier: Apache-2.0 */
/* What a halving of voxels changes of a solution with few directions. */
#ifndef MURK_SOLVE_COMPARE_H
#define MURK_SOLVE_COMPARE_H

#include "levels.h"

/* A level, and that of its halved voxels. */
typedef struct murk_compared {
    murk_levels *levels;
    int count; /* of bands */
    murk_levels *next;
    int next_count;
    const int32_t *base; /* of the halving, in voxels of the first */
    int band;            /* that the next level is of, speaking for all; -1: it has all bands */
} murk_compared;

/* Sets out to the relative change in each band that infinitely many directions would find. */
murk_status murk_compare(murk_context *context, const murk_solve_options *options,
                         const murk_compared *of, double out[]);

#endif
