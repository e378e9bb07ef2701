/* SPDX-License-Identifier: Apache-2.0 */
/* A scene set up for solving: the medium on the solution's grid, and the direct beam there. */
#ifndef MURK_SOLVE_STAGE_H
#define MURK_SOLVE_STAGE_H

#include "bend.h"
#include "solution.h"

typedef struct murk_stage {
    int32_t *map;        /* brick of the solution's grid for each brick of the medium's */
    float *kappa_t;      /* on the solution's grid */
    float *beam;         /* G of the direct beam on the solution's grid [W/m^2] */
    murk_bend bend;      /* where sources vary within zones */
    float *beam_slope;   /* of beam, in bent bricks */
    float *patch_sun;    /* direct irradiance of the patches [W/m^2] */
    double extinguished; /* what the medium takes from the beam [W] */
} murk_stage;

/* Sources that are constant within zones may cost `allowed` of the tolerance's error [1]; others
   get slopes. */
murk_status murk_stage_create(murk_context *context, const murk_solution *solution, double allowed,
                              murk_stage *out);
void murk_stage_clear(murk_stage *stage);

/* Copies a field from the medium's grid to the solution's. */
void murk_stage_spread(const murk_stage *stage, const murk_grid *medium, const float *values,
                       float *out);

/* The first slot on the solution's grid of a brick of the medium's. */
static inline size_t murk_stage_slots(const murk_stage *stage, size_t brick)
{
    return (size_t)stage->map[brick] * MURK_BRICK_SLOTS;
}

/* Radiosity of a zone by the direct beam and emission alone: slot i of the medium's grid, o of the
   solution's. */
static inline float murk_stage_direct(const murk_stage *stage, const murk_medium *medium, size_t i,
                                      size_t o)
{
    float albedo = murk_value(&medium->albedo, i);
    return albedo * stage->beam[o] / 4 + (1 - albedo) * murk_value(&medium->emission, i);
}

/* Slope j of the bent bricks of the same, in slot i; emission has none. */
static inline float murk_stage_direct_slope(const murk_stage *stage, const murk_medium *medium,
                                            size_t i, size_t j)
{
    return murk_value(&medium->albedo, i) * stage->beam_slope[j] / 4;
}

/* The same of a patch. */
static inline float murk_stage_patch(const murk_stage *stage, const murk_ground *ground, size_t i)
{
    return ground->emission[i] + ground->reflectance[i] * stage->patch_sun[i];
}

#endif
