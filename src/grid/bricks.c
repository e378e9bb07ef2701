/* SPDX-License-Identifier: Apache-2.0 */
#include "bricks.h"

#include "context.h"

#include <string.h>

void murk_bricks_place(murk_bricks *bricks, const double voxel_size[3], const double origin[3])
{
    for (int a = 0; a < 3; a++) {
        bricks->index_to_world[5 * a] = voxel_size[a];
        bricks->index_to_world[4 * a + 3] = origin[a] + 0.5 * voxel_size[a];
    }
    bricks->index_to_world[15] = 1;
}

void murk_bricks_clear(murk_bricks *bricks)
{
    murk_free(bricks->brick);
    murk_free(bricks->mask);
    murk_free(bricks->values);
    memset(bricks, 0, sizeof *bricks);
}

int murk_brick_compare(const void *a, const void *b)
{
    const int32_t *p = a, *q = b;
    for (int c = 0; c < 3; c++)
        if (p[c] != q[c])
            return p[c] < q[c] ? -1 : 1;
    return 0;
}
