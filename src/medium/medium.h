/* SPDX-License-Identifier: Apache-2.0 */
/* The medium inside the library: zones and their coefficients. */
#ifndef MURK_MEDIUM_MEDIUM_H
#define MURK_MEDIUM_MEDIUM_H

#include "grid.h"

/* A field, or one value everywhere. */
typedef struct murk_values {
    float *field; /* on the medium's grid, or NULL */
    float constant;
} murk_values;

static inline float murk_value(const murk_values *values, size_t slot)
{
    return values->field ? values->field[slot] : values->constant;
}

struct murk_medium {
    int references;
    murk_grid *grid;      /* the zones: active voxels with kappa_t > 0 */
    float *kappa_t;       /* field [1/m]; 0 where there is no zone */
    murk_values albedo;   /* of the zones */
    murk_values emission; /* E of the zones [W/m^2] */
    double asymmetry;     /* g of the phase function, in (-1, 1) */
    murk_grid *input;     /* every active voxel of the input, zone or not */
    bool corner;
    uint64_t invalid_voxels;
    double extinction_scale; /* kappa_t per unit of the grid, 0 where there was none */
    char *extinction_grid;   /* unique name of that grid; NULL: made from arrays */
    murk_medium *whole;      /* whose grids, emission and name these are, shared; NULL: its own */
};

/* What a medium is made from: kappa_t carries the topology (all active voxels, values already
   scaled to 1/m); the others may have values NULL for a constant, and may cover other voxels. */
typedef struct murk_medium_parts {
    murk_bricks kappa_t;
    murk_bricks albedo, emission, temperature; /* count 0: the constant holds */
    double albedo_value, emission_value, temperature_value;
    double albedo_scale, emission_scale, temperature_scale; /* multiply the grid values */
    double temperature_offset;                              /* then added to them */
    murk_band band;                                         /* that temperatures radiate in */
    double asymmetry;
    double extinction_scale; /* that kappa_t was scaled by, to be kept for reports */
    bool corner, strict;
    const char *extinction_grid; /* unique name of that grid, copied; NULL: none */
    const char *where;           /* for messages: "plume.vdb, grid density" */
} murk_medium_parts;

/* Builds a medium and consumes the bricks of parts (also on failure). */
murk_status murk_medium_build(murk_context *context, murk_medium_parts *parts, murk_medium **out);

/* Whether two media have the same zones with the same kappa_t. */
bool murk_medium_same_extinction(const murk_medium *a, const murk_medium *b);

/* Shares a medium: one more murk_medium_release() is needed. */
murk_medium *murk_medium_share(const murk_medium *medium);

#endif
