/* SPDX-License-Identifier: Apache-2.0 */
/* Where the lines of a lattice come from and go to: sky and ground. */
#ifndef MURK_EXCHANGE_BOUNDARY_H
#define MURK_EXCHANGE_BOUNDARY_H

#include "ground.h"
#include "kernel.h"

/* Lines enter and leave in tiles of 8 x 8. */
enum { MURK_TILE = 8, MURK_TILE_LINES = MURK_TILE * MURK_TILE };

/* What the lines of one band bring along, as pi times radiance [W/m^2]. */
typedef struct murk_incoming {
    const float *patch; /* radiosity of each patch, NULL: 0 */
    double sky, horizon;
    bool uniform; /* a beam: every line brings `sky`, wherever it comes from */
} murk_incoming;

/*
 * The lines of one lattice against the ground. Each line stands for a beam whose footprint on the
 * ground is a parallelogram; it is sampled at samples[0] x samples[1] points, so that footprints
 * tile the ground and emission and deposit use the same weights (reciprocity).
 */
typedef struct murk_boundary {
    const murk_ground *ground;
    int heading; /* of the lines: -1 down to the ground, +1 up from it, 0 they never meet it */
    /* Footprint centre of line r: hit + r_u per_u + r_v per_v, in interior patches from the first
     */
    double hit[2], per_u[2], per_v[2];
    int samples[2];
    double span; /* of a footprint in units of per_u and per_v */
} murk_boundary;

/* beam: the lines are those of one beam, whose shadows have edges that deserve more samples. */
void murk_boundary_lay(murk_boundary *boundary, const murk_grid *grid, const murk_ground *ground,
                       const murk_lattice *lattice, bool beam);

/* Sets the states of the tile of lines from (u, v) on as they enter, for `bands` bands that lie
   `band` apart, rows `stride` apart, and adds them to sum [bands]. */
void murk_boundary_enter(const murk_boundary *boundary, const murk_incoming *incoming, int bands,
                         int32_t u, int32_t v, float *state, ptrdiff_t stride, ptrdiff_t band,
                         double *sum);

/* Adds power_per_line * (I_out - I_in) of the same lines to the patches where they end on the
   ground [W]; patch_power [bands] and its arrays may be NULL. Adds the states to sum [bands]. */
void murk_boundary_leave(const murk_boundary *boundary, const murk_incoming *incoming, int bands,
                         int32_t u, int32_t v, const float *state, ptrdiff_t stride, ptrdiff_t band,
                         double power_per_line, double *const *patch_power, double *sum);

#endif
