/* SPDX-License-Identifier: Apache-2.0 */
#include "volume.h"

#include "nearest.h"

#include <stdio.h>
#include <string.h>

/* Whether nothing of a grid could be read; one of a type that is no medium could. */
static bool is_skipped(const murk_grid_info *info)
{
    return !info->readable && !(info->voxel_size[0] > 0);
}

/* Tells what a file holds beside, in one line; for the frames of a sequence once. */
static void warn_skipped(murk_context *context, const murk_vdb *vdb)
{
    char list[sizeof context->skipped] = "";
    size_t used = 0;
    for (size_t i = 0; i < murk_vdb_count(vdb) && used < sizeof list; i++) {
        const murk_grid_info *info = murk_vdb_info(vdb, i);
        if (is_skipped(info))
            used += (size_t)snprintf(list + used, sizeof list - used, "%sgrid %.100s: %.250s",
                                     used ? "; " : "", info->name, info->unreadable);
    }
    if (used >= sizeof list)
        strcpy(list + sizeof list - 4, "...");
    if (!used || !strcmp(list, context->skipped))
        return;
    murk_warn(context, "%s: skipped what cannot be read: %s", murk_vdb_path(vdb), list);
    strcpy(context->skipped, list);
}

murk_status murk_volume_read(murk_context *context, const char *path, murk_volume **out)
{
    murk_volume *volume = murk_alloc(1, sizeof *volume);
    if (!volume)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    volume->context = context;
    murk_status status = murk_vdb_read(context, path, &volume->vdb);
    if (status) {
        murk_free(volume);
        return status;
    }
    warn_skipped(context, volume->vdb);
    *out = volume;
    return MURK_OK;
}

void murk_volume_release(murk_volume *volume)
{
    if (!volume)
        return;
    murk_vdb_release(volume->vdb);
    murk_free(volume);
}

size_t murk_volume_grid_count(const murk_volume *volume)
{
    return murk_vdb_count(volume->vdb);
}

murk_status murk_volume_grid_info(const murk_volume *volume, size_t index, murk_grid_info *out)
{
    size_t count = murk_vdb_count(volume->vdb);
    if (index >= count)
        return murk_fail(volume->context, MURK_ERROR_INPUT, "%s: no grid number %zu; it has %zu",
                         murk_vdb_path(volume->vdb), index, count);
    *out = *murk_vdb_info(volume->vdb, index);
    return MURK_OK;
}

const char *murk_volume_density(const murk_volume *volume)
{
    int64_t index = murk_volume_choose(volume);
    if (index == MURK_NO_GRID)
        return NULL;
    const murk_grid_info *info = murk_vdb_info(volume->vdb, (size_t)index);
    return info->readable ? info->name : NULL;
}

bool murk_volume_same_name(const char *label, const char *name)
{
    size_t length = strlen(name);
    if (strncmp(label, name, length))
        return false;
    const char *rest = label + length;
    if (!*rest)
        return true;
    size_t digits = *rest == '[' ? strspn(rest + 1, "0123456789") : 0;
    return digits && !strcmp(rest + 1 + digits, "]");
}

/* Adds a grid's name to a list of `used` characters. */
static size_t list_name(const murk_grid_info *info, char *out, size_t size, size_t used)
{
    const char *remark = !info->readable                  ? " (unreadable)"
                         : murk_volume_is_level_set(info) ? " (a level set: its inside)"
                                                          : "";
    if (used >= size)
        return used;
    return used + (size_t)snprintf(out + used, size - used, "%s\"%.100s\"%s", used ? ", " : "",
                                   info->name, remark);
}

void murk_volume_list(const murk_volume *volume, const char *name, char *out, size_t size)
{
    const murk_vdb *vdb = volume->vdb;
    size_t used = 0;
    out[0] = 0;
    for (int readable = 1; readable >= 0; readable--)
        for (int distance = 0; distance <= (name ? MURK_EDIT_DISTANCE_MAX : 0); distance++)
            for (size_t i = 0; i < murk_vdb_count(vdb); i++) {
                const murk_grid_info *info = murk_vdb_info(vdb, i);
                if (info->readable == (bool)readable &&
                    (!name || murk_edit_distance(name, info->name) == distance))
                    used = list_name(info, out, size, used);
            }
    if (used >= size)
        memcpy(out + size - 4, "...", 4);
}

murk_status murk_volume_check(murk_context *context, const murk_volume *volume, size_t index)
{
    const murk_grid_info *info = murk_vdb_info(volume->vdb, index);
    if (info->readable)
        return MURK_OK;
    return murk_fail(context, MURK_ERROR_INPUT, "%s, grid %s: cannot be used: %s",
                     murk_vdb_path(volume->vdb), info->name, info->unreadable);
}

murk_status murk_volume_find(murk_context *context, const murk_volume *volume, const char *name,
                             size_t *out)
{
    const murk_vdb *vdb = volume->vdb;
    size_t count = murk_vdb_count(vdb), found = count;
    for (size_t i = 0; i < count && found == count; i++)
        if (!strcmp(murk_vdb_info(vdb, i)->name, name))
            found = i;
    for (size_t i = 0; i < count && found == count; i++)
        if (murk_volume_same_name(murk_vdb_info(vdb, i)->name, name))
            found = i;
    if (found == count) {
        char names[600];
        murk_volume_list(volume, name, names, sizeof names);
        if (!count)
            return murk_fail(context, MURK_ERROR_INPUT, "%s: no grid \"%.100s\"; it has no grids",
                             murk_vdb_path(vdb), name);
        return murk_fail(context, MURK_ERROR_INPUT, "%s: no grid \"%.100s\"; there are %s",
                         murk_vdb_path(vdb), name, names);
    }
    murk_status status = murk_volume_check(context, volume, found);
    if (!status)
        *out = found;
    return status;
}
