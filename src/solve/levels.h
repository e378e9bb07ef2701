/* SPDX-License-Identifier: Apache-2.0 */
/* How each method gets from the scene's light to radiosities within the tolerance. */
#ifndef MURK_SOLVE_LEVELS_H
#define MURK_SOLVE_LEVELS_H

#include "stage.h"

/* Each fills the solution and its report; options are complete (no zeros that stand for defaults
   but directions). MURK_NOT_REACHED where the estimate stays above the tolerance. */
murk_status murk_solve_lines(murk_context *context, murk_solution *solution,
                             const murk_stage *stage, const murk_solve_options *options);
murk_status murk_solve_pairwise(murk_context *context, murk_solution *solution,
                                const murk_stage *stage, const murk_solve_options *options);

#endif
