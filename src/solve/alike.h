/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_ALIKE_H
#define MURK_SOLVE_ALIKE_H

#include "solution.h"

/* What keeps two solutions from being found over one exchange operator, in a few words; NULL where
   nothing does: the zones, their extinction, the margin and the patches are the same. */
const char *murk_solutions_differ(const murk_solution *a, const murk_solution *b);

#endif
