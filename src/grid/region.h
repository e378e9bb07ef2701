/* SPDX-License-Identifier: Apache-2.0 */
/* A box of bricks outside which nothing is asked for. */
#ifndef MURK_GRID_REGION_H
#define MURK_GRID_REGION_H

#include "grid.h"

typedef struct murk_region {
    bool limited;            /* false: everything is asked for, and the rest does not hold */
    int32_t low[3], high[3]; /* brick coordinates, both ends included */
} murk_region;

static inline bool murk_region_has(const murk_region *region, const int32_t brick[3])
{
    for (int a = 0; region->limited && a < 3; a++)
        if (brick[a] < region->low[a] || brick[a] > region->high[a])
            return false;
    return true;
}

/* The smallest that holds two others. */
static inline murk_region murk_region_both(const murk_region *a, const murk_region *b)
{
    murk_region both = {.limited = a->limited && b->limited};
    for (int c = 0; c < 3; c++) {
        both.low[c] = a->low[c] < b->low[c] ? a->low[c] : b->low[c];
        both.high[c] = a->high[c] > b->high[c] ? a->high[c] : b->high[c];
    }
    return both;
}

/* Whether a line that goes the way `up` on each axis can still come from the brick to the region.
 */
static inline bool murk_region_ahead(const murk_region *region, const int32_t brick[3],
                                     const bool up[3])
{
    for (int a = 0; region->limited && a < 3; a++)
        if (up[a] ? brick[a] > region->high[a] : brick[a] < region->low[a])
            return false;
    return true;
}

#endif
