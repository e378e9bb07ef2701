/* SPDX-License-Identifier: Apache-2.0 */
/* The checks that a VDB has to pass before OpenVDB sees it: header, descriptors, trees. */
#include "check.h"
#include "fuzz.h"

/* A grid whose end is not known ends the file, as for murk_vdb_read(). */
static uint64_t check_grid(murk_context *context, const murk_source *source,
                           const murk_vdb_header *header, uint64_t start)
{
    static murk_vdb_entry entry;
    if (murk_vdb_check_entry(context, source, header, start, &entry))
        return 0;
    if (murk_vdb_knows_tree(entry.type)) {
        const uint64_t end = entry.end ? entry.end : source->size;
        murk_vdb_check_tree(source->memory + start, end - start, header, &entry);
    }
    return entry.end;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static murk_context *context;
    static murk_vdb_header header;
    if (!context && murk_context_create(NULL, &context))
        return 0;
    const murk_source source = {
        .where = "input", .file = -1, .memory = (unsigned char *)bytes, .size = size};
    if (!size || murk_vdb_check(context, &source, &header))
        return 0;
    uint64_t start = header.first;
    for (uint32_t i = 0; i < header.grid_count && start; i++)
        start = check_grid(context, &source, &header, start);
    return 0;
}
