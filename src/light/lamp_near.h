/* SPDX-License-Identifier: Apache-2.0 */
/* The light of a lamp on itself and on the voxels around it. */
#ifndef MURK_LIGHT_LAMP_NEAR_H
#define MURK_LIGHT_LAMP_NEAR_H

#include "factor_near.h"

/* Values of the offsets within reach[] cells, ordered as in murk_near; of the box that these are,
   the middle and its surroundings are near. */
typedef struct murk_lamp_near {
    const murk_medium *medium;
    int reach[3];
    size_t count;
    double *geometry;       /* integral of 1/(pi r^2) over the two cells [m^4]; 0: not near */
    double *light;          /* G/4 for a lamp of radiosity 1 */
    double *length, *taken; /* scratch */
    double left;            /* share of the lamp's power that goes on to other voxels */
} murk_lamp_near;

murk_status murk_lamp_near_create(murk_context *context, const murk_medium *medium,
                                  murk_lamp_near *out);
void murk_lamp_near_clear(murk_lamp_near *near);

/* Index of an offset, or -1 beyond reach. */
int64_t murk_lamp_near_index(const murk_lamp_near *near, const int32_t offset[3]);

/* Sets light and left for the zone at cell[] (from grid->lo). */
void murk_lamp_near_trace(murk_lamp_near *near, const murk_lines_through *lines,
                          const int32_t cell[3]);

#endif
