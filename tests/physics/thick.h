/* SPDX-License-Identifier: Apache-2.0 */
/* Media of thick voxels, lit in two ways, solved by tolerance and compared with the exact Monte
   Carlo: the radiosity of a medium that is constant in a voxel, but whose light is not. */
#ifndef THICK_H
#define THICK_H

#include "setting.h"

enum thick_shape { THICK_BLOCK, THICK_RANDOM, THICK_CLOUD, THICK_SHAPES };
enum thick_light { THICK_SUN, THICK_THERMAL, THICK_LIGHTS };

extern const char *const THICK_SHAPE_NAMES[THICK_SHAPES];
extern const char *const THICK_LIGHT_NAMES[THICK_LIGHTS];

struct thick_case {
    enum thick_shape shape;
    enum thick_light light;
    double depth; /* optical, of the densest voxel */
    double albedo;
};

/* The medium over a ground of reflectance 0.3, in slanting sun or by its own emission: E = 1, and 5
   in a hot core. */
void thick_make(const struct thick_case *c, struct setting *s);

/* Relative L2 distances to the Monte Carlo, kappa_t-weighted over zones and area-weighted over
   patches. */
struct thick_result {
    struct distance zones, ground;
    double estimate; /* the library's own */
};

/* NULL options: those by default. */
void thick_run(const struct thick_case *c, const murk_solve_options *options, long packets,
               int threads, struct thick_result *out);

#endif
