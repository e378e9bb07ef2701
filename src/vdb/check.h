/* SPDX-License-Identifier: Apache-2.0 */
/* Checks the layout of a VDB file before OpenVDB sees it: damaged lengths and offsets make OpenVDB
   allocate, seek or loop beyond all bounds. */
#ifndef MURK_VDB_CHECK_H
#define MURK_VDB_CHECK_H

#include "source.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { MURK_VDB_NAME = 1024 };

typedef struct murk_vdb_header {
    uint32_t version; /* of the file format */
    bool has_offsets; /* a file; streams do not know where their grids end */
    uint64_t prefix;  /* bytes from the start to the file metadata */
    uint32_t grid_count;
    uint64_t first; /* where the first grid's descriptor starts */
} murk_vdb_header;

/* One grid's descriptor. */
typedef struct murk_vdb_entry {
    char name[MURK_VDB_NAME]; /* unique, as in the file: a record separator before its number */
    char label[MURK_VDB_NAME + 2]; /* that name as users see it: "density[1]" */
    char type[MURK_VDB_NAME];      /* of the tree */
    char parent[MURK_VDB_NAME];    /* unique name of the grid whose tree this one shares, or "" */
    uint64_t start;                /* of the descriptor */
    uint64_t end;                  /* of the grid's data; 0 where it is not known */
} murk_vdb_entry;

/* Checks all that comes before the grids. */
murk_status murk_vdb_check(murk_context *context, const murk_source *source, murk_vdb_header *out);

/* Checks the descriptor that starts at `start` and the grid's own header behind it. */
murk_status murk_vdb_check_entry(murk_context *context, const murk_source *source,
                                 const murk_vdb_header *header, uint64_t start,
                                 murk_vdb_entry *out);

#ifdef __cplusplus
}
#endif
#endif
