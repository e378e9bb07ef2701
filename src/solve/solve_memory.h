/* SPDX-License-Identifier: Apache-2.0 */
/* What solving takes, before it begins. Who adds an array over zones or patches adds it here: a
   test compares with what is taken. */
#ifndef MURK_SOLVE_SOLVE_MEMORY_H
#define MURK_SOLVE_SOLVE_MEMORY_H

#include "memory.h"
#include "solution.h"

/* The part of the tolerance that sources that are constant within zones may use up. */
#define MURK_BENT_PART 0.3

/* Bytes that solving is going to take beside the empty solutions that are there. */
uint64_t murk_solve_memory_left(murk_context *context, murk_solution *const solution[],
                                size_t count, const murk_solve_options *options);

/* Bytes that the same on voxels of half their size takes. */
uint64_t murk_halved_memory(murk_context *context, murk_solution *const solution[], size_t count,
                            const murk_solve_options *options);

#endif
