/* SPDX-License-Identifier: Apache-2.0 */
/* Media with reference solutions of other programs (data/README.md) as scenes of any resolution,
   and the error of a solution. */
#ifndef REFERENCES_H
#define REFERENCES_H

#include "check.h"

/* Relative to the reference. */
struct reference_error {
    double zones;  /* kappa_t-weighted L2 norm */
    double most;   /* of a zone, or of a cell of zones */
    double ground; /* area-weighted L2 norm; NaN where there is none */
};

/* A sphere of radius 1 m that emits (1 - albedo) E = 1: homogeneous, or with kappa_t = kappa0
   (1 - r). `column` of `file` has B. */
struct reference_sphere {
    const char *file, *column;
    double kappa_t, albedo;
    bool radial;
};

/* A plane-parallel slab of optical thickness T and albedo alpha over a ground of reflectance rho,
   in sunlight of cosine mu. It is `width` optical depths wide. */
struct reference_slab {
    double T, alpha, mu, rho, width;
};

/* A cube of 1 m, kappa_t = a (1 - 2|x|) (1 - 2|y|) (1 - 2|z|) + b, E = 1. */
struct reference_cube {
    double a, b, omega;
};

/* Each opens a world of `edge` voxels along an edge of the box around the medium (layers of the
   slab); the cube and the box take multiples or divisors of 20 and multiples of 10. */
void reference_sphere_open(const struct reference_sphere *c, int edge, int threads,
                           struct world *w);
void reference_slab_open(const struct reference_slab *c, int edge, int threads, struct world *w);
void reference_cube_open(const struct reference_cube *c, int edge, int threads, struct world *w);
/* [BG91] section 5, figure 1. */
void reference_box_open(int edge, int threads, struct world *w);

/* Against the mean of the reference over each zone whose middle is within a radius. */
struct reference_error reference_sphere_error(const struct reference_sphere *c, double within,
                                              const struct world *w);
/* In the middle column, over 10 layers. */
struct reference_error reference_slab_error(const struct reference_slab *c, const struct world *w);
/* Over the cells of 20^3, or the zones where these are larger. */
struct reference_error reference_cube_error(const struct reference_cube *c, const struct world *w);
/* Over the cells and patches of figure 1. */
struct reference_error reference_box_error(const struct world *w);

/* Means of the reference over the zones of edge^3, edge a divisor of 20. */
void reference_cube_means(const struct reference_cube *c, int edge, double *out);

/* The cubes that there are means for: `count` at most are stored, their number is returned. */
int reference_cube_list(struct reference_cube *out, int count);

#endif
