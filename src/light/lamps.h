/* SPDX-License-Identifier: Apache-2.0 */
/* Lamps: the few emitters that lines of an affordable number of directions would miss. */
#ifndef MURK_LIGHT_LAMPS_H
#define MURK_LIGHT_LAMPS_H

#include "ground.h"
#include "medium.h"

typedef struct murk_lamp {
    size_t index;    /* slot on the medium's grid; of the ground: a patch */
    float radiosity; /* what it sends out by itself: (1 - albedo) E, or E + rho times the sun on
                        it [W/m^2] */
    bool ground;
} murk_lamp;

typedef struct murk_lamps {
    size_t count; /* zones first, then patches */
    size_t zones;
    murk_lamp *lamp;
} murk_lamps;

/* What lights the zones. */
typedef struct murk_lit {
    const murk_medium *medium;
    const murk_ground *ground; /* or NULL */
    const float *patch;        /* radiosity of the patches before any exchange [W/m^2] */
    double sun;                /* what the medium takes from the beam [W] */
    double sky;                /* pi times the radiance of the sky */
} murk_lit;

/* Chooses the lamps of a scene that is to be solved to a tolerance: none where lines do, or where
   lamps would be too many. */
murk_status murk_lamps_choose(murk_context *context, const murk_lit *lit, double tolerance,
                              murk_lamps *out);
void murk_lamps_clear(murk_lamps *lamps);

#endif
