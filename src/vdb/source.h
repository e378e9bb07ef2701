/* SPDX-License-Identifier: Apache-2.0 */
/* The bytes of a VDB: a file that is read where needed, or a stream held in memory. */
#ifndef MURK_VDB_SOURCE_H
#define MURK_VDB_SOURCE_H

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct murk_source {
    const char *where;     /* for messages: the path or "standard input" */
    int file;              /* -1: the bytes are in memory */
    unsigned char *memory; /* NULL for a file */
    uint64_t size;
} murk_source;

/* How a path is called in messages. */
const char *murk_source_name(const char *path);

/* Opens a regular file, or reads a pipe or standard input ("-") to its end. The path must outlive
   the source. */
murk_status murk_source_open(murk_context *context, const char *path, murk_source *out);
void murk_source_close(murk_source *source);

/* Copies bytes [offset, offset + size), which the caller knows to exist. */
murk_status murk_source_read(murk_context *context, const murk_source *source, uint64_t offset,
                             void *out, size_t size);

#ifdef __cplusplus
}
#endif
#endif
