/* SPDX-License-Identifier: Apache-2.0 */
/* Solutions of media that scatter forward, and of the reduced ones that are solved in their place
   (medium/reduce.h). Both have one G, and the albedo G/4 + (1 - albedo) E of their own. */
#ifndef MURK_SOLVE_SIMILARITY_H
#define MURK_SOLVE_SIMILARITY_H

#include "reduce.h"
#include "solution.h"

/* The same solution in the reduced medium. It owns its medium and radiosity; all else is borrowed.
 */
murk_status murk_similarity_reduce(murk_context *context, const murk_solution *solution,
                                   murk_solution *out);
void murk_similarity_clear(murk_solution *reduced);

/* Turns a solution in the reduced medium into that of `medium` itself, which it shares. */
void murk_similarity_restore(murk_solution *solution, const murk_medium *medium);

#endif
