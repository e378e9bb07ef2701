/* SPDX-License-Identifier: Apache-2.0 */
/* How each method gets from the scene's light to radiosities within the tolerance. */
#ifndef MURK_SOLVE_LEVELS_H
#define MURK_SOLVE_LEVELS_H

#include "stage.h"

/* Solving by lines for one size of voxels: the coarse solution first, then all the rest. */
typedef struct murk_levels murk_levels;

/* options, solution and stage are kept by the caller; start may be NULL. */
murk_status murk_levels_begin(murk_context *context, murk_solution *solution,
                              const murk_stage *stage, const murk_solve_options *options,
                              const murk_solution *start, murk_levels **out);
void murk_levels_release(murk_levels *levels);

struct murk_coarse;
struct murk_coarse *murk_levels_coarse(murk_levels *levels);

/* Corrects the coarse solution by that many directions, for an estimate of their error. */
murk_status murk_levels_probe(murk_levels *levels, int directions, int rays);

/* Fills the solution and its report; spatial is the estimated error of sources within zones. */
murk_status murk_levels_finish(murk_levels *levels, double spatial);

/* Each fills the solution and its report; options are complete (no zeros that stand for defaults
   but directions). MURK_NOT_REACHED where the estimate stays above the tolerance. */
murk_status murk_solve_lines(murk_context *context, murk_solution *solution,
                             const murk_solve_options *options);
murk_status murk_solve_pairwise(murk_context *context, murk_solution *solution,
                                const murk_stage *stage, const murk_solve_options *options);

#endif
