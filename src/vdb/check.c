/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Layout of a VDB file, all numbers little-endian, a string being a uint32 length and its bytes:
 *   int64 magic; uint32 format version; uint32 library major, minor; uint8 has offsets;
 *   [formats 220, 221: uint8 compression]; 36 characters of UUID;
 *   file metadata: uint32 count, then each: string name, string type, uint32 size, bytes;
 *   int32 grid count, then each grid's descriptor: string name, type, parent;
 *   int64 start of the grid, start of its voxel buffers, end; and, right there, the grid:
 *   [format 222 on: uint32 compression], its metadata, string transform type, transform, tree.
 */
#include "check.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum {
    OLDEST = 220,
    NEWEST = 224,
    UUID_LENGTH = 36,
    COMPRESSION_BITS = 7,
    SMALLEST_DESCRIPTOR = 36,
    SEPARATOR = 0x1e
};

/* A place in the source that reads forward up to an end. The first failure sticks, and reads
   after it give zeros. */
typedef struct cursor {
    murk_context *context;
    const murk_source *source;
    uint64_t at, end;
    const char *part; /* for messages */
    murk_status status;
} cursor;

static void skip(cursor *c, uint64_t size)
{
    if (c->status)
        return;
    if (size > c->end - c->at)
        c->status = murk_fail(c->context, MURK_ERROR_INPUT,
                              "%s: truncated or damaged in %s at byte %" PRIu64
                              "; write or copy the file again",
                              c->source->where, c->part, c->at);
    else
        c->at += size;
}

static void take(cursor *c, void *out, size_t size)
{
    uint64_t from = c->at;
    memset(out, 0, size);
    skip(c, size);
    if (!c->status)
        c->status = murk_source_read(c->context, c->source, from, out, size);
}

static uint64_t take_number(cursor *c, int bytes)
{
    unsigned char raw[8];
    uint64_t value = 0;
    take(c, raw, (size_t)bytes);
    for (int i = 0; i < bytes; i++)
        value |= (uint64_t)raw[i] << 8 * i;
    return value;
}

static murk_status damaged(cursor *c, const char *what)
{
    return c->status = murk_fail(c->context, MURK_ERROR_INPUT,
                                 "%s: damaged in %s: %s; write or copy the file again",
                                 c->source->where, c->part, what);
}

static void take_string(cursor *c, char out[MURK_VDB_NAME])
{
    uint64_t length = take_number(c, 4);
    if (!c->status && length >= MURK_VDB_NAME)
        c->status = murk_fail(c->context, MURK_ERROR_INPUT,
                              "%s: damaged in %s: a name of %" PRIu64
                              " bytes; write or copy the file again",
                              c->source->where, c->part, length);
    if (c->status)
        length = 0;
    take(c, out, (size_t)length);
    out[length] = 0;
    for (const char *p = out; p < out + length && !c->status; p++)
        if ((unsigned char)*p < ' ' && *p != SEPARATOR)
            damaged(c, "a name with control characters");
}

/* "density" + separator + "1" is shown as "density[1]". */
static void make_label(murk_vdb_entry *entry)
{
    char *separator;
    snprintf(entry->label, sizeof entry->label, "%s", entry->name);
    separator = strchr(entry->label, SEPARATOR);
    if (separator) {
        *separator = '[';
        strcat(separator, "]");
    }
    for (char *p = entry->label; *p; p++)
        if (*p == SEPARATOR)
            *p = '?';
}

static void skip_metadata(cursor *c)
{
    for (uint64_t count = take_number(c, 4); count > 0 && !c->status; count--) {
        skip(c, take_number(c, 4));
        skip(c, take_number(c, 4));
        skip(c, take_number(c, 4));
    }
}

murk_status murk_vdb_check(murk_context *context, const murk_source *source, murk_vdb_header *out)
{
    static const unsigned char magic[8] = {' ', 'B', 'D', 'V'};
    cursor c = {context, source, 0, source->size, "the header", MURK_OK};
    murk_vdb_header header = {0};
    unsigned char start[8];
    if (source->size < sizeof start)
        return murk_fail(context, MURK_ERROR_INPUT, "%s: %s; give a VDB file", source->where,
                         source->size ? "too short for a VDB file" : "empty");
    take(&c, start, sizeof start);
    if (!c.status && memcmp(start, magic, sizeof magic))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: not a VDB file", source->where);
    header.version = (uint32_t)take_number(&c, 4);
    if (!c.status && (header.version < OLDEST || header.version > NEWEST))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: VDB format %" PRIu32 " is not one of %d to %d; save it again with "
                         "OpenVDB 10",
                         source->where, header.version, OLDEST, NEWEST);
    skip(&c, 8);
    uint64_t flag = take_number(&c, 1);
    if (!c.status && flag > 1)
        return damaged(&c, "the flag for grid offsets");
    header.has_offsets = flag == 1;
    if (header.version < 222 && take_number(&c, 1) > COMPRESSION_BITS)
        return damaged(&c, "the compression");
    char uuid[UUID_LENGTH];
    take(&c, uuid, sizeof uuid);
    for (int i = 0; i < UUID_LENGTH && !c.status; i++)
        if (!strchr(i == 8 || i == 13 || i == 18 || i == 23 ? "-" : "0123456789abcdefABCDEF",
                    uuid[i]) ||
            !uuid[i])
            return damaged(&c, "the UUID");
    header.prefix = c.at;
    c.part = "the file metadata";
    skip_metadata(&c);
    c.part = "the number of grids";
    header.grid_count = (uint32_t)take_number(&c, 4);
    header.first = c.at;
    if (!c.status && header.grid_count > (c.end - c.at) / SMALLEST_DESCRIPTOR)
        return damaged(&c, "more grids than the file has room for");
    if (!c.status)
        *out = header;
    return c.status;
}

murk_status murk_vdb_check_entry(murk_context *context, const murk_source *source,
                                 const murk_vdb_header *header, uint64_t start, murk_vdb_entry *out)
{
    cursor c = {context, source, start, source->size, "a grid's descriptor", MURK_OK};
    murk_vdb_entry entry = {.start = start};
    char transform[MURK_VDB_NAME];
    take_string(&c, entry.name);
    make_label(&entry);
    take_string(&c, entry.type);
    take_string(&c, entry.parent);
    uint64_t grid = take_number(&c, 8), blocks = take_number(&c, 8), end = take_number(&c, 8);
    if (c.status)
        return c.status;
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
    c.part = "a grid's header";
    if (header->version >= 222 && take_number(&c, 4) > COMPRESSION_BITS)
        return damaged(&c, "the compression");
    skip_metadata(&c);
    take_string(&c, transform);
    if (!c.status)
        *out = entry;
    return c.status;
}
