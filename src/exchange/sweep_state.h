/* SPDX-License-Identifier: Apache-2.0 */
/* A sweep inside: how lines are shared out, what each thread writes to, and one run of it. */
#ifndef MURK_EXCHANGE_SWEEP_STATE_H
#define MURK_EXCHANGE_SWEEP_STATE_H

#include "slabs.h"
#include "sweep.h"

struct murk_block {
    int first, count; /* lines, ordered by their octants */
    int axis, sign;
};

/* Everything one thread writes to. */
struct murk_worker {
    float *tally[MURK_MOST_BANDS];       /* of the first thread: the cargo's own */
    float *slope_tally[MURK_MOST_BANDS]; /* likewise */
    double *patch_power[MURK_MOST_BANDS];
    double net_power[MURK_MOST_BANDS];
    double dark, beyond; /* crossings passed over */
    float *slab; /* the bricks of a slab, each kappa_t, sources, tallies and those of slopes, in
                    layers */
    murk_plane plane[MURK_BLOCK];
};

struct murk_sweep {
    const murk_grid *grid;
    const float *kappa_t;
    float clear; /* kappa_t of voxels without extinction */
    const murk_ground *ground;
    murk_region region;
    const murk_bent *bent; /* or NULL */
    murk_line *line;
    int line_count;
    struct murk_block *blocks;
    int block_count;
    murk_slabs slabs[3];
    float *brick_kappa;    /* largest kappa_t of each brick */
    float *brick_source;   /* largest source of each brick in each band of a run */
    uint16_t *brick_zones; /* voxels with extinction */
    double zones;
    murk_kernel_fn *kernel;
    const char *kernel_name;
    struct murk_worker *worker;
    int worker_count;
    murk_traced traced;
};

struct murk_run {
    const murk_sweep *sweep;
    const murk_cargo *cargo;
    murk_incoming incoming[MURK_MOST_BANDS];
    int bands;
    bool bent; /* with slopes */
    double power_factor;
    float dark[MURK_MOST_BANDS]; /* light up to this is none */
};

/* Of a brick laid out in a slab: kappa_t, sources and tallies, then slopes and their tallies. */
static inline size_t murk_laid_flat(int bands)
{
    return (size_t)(1 + 2 * bands) * MURK_BRICK_SLOTS;
}

static inline size_t murk_laid_floats(int bands, bool bent)
{
    return murk_laid_flat(bands) + (bent ? 2 * (size_t)bands * MURK_BENT_SLOTS : 0);
}

/* Carries the lines of a block through the whole medium; false when memory runs out. */
bool murk_cross_block(const struct murk_run *run, const struct murk_block *block,
                      struct murk_worker *worker);

#endif
