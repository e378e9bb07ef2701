/* SPDX-License-Identifier: Apache-2.0 */
/* The light of lamps on its way to where it is first taken, line of sight by line of sight. */
#ifndef MURK_LIGHT_GATHER_H
#define MURK_LIGHT_GATHER_H

#include "lamps.h"

typedef struct murk_gathered {
    float *zone;   /* G/4 on the grid that was asked for [W/m^2], voxels without extinction too */
    float *patch;  /* H of the patches [W/m^2]; NULL without ground */
    double sent;   /* by the lamps among the zones [W] */
    double kept;   /* of it, what the medium takes [W] */
    double ground; /* what the medium takes of the light of lamps on the ground [W] */
} murk_gathered;

/*
 * [BG91] eqs. (3), (4) and (5) for the factors of the lamps: the mean of G/4 over each active voxel
 * of `to`, which covers the medium's grid, and of H over each patch. Lamps that would cost too many
 * lines of sight are dropped, all of them: lamps->count is then 0 and nothing is gathered.
 */
murk_status murk_gather(murk_context *context, const murk_medium *medium, const murk_ground *ground,
                        const murk_grid *to, murk_lamps *lamps, murk_gathered *out);
void murk_gathered_clear(murk_gathered *gathered);

#endif
