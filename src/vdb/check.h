/* SPDX-License-Identifier: Apache-2.0 */
/* Checks the layout of a VDB before OpenVDB sees it: damaged lengths, counts and offsets make
   OpenVDB allocate, seek or write beyond all bounds. */
#ifndef MURK_VDB_CHECK_H
#define MURK_VDB_CHECK_H

#include "source.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { MURK_VDB_NAME = 1024, MURK_VDB_SEPARATOR = 0x1e };

/* An asymmetry of the file metadata, of all bands or of one. */
typedef struct murk_vdb_asymmetry {
    char key[64]; /* "asymmetry", "asymmetry_LWIR" */
    double value;
} murk_vdb_asymmetry;

enum { MURK_VDB_ASYMMETRIES = 32 };

typedef struct murk_vdb_header {
    uint32_t version;     /* of the file format */
    bool has_offsets;     /* a file; streams do not know where their grids end */
    uint32_t compression; /* of all grids, in formats before 222 */
    uint64_t prefix;      /* bytes from the start to the file metadata */
    uint32_t grid_count;
    uint64_t first;           /* where the first grid's descriptor starts */
    char band[MURK_VDB_NAME]; /* of the file metadata; "": none */
    murk_vdb_asymmetry asymmetry[MURK_VDB_ASYMMETRIES];
    int asymmetries;
} murk_vdb_header;

/* One grid's descriptor, and what comes between it and the grid's tree. */
typedef struct murk_vdb_entry {
    char name[MURK_VDB_NAME];      /* unique, as in the file: a separator before its number */
    char label[MURK_VDB_NAME + 2]; /* that name as users see it: "density[1]" */
    char type[MURK_VDB_NAME];      /* of the tree: "Tree_float_5_4_3_HalfFloat" */
    char parent[MURK_VDB_NAME];    /* unique name of the grid whose tree this one shares, or "" */
    uint64_t start;                /* of the descriptor */
    uint64_t metadata;             /* of the grid's metadata, a count */
    uint32_t metadata_count;
    uint64_t delayed, delayed_end; /* the entry that only helps to load later; equal: none */
    uint64_t tree;
    uint64_t end; /* of the grid; 0 where it is not known */
    uint32_t compression;
    bool is_half; /* as the metadata say, which OpenVDB goes by */
} murk_vdb_entry;

/* Checks all that comes before the grids. */
murk_status murk_vdb_check(murk_context *context, const murk_source *source, murk_vdb_header *out);

/* Checks the descriptor that starts at `start` and the grid's own header behind it. */
murk_status murk_vdb_check_entry(murk_context *context, const murk_source *source,
                                 const murk_vdb_header *header, uint64_t start,
                                 murk_vdb_entry *out);

/* Checks the nodes of a grid's tree, which `bytes` holds from entry->start on. Gives NULL and,
   where it was not known, the end of the grid; or what is wrong. */
const char *murk_vdb_check_tree(const void *bytes, uint64_t size, const murk_vdb_header *header,
                                murk_vdb_entry *entry);

/* Whether murk_vdb_check_tree() knows trees of a type. */
bool murk_vdb_knows_tree(const char *type);

#ifdef __cplusplus
}
#endif
#endif
