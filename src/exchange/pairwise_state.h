/* SPDX-License-Identifier: Apache-2.0 */
/* The stored exchange factors, in two forms: by offset, or zone by zone. */
#ifndef MURK_EXCHANGE_PAIRWISE_STATE_H
#define MURK_EXCHANGE_PAIRWISE_STATE_H

#include "sight.h"

/* Factors of a uniform box by offset, and what is needed to walk through it by offset. Cells are
   numbered (x * n[1] + y) * n[2] + z. */
typedef struct murk_offsets {
    int32_t n[3];
    int32_t z0;     /* z of the first zone, modulo 8: zone numbers run on to z = 7 (mod 8) */
    int reach[3];   /* offsets beyond are outside the window */
    size_t *number; /* zone number of a cell */
    double *zone;   /* V_mV_k by offset (|dx|, |dy|, dz + n[2] - 1), window weights included */
    /* Patches that are cells of the lattice under the box, V_kS_i by (dx, dy, dz) as above, but on
       the vertical axis by the zone's own coordinate. */
    int up; /* the vertical axis of the lattice; -1: no such patches */
    double *patch;
    size_t aligned_count;
    size_t *aligned;    /* their numbers */
    int32_t (*cell)[3]; /* their lattice cells; 0 on the vertical axis */
    int64_t *patch_at;  /* patch number of a column, or -1; numbered like cells, with 1 for n[up] */
    int64_t *aligned_at; /* of each patch: where it stands in aligned, or -1 */
    double *in, *out;    /* zones in the order of cells */
} murk_offsets;

typedef struct murk_pairwise {
    murk_sight sight;
    int threads;
    bool windowed;
    double window[3]; /* infinite where there is none */
    size_t zones, patches;
    size_t *slot;       /* of each zone */
    int32_t (*cell)[3]; /* of each zone, relative to grid->lo */
    double *weight;     /* 4 kappa V [m^2] */
    double *area;       /* of each patch [m^2] */
    double *sky;        /* each zone's exchange with the sky [m^2] */
    double *horizon;    /* each zone's exchange with the ground beyond all patches [m^2] */
    double *patch_sky;  /* each patch's exchange with the sky [m^2] */
    double *self;       /* V_kV_k, where factors are not by offset */
    float *matrix;      /* zones x zones without the self-factors, or NULL: by offset */
    size_t other_count;
    size_t *other;       /* patches that are not by offset */
    int64_t *other_at;   /* of each patch: where it stands in other, or -1 */
    float *other_matrix; /* zones x other_count */
    murk_offsets offsets;
    double *x, *y;   /* zones: radiosities and sums of one application */
    double *px, *py; /* patches */
} murk_pairwise;

/* Share of a zone or patch that lies in the window of [BG91] eq. (19): d cells away on axis a. */
double murk_window_weight(const murk_pairwise *p, int axis, double d);

/* Puts a patch into other. */
void murk_pairwise_add_other(murk_pairwise *p, size_t patch);

/* Whether factors are by offset: in a uniform box that the ground does not cut. */
static inline bool murk_pairwise_by_offset(const murk_sight *sight)
{
    return sight->kappa_uniform > 0 && sight->clearance >= 0;
}

/* Factors zone by zone: matrix, self, sky, horizon; other_matrix is there already. */
murk_status murk_pairwise_dense(murk_context *context, murk_pairwise *p);

/* Factors by offset; patches they do not reach are put into other. */
murk_status murk_pairwise_offsets(murk_context *context, murk_pairwise *p);
/* sky and horizon from what the rows lack to 4 kappa V; other_matrix is there already. */
murk_status murk_offsets_escape(murk_context *context, murk_pairwise *p);
/* Cuts the window out of the factors; zones count at all heights over a patch. */
void murk_offsets_window(murk_pairwise *p);
/* How many patches are not by offset. */
size_t murk_offsets_others(const murk_sight *sight);
void murk_offsets_clear(murk_offsets *offsets);

/* y[zone] = sum of V_mV_k x[m], self-factors included. */
void murk_offsets_zones(const murk_pairwise *p, const double *x, double *y);
/* y[zone] += sum of S_iV_k px[i]; py[i] = sum of V_kS_i x[k] for the patches by offset. */
void murk_offsets_patches(const murk_pairwise *p, const double *x, const double *px, double *y,
                          double *py);
/* One row of them: over zones, without the self-factor, and patches; x as in row(). */
double murk_offsets_row(const murk_pairwise *p, size_t element, const double *x);

#endif
