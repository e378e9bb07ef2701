/* SPDX-License-Identifier: Apache-2.0 */
/* The medium's shadow: optical depths between points and the sun. */
#ifndef MURK_RENDER_SHADOW_H
#define MURK_RENDER_SHADOW_H

#include "bins.h"
#include "march.h"

/* Bricks sorted into bins of a plane across the beam. */
typedef struct murk_shadow {
    double towards[3], inverse[3]; /* the sun: grid frame, voxels per metre */
    double across[2][3];           /* bins per voxel along the plane's axes */
    double low[2];                 /* bin coordinates of the first bin's corner */
    murk_bins bins;
} murk_shadow;

/* For light that travels along `travel`, a unit vector in the world. */
murk_status murk_shadow_create(murk_context *context, const murk_grid *grid, const murk_box *box,
                               const double travel[3], murk_shadow *out);
void murk_shadow_clear(murk_shadow *shadow);

/* Optical depth from each point (grid frame, voxels) to the sun; 0 where it is not wanted. */
void murk_shadow_depth(const murk_shadow *shadow, const murk_march *march,
                       const double point[3][MURK_LANES], const bool wanted[MURK_LANES],
                       double depth[MURK_LANES]);

#endif
