/* SPDX-License-Identifier: Apache-2.0 */
/* Directions over the sphere with the symmetry of the voxel lattice. */
#ifndef MURK_EXCHANGE_QUADRATURE_H
#define MURK_EXCHANGE_QUADRATURE_H

#include "context.h"

enum { MURK_ORBIT = 48 };

/*
 * Every base point stands with its 48 images under reflections and exchanges of the axes, so a
 * mirrored or turned scene has the mirrored or turned solution, -Omega is in the set with Omega,
 * and all polynomials up to degree 3 are integrated exactly with any weights. The weights are the
 * closest to equal ones that also integrate |x| (the flux through a plane) and the first
 * invariants of degree 4, 6, 8, ... exactly, as many as the points can carry.
 */
typedef struct murk_quadrature {
    int count;              /* a multiple of MURK_ORBIT; images of a base point stand together */
    double (*direction)[3]; /* unit vectors */
    double *weight;         /* > 0, sum 1 */
} murk_quadrature;

murk_status murk_quadrature_create(murk_context *context, int orbits, murk_quadrature *out);
void murk_quadrature_clear(murk_quadrature *quadrature);

#endif
