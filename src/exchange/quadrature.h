/* SPDX-License-Identifier: Apache-2.0 */
/* Directions over the sphere with the symmetry of the voxel lattice. */
#ifndef MURK_EXCHANGE_QUADRATURE_H
#define MURK_EXCHANGE_QUADRATURE_H

#include "context.h"

enum { MURK_ORBIT = 48 };

/*
 * Every base point stands with its 48 images under reflections and exchanges of the axes, so a
 * turned scene has the turned solution, -Omega is in the set with Omega,
 * and all polynomials up to degree 3 are integrated exactly with any weights. The weights are the
 * closest to equal ones that also integrate |x| (the flux through a plane) and the first
 * invariants of degree 4, 6, 8, ... exactly, as many as the points can carry.
 */
typedef struct murk_quadrature {
    int count;              /* a multiple of MURK_ORBIT; images of a base point stand together */
    double (*direction)[3]; /* unit vectors */
    double *weight;         /* > 0, sum 1 */
    /* Where a line of each direction passes, as a displacement from the middle of a voxel in
       voxels, so that the directions together sample the voxels evenly. It turns with the direction
       under rotations of the lattice, and is the same for Omega and -Omega. (Under reflections
       alone it is not: a mirrored scene has the mirrored solution within the angular error.) */
    double (*shift)[3];
} murk_quadrature;

/* set 1 has the directions of set 0 with other lines. Of a single base point those of set 0 pass
   through the middles of voxels, those of set 1 where the squares of the distances from the middle
   have the mean that they have in a voxel. */
murk_status murk_quadrature_create(murk_context *context, int orbits, int set,
                                   murk_quadrature *out);
void murk_quadrature_clear(murk_quadrature *quadrature);

#endif
