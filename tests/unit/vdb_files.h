/* SPDX-License-Identifier: Apache-2.0 */
/* Where the VDB tests find and put their files, and a context that counts its warnings. */
#ifndef VDB_FILES_H
#define VDB_FILES_H

/* cmocka.h needs these four before it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "counting_context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *folder_of(const char *variable, const char *otherwise)
{
    const char *folder = getenv(variable);
    return folder ? folder : otherwise;
}

/* One of the shipped volumes. */
static inline const char *shipped(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", folder_of("MURK_VOLUMES_DIR", MURK_VOLUMES_DIR), name);
    return path;
}

/* One of the files of make_vdbs.py and make_typed_vdbs, and the place for what a test writes. */
static inline const char *odd(const char *name)
{
    static char path[8][512];
    static int turn;
    turn = (turn + 1) % 8;
    snprintf(path[turn], sizeof *path, "%s/%s", folder_of("MURK_ODD_DIR", MURK_ODD_DIR), name);
    return path[turn];
}

static inline murk_volume *read_volume(murk_context *context, const char *path)
{
    murk_volume *volume = NULL;
    murk_status status = murk_volume_read(context, path, &volume);
    if (status)
        fail_msg("%s", murk_context_message(context));
    return volume;
}

#endif
