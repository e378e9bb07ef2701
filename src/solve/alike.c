/* SPDX-License-Identifier: Apache-2.0 */
#include "alike.h"

#include <string.h>

static bool same_patches(const murk_ground *a, const murk_ground *b)
{
    if (!a || !b || a == b)
        return a == b;
    if (a->up != b->up || a->height != b->height || a->horizon != b->horizon)
        return false;
    for (int c = 0; c < 2; c++)
        if (a->interior[c] != b->interior[c] || a->count[c] != b->count[c] ||
            memcmp(a->edge[c], b->edge[c], ((size_t)a->count[c] + 1) * sizeof *a->edge[c]) != 0)
            return false;
    return true;
}

const char *murk_solutions_differ(const murk_solution *a, const murk_solution *b)
{
    if (!murk_grid_same(a->medium->grid, b->medium->grid) || !murk_grid_same(a->grid, b->grid))
        return "other voxels";
    if (!murk_medium_same_extinction(a->medium, b->medium))
        return "another extinction";
    return same_patches(a->ground, b->ground) ? NULL : "another ground";
}
