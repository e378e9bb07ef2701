/* SPDX-License-Identifier: Apache-2.0 */
/* [BG91] eq. (11) along one ray. */
#ifndef MURK_RENDER_MARCH_H
#define MURK_RENDER_MARCH_H

#include "solution.h"

/* The medium as rays see it. */
typedef struct murk_march {
    const murk_solution *solution;
    float *blocks;
} murk_march;

typedef struct murk_light {
    double path;          /* radiance from the medium [W/m^2/sr] */
    double transmittance; /* tau(L) */
    double
        half_depth; /* where half of the optical depth is passed [m]; INFINITY if there is none */
} murk_light;

/* Optical depths passed along a ray, for half_depth; one per thread. */
typedef struct murk_trace {
    double (*passed)[2]; /* t at the end of a step, optical depth up to there */
    size_t count, capacity;
} murk_trace;

/* Light at the world point eye from direction (unit vector, away from the eye) up to t_max.
   False when memory runs out. */
bool murk_march_ray(const murk_march *march, const double eye[3], const double direction[3],
                    double t_max, murk_trace *trace, murk_light *out);

/* Radiosity of the ground at a point (a, b): its patch's reflectance, the direct sun there with its
   own transmittance, the diffuse light interpolated between patches. */
double murk_march_ground(const murk_march *march, double a, double b);

#endif
