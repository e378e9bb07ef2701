/* SPDX-License-Identifier: Apache-2.0 */
/* What of the medium and its light lies before a depth in a pixel: the means over its rays, of
   which samples are made. */
#ifndef MURK_RENDER_LEVELS_H
#define MURK_RENDER_LEVELS_H

#include "curves.h"

/* Up to a depth: transmittance, and light of the medium [W/m^2/sr]. */
typedef struct murk_level {
    double z, tau, path[3];
} murk_level;

/* A pixel of one band, or of three for R, G and B, whose mean transmittance is that of all. */
typedef struct murk_deep_pixel {
    const murk_curves *curves[3];
    int bands, pixel, rays;
    murk_level end; /* behind everything; z is not used */
} murk_deep_pixel;

/* In ascending depth; the first is before the medium, the last behind it. */
typedef struct murk_levels {
    murk_level *level;
    size_t count, capacity;
} murk_levels;

/* Between two levels neither opacity nor light grows by more than this part of the pixel's. */
#define MURK_LEVEL_CHANGE 0.005

/* None where the pixel has no medium. False when memory runs out. */
bool murk_levels_find(const murk_deep_pixel *pixel, murk_levels *out);

#endif
