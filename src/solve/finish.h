/* SPDX-License-Identifier: Apache-2.0 */
/* From the solved system to the solution on the input's voxels and their margin. */
#ifndef MURK_SOLVE_FINISH_H
#define MURK_SOLVE_FINISH_H

#include "solution.h"

/* The medium on the solution's grid, and the direct beam there. */
typedef struct murk_stage {
    int32_t *map;       /* brick of the solution's grid for each brick of the medium's */
    float *kappa_t;     /* on the solution's grid */
    float *beam;        /* G of the direct beam on the solution's grid [W/m^2] */
    float *patch_sun;   /* direct irradiance of the patches [W/m^2] */
    double extinguished; /* what the medium takes from the beam [W] */
} murk_stage;

murk_status murk_stage_create(murk_context *context, const murk_solution *solution,
                              murk_stage *out);
void murk_stage_clear(murk_stage *stage);

/* Fields between the medium's grid and the solution's. */
void murk_stage_spread(const murk_stage *stage, const murk_grid *medium, const float *values,
                       float *out);
void murk_stage_gather(const murk_stage *stage, const murk_grid *medium, const float *values,
                       float *out);

/*
 * One plain application of the operator on the solution's grid, from the radiosities of the zones
 * (on the medium's grid) and patches: sets the solution's radiosity in zones and margin to
 * albedo G/4 + (1 - albedo) E, the light of the patches, and the energies of the report. With keep
 * the zones retain the radiosity given and only the margin and the energies are filled.
 */
murk_status murk_finish(murk_context *context, murk_solution *solution, const murk_stage *stage,
                        const float *zone, const float *patch, int directions, int rays, bool keep);

#endif
