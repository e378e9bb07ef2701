/* SPDX-License-Identifier: Apache-2.0 */
#include "alike.h"

#include <string.h>

static bool same(const void *a, const void *b, size_t count, size_t size)
{
    return !count || !memcmp(a, b, count * size);
}

static bool same_grid(const murk_grid *a, const murk_grid *b)
{
    return a->brick_count == b->brick_count && same(a->voxel, b->voxel, 1, sizeof a->voxel) &&
           same(a->axis, b->axis, 1, sizeof a->axis) &&
           same(a->corner, b->corner, 1, sizeof a->corner) &&
           same(a->brick, b->brick, a->brick_count, sizeof *a->brick) &&
           same(a->mask, b->mask, a->brick_count, sizeof *a->mask);
}

static bool same_patches(const murk_ground *a, const murk_ground *b)
{
    if (!a || !b || a == b)
        return a == b;
    if (a->up != b->up || a->height != b->height || a->horizon != b->horizon)
        return false;
    for (int c = 0; c < 2; c++)
        if (a->interior[c] != b->interior[c] || a->count[c] != b->count[c] ||
            !same(a->edge[c], b->edge[c], (size_t)a->count[c] + 1, sizeof *a->edge[c]))
            return false;
    return true;
}

const char *murk_solutions_differ(const murk_solution *a, const murk_solution *b)
{
    const murk_medium *of_a = a->medium, *of_b = b->medium;
    if (of_a != of_b && (!same_grid(of_a->grid, of_b->grid) || !same_grid(a->grid, b->grid)))
        return "other voxels";
    if (of_a != of_b && !same(of_a->kappa_t, of_b->kappa_t, of_a->grid->brick_count,
                              MURK_BRICK_SLOTS * sizeof(float)))
        return "another extinction";
    return same_patches(a->ground, b->ground) ? NULL : "another ground";
}
