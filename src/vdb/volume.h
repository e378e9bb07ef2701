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

/* Number of the grid that murk would take for the density, or MURK_NO_GRID. */
int64_t murk_volume_choose(const murk_volume *volume);

/* Number of the readable grid with a unique name, or of the first of several that share a name.
   Fails, naming the grids there are, for an unknown one. */
murk_status murk_volume_find(murk_context *context, const murk_volume *volume, const char *name,
                             size_t *out);

/* Whether name is label, or label without the number in brackets that makes it unique. */
bool murk_volume_same_name(const char *label, const char *name);

#endif
