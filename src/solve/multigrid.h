/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_MULTIGRID_H
#define MURK_SOLVE_MULTIGRID_H

#include "diffusion.h"

/* The diffusion matrix C of a medium on cells of 2^3, 4^3, 8^3 ... voxels. */
typedef struct murk_multigrid murk_multigrid;

murk_status murk_multigrid_create(murk_context *context, const murk_medium *medium,
                                  murk_multigrid **out);
void murk_multigrid_release(murk_multigrid *multigrid);

/* Right-hand side and solution on the finest cells: 4^3 a brick, in the order of voxels. */
float *murk_multigrid_source(murk_multigrid *multigrid);
const float *murk_multigrid_solution(const murk_multigrid *multigrid);
/* The brick's neighbours, as in murk_diffusion. */
const int32_t *murk_multigrid_neighbours(const murk_multigrid *multigrid, size_t brick);

/*
 * Solution ~ C^-1 source by one V-cycle with two sweeps of damped Jacobi on each side: a symmetric
 * positive definite operator on the source, the same for any number of threads.
 */
void murk_multigrid_cycle(murk_context *context, murk_multigrid *multigrid);

#endif
