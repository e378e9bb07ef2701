/* SPDX-License-Identifier: Apache-2.0 */
/* Radiation carried along sets of lines through the whole medium. */
#ifndef MURK_EXCHANGE_SWEEP_H
#define MURK_EXCHANGE_SWEEP_H

#include "bent.h"
#include "kernel.h"
#include "plane.h"
#include "region.h"

typedef struct murk_sweep murk_sweep;

/* Lines of one set are shared out to threads in blocks of at most this many, all with one dominant
   axis and one way along it, so that a slab of bricks is laid out once for the block. */
enum { MURK_BLOCK = 16 };

/* What sweeps have done since they were created. */
typedef struct murk_traced {
    double crossings; /* zones times lines */
    double dark;      /* of them, those passed over because nothing was there to carry */
    double beyond;    /* of them, those that a limit saved */
    double seconds;
} murk_traced;

/*
 * Prepares a set of lines for a grid with its kappa_t field and a ground (may be NULL), all kept by
 * the caller while the sweep lives. lines are copied.
 */
murk_status murk_sweep_create(murk_context *context, const murk_grid *grid, const float *kappa_t,
                              const murk_ground *ground, const murk_line *lines, int line_count,
                              murk_sweep **out);
void murk_sweep_release(murk_sweep *sweep);

/* Lets lines end where no brick of the region is ahead of them, but for those that go on to the
   ground. Tallies are then of use in the region alone, and net powers are of none. */
void murk_sweep_limit(murk_sweep *sweep, const murk_region *region);

/* Lets sources vary linearly within the zones of some bricks; kept by the caller. */
void murk_sweep_bend(murk_sweep *sweep, const murk_bent *bent);

const char *murk_sweep_kernel(const murk_sweep *sweep);
const murk_traced *murk_sweep_traced(const murk_sweep *sweep);

/* One band of what is carried and what comes of it. */
typedef struct murk_cargo {
    const float *source;    /* B per slot; NULL: none */
    const float *slope;     /* of the bent bricks; NULL: none */
    murk_incoming incoming; /* `uniform` is the same in all bands */
    /* Sum over lines of weight * phi * (I - B), phi = (1 - exp(-x)) / x: for a full set of
       directions G/4 - B; of use in active slots, where there is no extinction too. NULL: not
       wanted. */
    float *tally;
    /* The same, for each bent brick, as the slopes of a linear fit to it. Written if not NULL,
       which is the same in all bands; then `tally` is wanted, too. */
    float *slope_tally;
    /* Power per unit weight and area factor that arrives at each patch beyond what would without
       the medium; NULL: not wanted. Overwritten. */
    double *patch_power;
    double net_power; /* what all lines bring in minus what they carry out [W] */
} murk_cargo;

/*
 * Carries 1 ... MURK_MOST_BANDS bands along all lines; either all bands want tallies or none, and
 * likewise patch powers. power_factor is 4 for diffuse light (pi I over the sphere), 1 for a beam.
 * The sums over lines are in an order that depends on the number of threads: results agree to
 * 1e-6 relative for different numbers, and bitwise for the same. Bricks whose source and lines are
 * below 1e-12 of the brightest source, in each band of its own, are passed over.
 */
murk_status murk_sweep_run(murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int bands,
                           double power_factor);

#endif
