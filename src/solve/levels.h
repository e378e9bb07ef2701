/* SPDX-License-Identifier: Apache-2.0 */
/* How each method gets from the scene's light to radiosities within the tolerance. */
#ifndef MURK_SOLVE_LEVELS_H
#define MURK_SOLVE_LEVELS_H

#include "coarse.h"

/* Solving by lines for one size of voxels, bands that share kappa_t together: the coarse solutions
   first, then all the rest. */
typedef struct murk_levels murk_levels;

/* options, solutions and stages are kept by the caller; start may be NULL, or hold NULL. */
murk_status murk_levels_begin(murk_context *context, murk_solution *const solution[],
                              const murk_stage stage[], int count,
                              const murk_solve_options *options, const murk_solution *const start[],
                              murk_levels **out);
void murk_levels_release(murk_levels *levels);

/* The coarse solution of a band. */
const murk_coarse *murk_levels_coarse(const murk_levels *levels, int band);

/* Corrects the coarse solutions by that many directions, for an estimate of their error. */
murk_status murk_levels_probe(murk_levels *levels, int directions, int rays);

/* Fills the solutions and their reports; spatial are the estimated errors of sources within zones.
 */
murk_status murk_levels_finish(murk_levels *levels, const double spatial[]);

/* Each fills the solution and its report; options are complete (no zeros that stand for defaults
   but directions; start is not looked at). MURK_NOT_REACHED where an estimate stays above the
   tolerance. By lines up to MURK_MOST_BANDS solutions on the same zones together. */
murk_status murk_solve_lines(murk_context *context, murk_solution *const solution[], int count,
                             const murk_solve_options *options, const murk_solution *const start[]);
murk_status murk_solve_pairwise(murk_context *context, murk_solution *solution,
                                const murk_stage *stage, const murk_solve_options *options);

#endif
