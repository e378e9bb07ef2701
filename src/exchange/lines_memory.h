/* SPDX-License-Identifier: Apache-2.0 */
/* How much memory lines take on their way, before there are any. */
#ifndef MURK_EXCHANGE_LINES_MEMORY_H
#define MURK_EXCHANGE_LINES_MEMORY_H

#include "grid.h"

typedef struct murk_lines_plan {
    const murk_grid *grid;
    double edge; /* of the zones that lines cross, in voxels of the grid: 1, 2, 4; 0.5: halved */
    int orbits;  /* of MURK_ORBIT directions */
    int bands;   /* at once */
    bool bent;   /* with slopes */
} murk_lines_plan;

/* Bytes of murk_lines and its workers, beside tallies and what belongs to patches: the pages that
   the lines of this grid meet, counted brick by brick, and the slabs. Infinite when memory runs out
   while counting. */
double murk_lines_memory(murk_context *context, const murk_lines_plan *plan);

#endif
