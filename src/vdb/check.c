/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Layout of a VDB file:
 *   int64 magic; uint32 format version; uint32 library major, minor; uint8 has offsets;
 *   [formats 220, 221: uint8 compressed]; 36 characters of UUID;
 *   file metadata: uint32 count, then each: string name, string type, uint32 size, bytes;
 *   int32 grid count, then each grid's descriptor: string name, type, parent;
 *   int64 start of the grid, start of its voxel buffers, end; and, right there, the grid:
 *   [format 222 on: uint32 compression], its metadata, string transform type, transform, tree.
 */
#include "check.h"

#include "cursor.h"

#include <inttypes.h>
#include <stdio.h>

enum {
    OLDEST = 220,
    NODE_MASKS = 222,
    NEWEST = 224,
    UUID_LENGTH = 36,
    COMPRESSION_BITS = 7,
    SMALLEST_DESCRIPTOR = 36
};

typedef struct sized {
    const char *type;
    uint32_t size;
} sized;

/* OpenVDB reads metadata of these types by their own size, whatever the file says. */
static const sized metadata_sizes[] = {{"bool", 1},   {"float", 4},  {"double", 8}, {"int32", 4},
                                       {"int64", 8},  {"vec2i", 8},  {"vec2s", 8},  {"vec2d", 16},
                                       {"vec3i", 12}, {"vec3s", 12}, {"vec3d", 24}, {"vec4i", 16},
                                       {"vec4s", 16}, {"vec4d", 32}, {"mat4s", 64}, {"mat4d", 128}};

static const sized transform_sizes[] = {{"AffineMap", 128},
                                        {"UnitaryMap", 128},
                                        {"ScaleMap", 120},
                                        {"UniformScaleMap", 120},
                                        {"TranslationMap", 24},
                                        {"ScaleTranslateMap", 144},
                                        {"UniformScaleTranslateMap", 144}};

static const sized *find_size(const sized *list, size_t count, const char *type)
{
    for (size_t i = 0; i < count; i++)
        if (!strcmp(list[i].type, type))
            return &list[i];
    return NULL;
}

/* Takes a text of the file metadata; one that is too long or not plain counts as none. */
static void take_band(murk_cursor *c, uint64_t size, char out[MURK_VDB_NAME])
{
    memset(out, 0, MURK_VDB_NAME);
    if (size >= MURK_VDB_NAME)
        murk_skip(c, size);
    else
        murk_take(c, out, (size_t)size);
    for (const char *p = out; *p; p++)
        if ((unsigned char)*p < ' ')
            out[0] = 0;
}

/* Takes a double of the file metadata. */
static void take_asymmetry(murk_cursor *c, const char *key, murk_vdb_header *file)
{
    murk_vdb_asymmetry *to = &file->asymmetry[file->asymmetries++];
    uint64_t bits = murk_take_number(c, 8);
    snprintf(to->key, sizeof to->key, "%s", key);
    memcpy(&to->value, &bits, sizeof to->value);
}

static bool is_asymmetry(const char *name, const char *type, const murk_vdb_header *file)
{
    return !strncmp(name, "asymmetry", 9) && strlen(name) < sizeof file->asymmetry->key &&
           !strcmp(type, "double") && file->asymmetries < MURK_VDB_ASYMMETRIES;
}

/* One entry of a metadata map; grid (may be NULL) learns what matters of its own, file (may be
   NULL) what does of that. */
static void skip_metadatum(murk_cursor *c, murk_vdb_entry *grid, murk_vdb_header *file)
{
    char name[MURK_VDB_NAME], type[MURK_VDB_NAME];
    uint64_t start = c->at;
    murk_take_string(c, name);
    murk_take_string(c, type);
    uint64_t size = murk_take_number(c, 4);
    const sized *known =
        find_size(metadata_sizes, sizeof metadata_sizes / sizeof *metadata_sizes, type);
    if (known && known->size != size)
        murk_cursor_fail(c, "metadata of a wrong size");
    bool half = grid && !strcmp(name, "is_saved_as_half_float") && !strcmp(type, "bool");
    if (half)
        grid->is_half = murk_take_number(c, 1) != 0;
    else if (file && !strcmp(name, "band") && !strcmp(type, "string"))
        take_band(c, size, file->band);
    else if (file && is_asymmetry(name, type, file))
        take_asymmetry(c, name, file);
    else
        murk_skip(c, size);
    if (!grid || strcmp(type, "__delayedload"))
        return;
    if (grid->delayed != grid->delayed_end)
        murk_cursor_fail(c, "metadata that are there twice");
    grid->delayed = start;
    grid->delayed_end = c->at;
}

static void skip_metadata(murk_cursor *c, murk_vdb_entry *grid, murk_vdb_header *file)
{
    uint64_t count = murk_take_number(c, 4);
    if (grid)
        grid->metadata_count = (uint32_t)count;
    for (; count > 0 && !c->trouble; count--)
        skip_metadatum(c, grid, file);
}

