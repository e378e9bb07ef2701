/* SPDX-License-Identifier: Apache-2.0 */
/* A scene set up for solving: the medium on the solution's grid, and there the light that is not
   left to the exchange: the direct beam, and that of the lamps. */
#ifndef MURK_SOLVE_STAGE_H
#define MURK_SOLVE_STAGE_H

#include "bend.h"
#include "lamps.h"
#include "solution.h"

typedef struct murk_stage {
    int32_t *map;        /* brick of the solution's grid for each brick of the medium's */
    float *kappa_t;      /* on the solution's grid */
    murk_bend bend;      /* where sources vary within zones */
    bool borrows;        /* these three from another stage */
    double flat;         /* relative error of sources that are left constant within zones */
    float *beam;         /* G of the direct beam and of the lamps on that grid [W/m^2] */
    float *beam_slope;   /* of the direct beam, in bent bricks */
    float *patch;        /* radiosity of the patches by themselves, sun and lamps [W/m^2] */
    bool halved;         /* voxels are halves of the user's: none are to be put together */
    double extinguished; /* what the medium takes from the beam [W] */

    murk_values emission; /* E of the zones that are no lamps; the medium's, or own_emission */
    float *own_emission;
    murk_lamps lamps;   /* what they send by themselves is in neither beam, patch nor emission */
    float *patch_lamps; /* H of the patches by lamps among the zones; NULL: none [W/m^2] */
    double lamps_sent, lamps_kept; /* by lamps among the zones, and of it by the medium [W] */
    double lamps_ground;           /* what the medium takes from lamps on the ground [W] */
} murk_stage;

/* The stages of solutions on the same zones, which differ in albedo and light: all but the first
   borrow from it. Sources that are constant within zones may cost `allowed` of the tolerance's
   error [1] in each; others get slopes. */
murk_status murk_stage_create(murk_context *context, murk_solution *const solution[], int count,
                              double allowed, murk_stage out[]);
void murk_stage_clear(murk_stage *stage);

/* Finds the lamps for lines, gathers their light, and leaves the lamps themselves out of the direct
   radiosities: what is then solved for is the radiosity without them. */
murk_status murk_stage_light_lamps(murk_context *context, const murk_solution *solution,
                                   murk_stage *stage);

/* Adds what the lamps among the zones send by themselves to a field on the solution's grid, or
   takes it away (sign -1). */
void murk_stage_add_lamps(const murk_stage *stage, float sign, float *radiosity);

/* Adds to the patches of a solution those that are lamps, and to their light that of lamps. */
void murk_stage_add_patch_lamps(const murk_stage *stage, murk_solution *solution);

/* Copies a field from the medium's grid to the solution's. */
void murk_stage_spread(const murk_stage *stage, const murk_grid *medium, const float *values,
                       float *out);

/* The first slot on the solution's grid of a brick of the medium's. */
static inline size_t murk_stage_slots(const murk_stage *stage, size_t brick)
{
    return (size_t)stage->map[brick] * MURK_BRICK_SLOTS;
}

/* Radiosity of a zone by the direct light and emission alone: slot i of the medium's grid, o of the
   solution's. */
static inline float murk_stage_direct(const murk_stage *stage, const murk_medium *medium, size_t i,
                                      size_t o)
{
    float albedo = murk_value(&medium->albedo, i);
    return albedo * stage->beam[o] / 4 + (1 - albedo) * murk_value(&stage->emission, i);
}

/* Slope j of the bent bricks of the same, in slot i; emission has none, and lamps' light none that
   counts. */
static inline float murk_stage_direct_slope(const murk_stage *stage, const murk_medium *medium,
                                            size_t i, size_t j)
{
    return murk_value(&medium->albedo, i) * stage->beam_slope[j] / 4;
}

#endif
