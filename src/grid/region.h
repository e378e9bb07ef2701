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
