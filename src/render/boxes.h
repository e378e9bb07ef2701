/* SPDX-License-Identifier: Apache-2.0 */
/* The bricks of a medium as rays meet them. */
#ifndef MURK_RENDER_BOXES_H
#define MURK_RENDER_BOXES_H

#include "medium.h"

/* The box around the zones of a brick. */
typedef struct murk_box {
    int32_t low[3];         /* of the brick, in voxels of the grid frame */
    uint8_t from[3], to[3]; /* of the box, in voxels from there; to is exclusive */
    bool thin;              /* on any ray all voxels are below MURK_DEPTH_ANY */
} murk_box;

/* One box per brick of the grid; free with murk_free(), NULL when memory runs out. */
murk_box *murk_boxes_create(murk_context *context, const murk_medium *medium);

/* Corner n (0 to 7) of a box in the grid frame, for the edges of a voxel in the unit wanted. */
static inline void murk_box_corner(const murk_box *box, const double voxel[3], int n, double out[3])
{
    for (int a = 0; a < 3; a++)
        out[a] = voxel[a] * (box->low[a] + (n >> a & 1 ? box->to[a] : box->from[a]));
}

#endif
