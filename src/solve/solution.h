/* SPDX-License-Identifier: Apache-2.0 */
/* A solution inside the library. */
#ifndef MURK_SOLVE_SOLUTION_H
#define MURK_SOLVE_SOLUTION_H

#include "ground.h"
#include "medium.h"

struct murk_solution {
    murk_context *context;     /* takes the messages of calls on the solution */
    const murk_medium *medium; /* shared */
    const murk_ground *ground; /* shared, or NULL */
    murk_sun sun;
    double sky_radiance;
    murk_grid *grid;      /* the input's active voxels and two beyond them */
    float *radiosity;     /* B on grid [W/m^2] */
    float *patch;         /* Bs [W/m^2], NULL without ground */
    float *patch_diffuse; /* H at the patches without the direct beam [W/m^2] */
    double horizon;       /* radiosity of the ground beyond all patches */
    murk_report report;
};

/* An empty solution for a scene: grid dilated, arrays zeroed, scene shared. The voxels of the
   scene's medium are those of the user's, halved so many times; the margin is the user's. */
murk_status murk_solution_create(murk_context *context, const murk_scene *scene, int halvings,
                                 murk_solution **out);

/* Fills the ground's light from solution->radiosity by one application of the operator. */
murk_status murk_solution_light_ground(murk_context *context, murk_solution *solution);

#endif
