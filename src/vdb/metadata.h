/* SPDX-License-Identifier: Apache-2.0 */
/* The file metadata that go with solutions. */
#ifndef MURK_VDB_METADATA_H
#define MURK_VDB_METADATA_H

#include "band_set.h"
#include "vdb.h"

typedef struct murk_metadata {
    murk_vdb_meta *entry;
    size_t count;
    struct murk_band_facts *facts; /* one a band, behind the entries */
    char *bands;                   /* "R,G,B" */
} murk_metadata;

/* command may be NULL; it must outlive *out, as must the bands. */
murk_status murk_metadata_make(const murk_band_set *set, const char *command, murk_metadata *out);
void murk_metadata_clear(murk_metadata *metadata);

#endif
