/* SPDX-License-Identifier: Apache-2.0 */
/* Random sparse grids for the tests of what walks through them. */
#ifndef SPARSE_H
#define SPARSE_H

#include "check.h"
#include "grid.h"

/* Bricks of a cube of edge^3 about `low`, each there with the probability `bricks` and each of its
   voxels active with the probability `voxels`. */
typedef struct sparse {
    int32_t low[3];
    int edge;
    double bricks, voxels;
    double voxel[3];
} sparse;

static inline murk_grid *sparse_create(murk_context *context, const sparse *s, uint64_t *random)
{
    size_t most = (size_t)s->edge * (size_t)s->edge * (size_t)s->edge;
    murk_bricks bricks = {
        .brick = murk_alloc(most, sizeof *bricks.brick),
        .mask = murk_alloc(most, sizeof *bricks.mask),
        .index_to_world = {[0] = s->voxel[0], [5] = s->voxel[1], [10] = s->voxel[2], [15] = 1}};
    assert_non_null(bricks.brick);
    assert_non_null(bricks.mask);
    for (int n = 0; n < (int)most; n++) {
        if (check_random(random) >= s->bricks)
            continue;
        const int at[3] = {n / s->edge / s->edge, n / s->edge % s->edge, n % s->edge};
        for (int a = 0; a < 3; a++)
            bricks.brick[bricks.count][a] = s->low[a] + at[a];
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (check_random(random) < s->voxels)
                bricks.mask[bricks.count][slot >> 6] |= (uint64_t)1 << (slot & 63);
        bricks.count++;
    }
    murk_grid *grid = NULL;
    murk_status status = murk_grid_create(context, &bricks, true, &grid);
    if (status)
        fail_msg("%s", murk_context_message(context));
    murk_bricks_clear(&bricks);
    return grid;
}

#endif
