/* SPDX-License-Identifier: Apache-2.0 */
/* The direct solar beam. */
#ifndef MURK_LIGHT_BEAM_H
#define MURK_LIGHT_BEAM_H

#include "bent.h"
#include "ground.h"
#include "medium.h"

/*
 * Light of the direct beam: incident[slot] = F <tau>, the mean over the voxel of eq. (6) along the
 * beam (exact along each line; `rays` x `rays` lines per voxel face), and patch[i] [W/m^2] the
 * mean irradiance of each patch, F cos(theta) <tau>. Either may be NULL. slope, for bent bricks if
 * there are any, gets the slopes of a linear fit to the light within voxels. *extinguished is what
 * the medium takes from the beam [W]. Without sun all are 0. A sun below the ground's horizon
 * lights nothing.
 */
murk_status murk_beam(murk_context *context, const murk_grid *grid, const float *kappa_t,
                      const murk_ground *ground, const murk_sun *sun, int rays,
                      const murk_bent *bent, float *incident, float *slope, float *patch,
                      double *extinguished);

/* Irradiance of the sun on undisturbed ground [W/m^2]. */
double murk_beam_on_ground(const murk_ground *ground, const murk_sun *sun);

/* The sun's unit vector of travel in the world; false where there is no sun to speak of. */
bool murk_beam_direction(const murk_ground *ground, const murk_sun *sun, double direction[3]);

#endif
