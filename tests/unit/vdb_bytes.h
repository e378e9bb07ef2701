/* SPDX-License-Identifier: Apache-2.0 */
/* The bytes of files to be damaged, and what is said about them. */
#ifndef VDB_BYTES_H
#define VDB_BYTES_H

#include "vdb_files.h"

typedef struct content {
    unsigned char *bytes;
    size_t size;
} content;

static inline content load(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s is not there", path);
    fseek(file, 0, SEEK_END);
    content all = {.size = (size_t)ftell(file)};
    rewind(file);
    all.bytes = malloc(all.size);
    assert_int_equal(fread(all.bytes, 1, all.size, file), all.size);
    fclose(file);
    return all;
}

static inline void save(const char *path, const unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static inline void assert_message(murk_context *context, const char *part)
{
    const char *message = murk_context_message(context);
    if (!strstr(message, part) || strchr(message, '\n'))
        fail_msg("\"%s\" does not name \"%s\" on one line", message, part);
}

#endif
