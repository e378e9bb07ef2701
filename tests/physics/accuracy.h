/* SPDX-License-Identifier: Apache-2.0 */
/* The tables of ACCURACY.md, in Markdown on standard output. */
#ifndef ACCURACY_H
#define ACCURACY_H

/* Reference solutions: errors by resolution; by directions and lines at one resolution. */
void accuracy_resolution(void);
void accuracy_quadrature(void);
/* Distances to the Monte Carlo: of the zonal model, and of thick voxels to the exact one. */
void accuracy_zonal(void);
void accuracy_thick(void);
/* Of the ground under a cloud that glows, by directions, to pairwise. */
void accuracy_ground(void);

#endif