static void skip_transform(murk_cursor *c, const murk_vdb_header *header)
{
    char type[MURK_VDB_NAME];
    murk_take_string(c, type);
    if (!strcmp(type, "NonlinearFrustumMap")) {
        murk_skip(c, header->version < 221 ? 24 + 16 : 48 + 16);
        murk_take_string(c, type);
    }
    const sized *known =
        find_size(transform_sizes, sizeof transform_sizes / sizeof *transform_sizes, type);
    if (!known)
        murk_cursor_fail(c, "a transform of unknown type");
    else
        murk_skip(c, known->size);
}

static murk_status finish(const murk_cursor *c, const char *part)
{
    if (!c->trouble || c->status)
        return c->status;
    return murk_fail(c->context, MURK_ERROR_INPUT,
                     "%s: truncated or damaged in %s, byte %" PRIu64
                     ": %s; write or copy the file again",
                     c->source->where, part, c->at, c->trouble);
}

static void check_uuid(murk_cursor *c)
{
    char uuid[UUID_LENGTH];
    murk_take(c, uuid, sizeof uuid);
    for (int i = 0; i < UUID_LENGTH; i++) {
        bool dash = i == 8 || i == 13 || i == 18 || i == 23;
        if (!uuid[i] || !strchr(dash ? "-" : "0123456789abcdefABCDEF", uuid[i]))
            murk_cursor_fail(c, "the UUID");
    }
}

murk_status murk_vdb_check(murk_context *context, const murk_source *source, murk_vdb_header *out)
{
    static const unsigned char magic[8] = {' ', 'B', 'D', 'V'};
    murk_cursor c = {.context = context, .source = source, .end = source->size};
    murk_vdb_header header = {0};
    unsigned char start[8];
    murk_take(&c, start, sizeof start);
    if (c.status)
        return c.status;
    if (c.trouble || memcmp(start, magic, sizeof magic))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: %s; give a VDB file", source->where,
                         source->size ? "not a VDB file" : "empty");
    header.version = (uint32_t)murk_take_number(&c, 4);
    if (!c.trouble && (header.version < OLDEST || header.version > NEWEST))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: VDB format %" PRIu32
                         " is not one of %d to %d; save it again with OpenVDB 10",
                         source->where, header.version, OLDEST, NEWEST);
    murk_skip(&c, 8);
    uint64_t flag = murk_take_number(&c, 1);
    header.has_offsets = flag == 1;
    if (header.version < NODE_MASKS)
        header.compression = (uint32_t)murk_take_number(&c, 1);
    if (flag > 1 || header.compression > 1)
        murk_cursor_fail(&c, "a flag that is neither 0 nor 1");
    check_uuid(&c);
    header.prefix = c.at;
    skip_metadata(&c, NULL, &header);
    header.grid_count = (uint32_t)murk_take_number(&c, 4);
    header.first = c.at;
    if (header.grid_count > (c.end - c.at) / SMALLEST_DESCRIPTOR)
        murk_cursor_fail(&c, "more grids than there is room for");
    murk_status status = finish(&c, "the header");
    if (!status)
        *out = header;
    return status;
}

/* "density" + separator + "1" is shown as "density[1]"; what a terminal would obey as "?". */
static void make_label(murk_vdb_entry *entry)
{
    snprintf(entry->label, sizeof entry->label, "%s", entry->name);
    char *separator = strchr(entry->label, MURK_VDB_SEPARATOR);
    if (separator) {
        *separator = '[';
        strcat(separator, "]");
    }
    for (char *p = entry->label; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 0x7f)
            *p = '?';
}

murk_status murk_vdb_check_entry(murk_context *context, const murk_source *source,
                                 const murk_vdb_header *header, uint64_t start, murk_vdb_entry *out)
{
    murk_cursor c = {.context = context, .source = source, .at = start, .end = source->size};
    murk_vdb_entry entry = {.start = start};
    murk_take_string(&c, entry.name);
    make_label(&entry);
    murk_take_string(&c, entry.type);
    murk_take_string(&c, entry.parent);
    uint64_t grid = murk_take_number(&c, 8), blocks = murk_take_number(&c, 8);
    uint64_t end = murk_take_number(&c, 8);
    if (c.trouble)
        return finish(&c, "a grid's descriptor");
    if (header->has_offsets) {
        /* A grid that shares a tree has no voxel buffers. */
        bool shares = entry.parent[0] != 0;
        if (grid != c.at || end < grid || end > source->size ||
            (!shares && (blocks < grid || blocks > end)))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "%s: truncated or damaged: grid \"%.200s\" should end at byte "
                             "%" PRIu64 " of %" PRIu64 "; write or copy the file again",
                             source->where, entry.label, end, source->size);
        entry.end = c.end = end;
    }
    entry.compression = header->compression;
    if (header->version >= NODE_MASKS)
        entry.compression = (uint32_t)murk_take_number(&c, 4);
    if (entry.compression > COMPRESSION_BITS)
        murk_cursor_fail(&c, "an unknown compression");
    entry.metadata = c.at;
    skip_metadata(&c, &entry, NULL);
    skip_transform(&c, header);
    entry.tree = c.at;
    if (entry.parent[0])
        entry.end = c.at;
    murk_status status = finish(&c, "a grid's header");
    if (!status)
        *out = entry;
    return status;
}
