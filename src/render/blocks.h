/* SPDX-License-Identifier: Apache-2.0 */
/* Radiosity laid out for trilinear interpolation without a look-up across bricks. */
#ifndef MURK_RENDER_BLOCKS_H
#define MURK_RENDER_BLOCKS_H

#include "solution.h"

/* A brick of zones with one voxel around it. */
enum { MURK_BLOCK_EDGE = 10, MURK_BLOCK_SLOTS = 1000 };

/* One block per brick of the medium's grid; free with murk_free(), NULL when memory runs out. */
float *murk_blocks_create(murk_context *context, const murk_solution *solution);

/* B at a point of the brick, in voxels from its low corner, each in [0, 8]. */
static inline double murk_block_sample(const float *block, const double point[3])
{
    int base[3];
    double f[3];
    for (int a = 0; a < 3; a++) {
        double x = point[a] + 0.5; /* voxel centres are at whole numbers, the first one outside */
        x = x < 0 ? 0 : x > 8.9999 ? 8.9999 : x;
        base[a] = (int)x;
        f[a] = x - base[a];
    }
    const float *p = block + (base[0] * MURK_BLOCK_EDGE + base[1]) * MURK_BLOCK_EDGE + base[2];
    double x[2];
    for (int i = 0; i < 2; i++, p += MURK_BLOCK_EDGE * MURK_BLOCK_EDGE) {
        double near = p[0] + f[2] * (p[1] - p[0]);
        const float *q = p + MURK_BLOCK_EDGE;
        double far = q[0] + f[2] * (q[1] - q[0]);
        x[i] = near + f[1] * (far - near);
    }
    return x[0] + f[0] * (x[1] - x[0]);
}

#endif
