/* SPDX-License-Identifier: Apache-2.0 */
/* From the solved system to the solution on the input's voxels and their margin. */
#ifndef MURK_SOLVE_FINISH_H
#define MURK_SOLVE_FINISH_H

#include "solution.h"

/* The medium on the solution's grid, and the direct beam there. */
typedef struct murk_stage {
    int32_t *map;        /* brick of the solution's grid for each brick of the medium's */
    float *kappa_t;      /* on the solution's grid */
    float *beam;         /* G of the direct beam on the solution's grid [W/m^2] */
    float *patch_sun;    /* direct irradiance of the patches [W/m^2] */
    double extinguished; /* what the medium takes from the beam [W] */
} murk_stage;

/* Light from outside that has met no zone or patch, as murk_source_build() adds it up [W]. */
typedef struct murk_outside {
    double diffuse;  /* of sky and horizon, extinguished in the zones */
    double absorbed; /* of sky, horizon and beam, absorbed in the zones */
} murk_outside;

/* A solved system to be finished. */
typedef struct murk_solved {
    const float *zone, *patch; /* x; patch NULL without ground */
    const float *source;       /* b in the zones, or NULL: no rebalance, the zones keep x */
    murk_outside outside;      /* used with source */
    int directions, rays;      /* lines of the final application */
} murk_solved;

murk_status murk_stage_create(murk_context *context, const murk_solution *solution,
                              murk_stage *out);
void murk_stage_clear(murk_stage *stage);

/* Copies a field from the medium's grid to the solution's. */
void murk_stage_spread(const murk_stage *stage, const murk_grid *medium, const float *values,
                       float *out);

/*
 * One plain application of the operator on the solution's grid: sets the solution's radiosity in
 * zones and margin to albedo G/4 + (1 - albedo) E, the light of the patches, and the energies of
 * the report. Where the source is given, x is first scaled by the one factor that makes emission
 * and sunlight equal absorption and escape exactly (coarse-mesh rebalance with one cell), which
 * the linearity of the operator allows after the fact.
 */
murk_status murk_finish(murk_context *context, murk_solution *solution, const murk_stage *stage,
                        const murk_solved *solved);

#endif
