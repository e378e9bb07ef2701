/* SPDX-License-Identifier: Apache-2.0 */
/* What lies behind the medium: ground, background picture, sky. */
#ifndef MURK_RENDER_BACKDROP_H
#define MURK_RENDER_BACKDROP_H

#include "shadow.h"

typedef struct murk_backdrop {
    const murk_solution *solution;
    const murk_march *march;
    const murk_image *image; /* in place of the sky, or NULL */
    int channel[3];          /* of the image, for R, G, B */
    double *centre[2];       /* of the ground's columns and rows of patches */
    double sun;              /* on the ground outside the shadow [W/m^2] */
    murk_shadow shadow;      /* where there is sun */
} murk_backdrop;

/* Rays as they end: in the world, and in the picture in [0, 1]. */
typedef struct murk_ends {
    bool wanted[MURK_LANES];             /* whether anything of it will be seen */
    bool ground[MURK_LANES];             /* the ray meets the ground ... */
    double a[MURK_LANES], b[MURK_LANES]; /* there, in the ground's coordinates */
    double point[3][MURK_LANES];         /* and there in the grid frame, in voxels */
    double x[MURK_LANES], y[MURK_LANES];
} murk_ends;

murk_status murk_backdrop_create(murk_context *context, const murk_solution *solution,
                                 const murk_march *march, const murk_image *image,
                                 murk_backdrop *out);
void murk_backdrop_clear(murk_backdrop *backdrop);

/* Radiance [W/m^2/sr] at the ends of rays. Of the ground: its patch's reflectance, the direct sun
   at the point itself, the diffuse light interpolated between patches. */
void murk_backdrop_light(const murk_backdrop *backdrop, const murk_ends *ends,
                         double radiance[3][MURK_LANES]);

#endif
