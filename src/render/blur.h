/* SPDX-License-Identifier: Apache-2.0 */
/* The ground out of focus: what light that is scattered by small angles shows of it. */
#ifndef MURK_RENDER_BLUR_H
#define MURK_RENDER_BLUR_H

#include "solution.h"

/* Sums of the patches' radiosities, by which means over rectangles take no time. */
typedef struct murk_blur {
    const murk_ground *ground;
    double beyond; /* radiosity where there are no patches [W/m^2] */
    double *sum;   /* of radiosity times area below each pair of edges, rows of count[0] + 1 [W] */
} murk_blur;

murk_status murk_blur_create(murk_context *context, const murk_solution *solution, murk_blur *out);
void murk_blur_clear(murk_blur *blur);

/* Mean radiosity over the square of half the side `reach` > 0 [m] about (a, b), in the ground's
   coordinates. */
double murk_blur_mean(const murk_blur *blur, double a, double b, double reach);

#endif
