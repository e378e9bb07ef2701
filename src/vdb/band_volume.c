/* SPDX-License-Identifier: Apache-2.0 */
#include "band_volume.h"

#include "band_set.h"

#include <stdio.h>
#include <string.h>

#define RADIOSITY "radiosity"

/* What is behind "radiosity_" in a grid's name, or NULL. */
static const char *find_suffix(const char *grid)
{
    static const char prefix[] = RADIOSITY "_";
    size_t length = sizeof prefix - 1;
    return strncmp(grid, prefix, length) ? NULL : grid + length;
}

/* Number of the grid "radiosity", or "radiosity_NAME", or MURK_NO_GRID. */
static int64_t find_radiosity(const murk_volume *volume, const char *name)
{
    for (size_t i = 0; i < murk_vdb_count(volume->vdb); i++) {
        const char *grid = murk_vdb_info(volume->vdb, i)->name, *suffix = find_suffix(grid);
        if (name ? suffix && murk_volume_same_name(suffix, name)
                 : murk_volume_same_name(grid, RADIOSITY))
            return (int64_t)i;
    }
    return MURK_NO_GRID;
}

/* Band of a float "radiosity" as the file metadata have it, or NULL. */
static const char *find_only_band(const murk_volume *volume)
{
    const char *band = murk_vdb_band(volume->vdb);
    return *band && strcmp(band, "single") ? band : NULL;
}

/* Whether a float "radiosity" can be that of a band. */
static bool is_only_band(const murk_volume *volume, const char *name)
{
    const char *band = find_only_band(volume);
    for (size_t i = 0; i < murk_vdb_count(volume->vdb) && !band; i++)
        if (find_suffix(murk_vdb_info(volume->vdb, i)->name))
            return false;
    return !band || !strcmp(band, name);
}

static murk_status fail_unknown(murk_context *context, const murk_volume *volume, const char *name)
{
    const murk_vdb *vdb = volume->vdb;
    const char *band = find_only_band(volume);
    char list[600] = "no radiosity grid";
    size_t used = 0;
    for (size_t i = 0; i < murk_vdb_count(vdb) && used < sizeof list; i++) {
        const char *grid = murk_vdb_info(vdb, i)->name, *of = NULL;
        if (murk_volume_same_name(grid, RADIOSITY))
            of = murk_vdb_components(vdb, i) == 3 ? "R, G, B" : band;
        else if (!find_suffix(grid))
            continue;
        used +=
            (size_t)snprintf(list + used, sizeof list - used, "%s%.100s%s%.100s%s",
                             used ? ", " : "", grid, of ? " (" : "", of ? of : "", of ? ")" : "");
    }
    if (used >= sizeof list)
        memcpy(list + sizeof list - 4, "...", 4);
    return murk_fail(context, MURK_ERROR_INPUT, "%s: no band \"%.100s\"; it has %s",
                     murk_vdb_path(vdb), name, list);
}

murk_status murk_volume_find_band(murk_context *context, const murk_volume *volume,
                                  const char *name, size_t *index, int *component)
{
    int64_t whole = find_radiosity(volume, NULL);
    int64_t own = name ? find_radiosity(volume, name) : MURK_NO_GRID;
    int components = whole == MURK_NO_GRID ? 0 : murk_vdb_components(volume->vdb, (size_t)whole);
    int colour = name ? murk_band_component(name) : -1;
    *component = 0;
    if (!name && components == 3)
        return murk_fail(
            context, MURK_ERROR_INPUT, "%s, grid %s: holds bands R, G, B; name the one to take",
            murk_vdb_path(volume->vdb), murk_vdb_info(volume->vdb, (size_t)whole)->name);
    if (!name)
        return murk_volume_find(context, volume, RADIOSITY, index);
    if (own != MURK_NO_GRID) {
        *index = (size_t)own;
        return murk_volume_check(context, volume, *index);
    }
    if (components == 3 && colour >= 0) {
        *index = (size_t)whole;
        *component = colour;
        return MURK_OK;
    }
    bool only = components != 3 && is_only_band(volume, name);
    bool unusable = !components && colour >= 0;
    if (whole == MURK_NO_GRID || !(only || unusable))
        return fail_unknown(context, volume, name);
    *index = (size_t)whole;
    return murk_volume_check(context, volume, *index);
}
