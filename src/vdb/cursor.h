/* SPDX-License-Identifier: Apache-2.0 */
/* A place in the bytes of a VDB that moves forward up to an end. The first trouble sticks; what is
   taken after it is zero. Numbers are little-endian; a string is a uint32 length and its bytes. */
#ifndef MURK_VDB_CURSOR_H
#define MURK_VDB_CURSOR_H

#include "check.h"

#include <string.h>

typedef struct murk_cursor {
    murk_context *context;
    const murk_source *source;
    uint64_t at, end;
    const char *trouble; /* NULL: none */
    murk_status status;  /* of the system, its message is in the context */
} murk_cursor;

static inline void murk_cursor_fail(murk_cursor *c, const char *trouble)
{
    if (!c->trouble)
        c->trouble = trouble;
}

static inline void murk_skip(murk_cursor *c, uint64_t size)
{
    if (size > c->end - c->at)
        murk_cursor_fail(c, "its data end too early");
    if (!c->trouble)
        c->at += size;
}

static inline void murk_take(murk_cursor *c, void *out, size_t size)
{
    uint64_t from = c->at;
    memset(out, 0, size);
    murk_skip(c, size);
    if (c->trouble)
        return;
    c->status = murk_source_read(c->context, c->source, from, out, size);
    if (c->status)
        c->trouble = "it cannot be read";
}

static inline uint64_t murk_take_number(murk_cursor *c, int bytes)
{
    unsigned char raw[8];
    uint64_t value = 0;
    murk_take(c, raw, (size_t)bytes);
    for (int i = 0; i < bytes; i++)
        value |= (uint64_t)raw[i] << 8 * i;
    return value;
}

static inline void murk_take_string(murk_cursor *c, char out[MURK_VDB_NAME])
{
    uint64_t length = murk_take_number(c, 4);
    if (length >= MURK_VDB_NAME)
        murk_cursor_fail(c, "a name is too long");
    if (c->trouble)
        length = 0;
    murk_take(c, out, (size_t)length);
    out[length] = 0;
    for (uint64_t i = 0; i < length; i++)
        if ((unsigned char)out[i] < ' ' && out[i] != MURK_VDB_SEPARATOR)
            murk_cursor_fail(c, "a name holds control characters");
}

#endif
