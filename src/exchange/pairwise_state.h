/* SPDX-License-Identifier: Apache-2.0 */
/* The stored exchange factors, in two forms: by offset, or zone by zone. */
#ifndef MURK_EXCHANGE_PAIRWISE_STATE_H
#define MURK_EXCHANGE_PAIRWISE_STATE_H

#include "sight.h"

/* Factors of a uniform box by offset, and what is needed to walk through it by offset. Cells are
   numbered (x * n[1] + y) * n[2] + z. */
typedef struct murk_offsets {
    int32_t n[3];
    int32_t z0;          /* z of the first zone, modulo 8: zone numbers run on to z = 7 (mod 8) */
    int reach[3];        /* offsets beyond are outside the window */
    size_t *number;      /* zone number of a cell */
    double *zone;        /* V_mV_k by offset (|dx|, |dy|, dz + n[2] - 1), window weights included */
    /* Patches that are cells of the lattice under the box, V_kS_i by (dx, dy, dz) as above, but on
       the vertical axis by the zone's own coordinate. */
    int up;              /* the vertical axis of the lattice; -1: no such patches */
    double *patch;
    size_t aligned_count;
    size_t *aligned;     /* their numbers */
    int32_t (*cell)[3];  /* their lattice cells; 0 on the vertical axis */
    int64_t *patch_at;   /* number of the patch of a column, or -1: same shape as n with 1 for up */
} murk_offsets;

typedef struct murk_pairwise {
    murk_sight sight;
    int threads;
    bool windowed;
    double window[3];    /* infinite where there is none */
    size_t zones, patches;
    size_t *slot;        /* of each zone */
    int32_t (*cell)[3];  /* of each zone, relative to grid->lo */
    double *weight;      /* 4 kappa V [m^2] */
    double *area;        /* of each patch [m^2] */
    double *sky;         /* each zone's exchange with the sky [m^2] */
    double *horizon;     /* each zone's exchange with the ground beyond all patches [m^2] */
    double *patch_sky;   /* each patch's exchange with the sky [m^2] */
    double *self;        /* V_kV_k, where factors are not by offset */
    float *matrix;       /* zones x zones without the self-factors, or NULL: by offset */
    size_t other_count;
    size_t *other;       /* patches that are not by offset */
    float *other_matrix; /* zones x other_count */
    murk_offsets offsets;
    double *x, *y;       /* zones: radiosities and sums of one application */
    double *px, *py;     /* patches */
} murk_pairwise;

/* Share of a zone or patch that lies in the window of [BG91] eq. (19): d cells away on axis a. */
double murk_window_weight(const murk_pairwise *p, int axis, double d);

/* The part of the medium's index axis a in the window over the ground: all heights count. */
int murk_vertical_axis(const murk_sight *sight);

/* Factors zone by zone: matrix, self, sky, horizon. */
murk_status murk_pairwise_dense(murk_context *context, murk_pairwise *p);

/* Factors by offset, with the rest of the patches in p->other. */
murk_status murk_pairwise_offsets(murk_context *context, murk_pairwise *p);
void murk_offsets_clear(murk_offsets *offsets);

/* Patches p->other[0..count) zone by zone, without the window. */
murk_status murk_pairwise_others(murk_context *context, murk_pairwise *p);
/* Sets what lies outside the window in matrix and other_matrix to 0. */
void murk_pairwise_cut_others(murk_pairwise *p);

/* Sums over the factors by offset; y and py are overwritten, the others of py left alone. */
void murk_offsets_apply(const murk_pairwise *p, const double *x, const double *px, double *y,
                        double *py);
/* One row of them, without the self-factor. */
double murk_offsets_row(const murk_pairwise *p, size_t element, const double *x);

#endif
