/* SPDX-License-Identifier: Apache-2.0 */
/* The volume inside the library. */
#ifndef MURK_VDB_VOLUME_H
#define MURK_VDB_VOLUME_H

#include "context.h"
#include "vdb.h"

struct murk_volume {
    murk_context *context; /* takes the messages of calls on the volume */
    murk_vdb *vdb;
};

enum { MURK_NO_GRID = -1 };

/* Number of the grid that is meant to be the density, or MURK_NO_GRID. It may be unreadable: a
   damaged density must not make murk take another grid in silence. */
int64_t murk_volume_choose(const murk_volume *volume);

/* Whether a grid holds distances from a surface: a medium only where it is asked for. */
bool murk_volume_is_level_set(const murk_grid_info *info);

/* Number of the readable grid with a unique name, or of the first of several that share a name.
   Fails, naming the grids there are, for an unknown one. */
murk_status murk_volume_find(murk_context *context, const murk_volume *volume, const char *name,
                             size_t *out);

/* "a", "b", ...: the grids there are, readable ones first; among these, unless name is NULL, those
   that are nearest to it. */
void murk_volume_list(const murk_volume *volume, const char *name, char *out, size_t size);

/* Fails where a grid cannot be read as a scalar field. */
murk_status murk_volume_check(murk_context *context, const murk_volume *volume, size_t index);

/* Whether name is label, or label without the number in brackets that makes it unique. */
bool murk_volume_same_name(const char *label, const char *name);

#endif
