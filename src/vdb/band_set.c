/* SPDX-License-Identifier: Apache-2.0 */
#include "band_set.h"

#include <math.h>
#include <string.h>

int murk_band_component(const char *name)
{
    static const char *const colours[] = {"R", "G", "B"};
    for (int c = 0; c < 3; c++)
        if (!strcmp(name, colours[c]))
            return c;
    return -1;
}

const char *murk_band_set_name(const murk_band_set *set, size_t band)
{
    return set->name ? set->name[band] : NULL;
}

/* Whether the values of two bands can be those of one grid. */
static bool share_voxels(const murk_solution *a, const murk_solution *b)
{
    return murk_grid_same(a->grid, b->grid) && murk_grid_same(a->medium->input, b->medium->input);
}

bool murk_band_set_colours(const murk_band_set *set, size_t band[3])
{
    int found = 0;
    for (size_t i = 0; i < set->count; i++) {
        const char *name = murk_band_set_name(set, i);
        int component = name ? murk_band_component(name) : -1;
        if (component < 0)
            continue;
        band[component] = i;
        found++;
    }
    return found == 3 && share_voxels(set->solution[band[0]], set->solution[band[1]]) &&
           share_voxels(set->solution[band[0]], set->solution[band[2]]);
}

bool murk_band_set_one_extinction(const murk_band_set *set)
{
    for (size_t i = 1; i < set->count; i++)
        if (!murk_medium_same_extinction(set->solution[0]->medium, set->solution[i]->medium))
            return false;
    return true;
}

static murk_status check_name(const murk_band_set *set, size_t band, const char *where)
{
    murk_context *context = set->solution[0]->context;
    const char *name = murk_band_set_name(set, band);
    if (!name && set->count == 1)
        return MURK_OK;
    if (!name)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: band %zu of %zu has no name; give each a name", where, band + 1,
                         set->count);
    if (!murk_band_name_valid(name))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: band \"%.100s\": a name has letters, digits, _ and -, %d at most",
                         where, name, MURK_BAND_NAME_MAX);
    for (size_t i = 0; i < band; i++)
        if (!strcmp(set->name[i], name))
            return murk_fail(context, MURK_ERROR_INPUT, "%s: band %s: there are two of that name",
                             where, name);
    return MURK_OK;
}

/* World position of index (0, 0, 0)'s low corner. */
static void find_origin(const murk_grid *grid, double origin[3])
{
    const double lo[3] = {-grid->lo[0] * grid->voxel[0], -grid->lo[1] * grid->voxel[1],
                          -grid->lo[2] * grid->voxel[2]};
    murk_grid_to_world(grid, lo, origin);
}

/* Whether two grids lie on one transform: to a thousandth of a voxel. */
static bool share_transform(const murk_grid *a, const murk_grid *b)
{
    const double least = fmin(fmin(a->voxel[0], a->voxel[1]), a->voxel[2]);
    double from[3], to[3];
    find_origin(a, from);
    find_origin(b, to);
    for (int i = 0; i < 3; i++) {
        if (!(fabs(from[i] - to[i]) <= 1e-3 * least) ||
            !(fabs(a->voxel[i] - b->voxel[i]) <= 1e-6 * least))
            return false;
        for (int c = 0; c < 3; c++)
            if (!(fabs(a->axis[i][c] - b->axis[i][c]) <= 1e-6))
                return false;
    }
    return true;
}

murk_status murk_band_set_check(const murk_band_set *set, const char *where)
{
    const murk_solution *first = set->solution[0];
    for (size_t i = 0; i < set->count; i++) {
        const murk_solution *other = set->solution[i];
        murk_status status = check_name(set, i, where);
        if (status)
            return status;
        if (!share_transform(first->grid, other->grid))
            return murk_fail(first->context, MURK_ERROR_INPUT,
                             "%s: the bands %s and %s are on different transforms; write them to "
                             "files of their own",
                             where, set->name[0], set->name[i]);
    }
    return MURK_OK;
}
