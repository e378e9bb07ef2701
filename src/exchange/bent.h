/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks whose zones have sources that vary linearly within them. */
#ifndef MURK_EXCHANGE_BENT_H
#define MURK_EXCHANGE_BENT_H

#include "grid.h"

/*
 * Slopes are a field over these bricks, 3 * 512 values each: the change of the source from face to
 * face of the voxels along the grid's first axis, along its second, along its third.
 */
typedef struct murk_bent {
    size_t count;   /* of bricks with slopes */
    int32_t *brick; /* of the grid, ascending */
    int32_t *place; /* of each brick of the grid among them, or MURK_NOT_BENT */
} murk_bent;

enum { MURK_NOT_BENT = -1, MURK_BENT_SLOTS = 3 * MURK_BRICK_SLOTS };

/* The grid's slot of a slope. */
static inline size_t murk_bent_slot(const murk_bent *bent, size_t slope)
{
    return (size_t)bent->brick[slope / MURK_BENT_SLOTS] * MURK_BRICK_SLOTS +
           slope % MURK_BRICK_SLOTS;
}

#endif
