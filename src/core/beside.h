/* SPDX-License-Identifier: Apache-2.0 */
/* Output that appears whole or not at all: written beside its target, then renamed. */
#ifndef MURK_CORE_BESIDE_H
#define MURK_CORE_BESIDE_H

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct murk_beside {
    const char *where; /* for messages: the path or "standard output" */
    int file;          /* open for writing */
    char *target;      /* NULL: the output goes straight to a pipe, a device or standard output */
    char *temporary;   /* beside it; NULL while the file has no name */
} murk_beside;

/* Fails as murk_beside_open() would, as far as that can be told without making a file. */
murk_status murk_beside_check(murk_context *context, const char *path);

/* Opens the output for a path; "-" is standard output, which must not be a terminal. The path must
   outlive *out. */
murk_status murk_beside_open(murk_context *context, const char *path, murk_beside *out);

/* Writes size bytes. */
murk_status murk_beside_write(murk_context *context, murk_beside *beside, const void *bytes,
                              size_t size);

/* Closes the output and renames it to its target. */
murk_status murk_beside_finish(murk_context *context, murk_beside *beside);

/* Closes and removes what was written; does nothing after murk_beside_finish(). */
void murk_beside_discard(murk_beside *beside);

/* For tests: whether files may be without a name until they are complete; where the file system
   has no such files they never are. */
void murk_beside_allow_nameless(bool allow);

#ifdef __cplusplus
}
#endif
#endif
