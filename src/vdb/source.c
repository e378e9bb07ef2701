/* SPDX-License-Identifier: Apache-2.0 */
#include "source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *murk_source_name(const char *path)
{
    return strcmp(path, "-") ? path : "standard input";
}

/* Reads a pipe to its end. */
static murk_status slurp(murk_context *context, murk_source *source, int file)
{
    size_t capacity = (size_t)1 << 20, size = 0;
    unsigned char *memory = malloc(capacity);
    for (;;) {
        if (memory && size == capacity) {
            unsigned char *larger = realloc(memory, capacity *= 2);
            if (!larger)
                free(memory);
            memory = larger;
        }
        if (!memory)
            return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory after %zu bytes",
                             source->where, size);
        ssize_t got = read(file, memory + size, capacity - size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            free(memory);
            return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot be read: %s", source->where,
                             strerror(errno));
        }
        if (got == 0)
            break;
        size += (size_t)got;
    }
    source->memory = memory;
    source->size = size;
    return MURK_OK;
}

murk_status murk_source_open(murk_context *context, const char *path, murk_source *out)
{
    bool standard = !strcmp(path, "-");
    murk_source source = {.where = murk_source_name(path), .file = -1};
    if (standard && isatty(STDIN_FILENO))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "standard input: a terminal; pipe a VDB stream into it or name a file");
    int file = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    struct stat info;
    if (file < 0 || fstat(file, &info)) {
        murk_fail(context, MURK_ERROR_INPUT, "%s: cannot be opened: %s", source.where,
                  strerror(errno));
        if (file >= 0 && !standard)
            close(file);
        return MURK_ERROR_INPUT;
    }
    murk_status status = MURK_OK;
    if (S_ISDIR(info.st_mode))
        status = murk_fail(context, MURK_ERROR_INPUT, "%s: a directory; name a VDB file in it",
                           source.where);
    else if (standard || !S_ISREG(info.st_mode))
        status = slurp(context, &source, file);
    else {
        source.file = file;
        source.size = (uint64_t)info.st_size;
    }
    if (source.file < 0 && !standard)
        close(file);
    if (!status)
        *out = source;
    return status;
}

void murk_source_close(murk_source *source)
{
    if (source->file >= 0)
        close(source->file);
    free(source->memory);
    *source = (murk_source){.file = -1};
}

murk_status murk_source_read(murk_context *context, const murk_source *source, uint64_t offset,
                             void *out, size_t size)
{
    if (source->memory) {
        memcpy(out, source->memory + offset, size);
        return MURK_OK;
    }
    for (size_t done = 0; done < size;) {
        ssize_t got = pread(source->file, (char *)out + done, size - done, (off_t)(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot be read: %s", source->where,
                             got ? strerror(errno) : "it became shorter meanwhile");
        done += (size_t)got;
    }
    return MURK_OK;
}
