/* SPDX-License-Identifier: Apache-2.0 */
#include "beside.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A new file in the target's folder, with the permissions that any new file gets. */
static int create_beside(const char *target, char **temporary)
{
    static const char format[] = "%.*s.%s.%ld-%d.tmp";
    const char *slash = strrchr(target, '/');
    const char *name = slash ? slash + 1 : target;
    size_t size = strlen(target) + sizeof format + 40;
    char *path = malloc(size);
    int file = -1;
    errno = ENOMEM;
    for (int n = 0; path && n < 1000; n++) {
        snprintf(path, size, format, (int)(name - target), target, name, (long)getpid(), n);
        file = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST)
            break;
    }
    if (file < 0)
        free(path);
    else
        *temporary = path;
    return file;
}

murk_status murk_beside_open(murk_context *context, const char *path, murk_beside *out)
{
    murk_beside beside = {.where = path, .file = -1};
    struct stat info;
    if (!strcmp(path, "-")) {
        beside.where = "standard output";
        if (isatty(STDOUT_FILENO))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "standard output: a terminal cannot take a VDB; redirect it to a file "
                             "or a pipe");
        beside.file = dup(STDOUT_FILENO);
    } else if (!*path) {
        return murk_fail(context, MURK_ERROR_INPUT, "the output has an empty name; name a file");
    } else if (stat(path, &info)) {
        beside.target = strdup(path);
    } else if (S_ISDIR(info.st_mode)) {
        return murk_fail(context, MURK_ERROR_INPUT, "%s: a directory; name a file in it", path);
    } else if (S_ISREG(info.st_mode)) {
        beside.target = realpath(path, NULL); /* a link stays, the file behind it is replaced */
    } else {
        beside.file = open(path, O_WRONLY | O_CLOEXEC);
    }
    if (beside.target)
        beside.file = create_beside(beside.target, &beside.temporary);
    if (beside.file < 0) {
        murk_fail(context, MURK_ERROR_IO, "%s: cannot be written: %s", beside.where,
                  strerror(errno));
        free(beside.target);
        return MURK_ERROR_IO;
    }
    *out = beside;
    return MURK_OK;
}

murk_status murk_beside_check(murk_context *context, const char *path)
{
    struct stat info;
    const char *slash = strrchr(path, '/');
    char *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    murk_status status = MURK_OK;
    if (!folder)
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    else if (!stat(path, &info) && S_ISDIR(info.st_mode))
        status = murk_fail(context, MURK_ERROR_INPUT, "%s: a directory; name a file in it", path);
    else if (stat(folder, &info) || access(folder, W_OK | X_OK))
        status = murk_fail(context, MURK_ERROR_IO, "%s: cannot be written: folder %s: %s", path,
                           folder, strerror(errno));
    free(folder);
    return status;
}

murk_status murk_beside_write(murk_context *context, murk_beside *beside, const void *bytes,
                              size_t size)
{
    const char *next = bytes;
    while (size > 0) {
        ssize_t written = write(beside->file, next, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return murk_fail(context, MURK_ERROR_IO, "%s: cannot be written: %s", beside->where,
                             strerror(errno));
        next += written;
        size -= (size_t)written;
    }
    return MURK_OK;
}

static void forget(murk_beside *beside)
{
    free(beside->target);
    free(beside->temporary);
    *beside = (murk_beside){.file = -1};
}

murk_status murk_beside_finish(murk_context *context, murk_beside *beside)
{
    int failed = close(beside->file);
    beside->file = -1;
    if (!failed && beside->temporary)
        failed = rename(beside->temporary, beside->target);
    if (failed) {
        murk_fail(context, MURK_ERROR_IO, "%s: cannot be written: %s", beside->where,
                  strerror(errno));
        murk_beside_discard(beside);
        return MURK_ERROR_IO;
    }
    forget(beside);
    return MURK_OK;
}

void murk_beside_discard(murk_beside *beside)
{
    if (beside->file >= 0)
        close(beside->file);
    if (beside->temporary)
        unlink(beside->temporary);
    forget(beside);
}
