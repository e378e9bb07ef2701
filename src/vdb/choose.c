/* SPDX-License-Identifier: Apache-2.0 */
/* Which grid of a volume is the density. */
#include "volume.h"

#include <string.h>
#include <strings.h>

/* Whether text holds word, upper and lower case alike. */
static bool holds(const char *text, const char *word)
{
    size_t length = strlen(word);
    for (; *text; text++)
        if (!strncasecmp(text, word, length))
            return true;
    return false;
}

/* Grids that are no densities, whatever else they are called. */
static bool is_other(const char *name)
{
    static const char *const others[] = {"radiosity", "albedo", "emission", "temperature",
                                         "heat",      "shadow", "fuel",     "react"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (holds(name, others[i]))
            return true;
    return false;
}

/* How well a name fits: 0 is best, -1 does not. */
static int rank_name(const char *name)
{
    static const char *const words[] = {"density", "smoke", "fog", "cloud", "flames", "flame"};
    if (murk_volume_same_name(name, "density"))
        return 0;
    if (is_other(name) && !holds(name, "density"))
        return -1;
    for (int i = 0; i < (int)(sizeof words / sizeof *words); i++)
        if (holds(name, words[i]))
            return i + 1;
    return -1;
}

bool murk_volume_is_level_set(const murk_grid_info *info)
{
    return !strcmp(info->grid_class, "level set");
}

/* Whether a grid may be taken without being asked for: masks, counts and surfaces are not. */
static bool is_field(const murk_grid_info *info)
{
    return !murk_volume_is_level_set(info) &&
           (!strcmp(info->type, "float") || !strcmp(info->type, "half") ||
            !strcmp(info->type, "double"));
}

int64_t murk_volume_choose(const murk_volume *volume)
{
    const murk_vdb *vdb = volume->vdb;
    int64_t best = MURK_NO_GRID, only = MURK_NO_GRID;
    int best_rank = 0, best_worth = 0, readable = 0;
    for (size_t i = 0; i < murk_vdb_count(vdb); i++) {
        const murk_grid_info *info = murk_vdb_info(vdb, i);
        if (!is_field(info))
            continue;
        if (info->readable && !is_other(info->name)) {
            readable++;
            only = (int64_t)i;
        }
        int rank = rank_name(info->name);
        int worth = info->readable + (info->nonzero_voxels > info->invalid_voxels);
        bool better = rank < best_rank || (rank == best_rank && worth > best_worth);
        if (rank < 0 || (best != MURK_NO_GRID && !better))
            continue;
        best = (int64_t)i;
        best_rank = rank;
        best_worth = worth;
    }
    return best == MURK_NO_GRID && readable == 1 ? only : best;
}
