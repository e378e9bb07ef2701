/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* O_TMPFILE */
#include "beside.h"

#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A path beside the target that nothing else uses. */
static char *name_beside(const char *target, int n)
{
    static const char format[] = "%.*s.%s.%ld-%d.tmp";
    const char *slash = strrchr(target, '/');
    const char *name = slash ? slash + 1 : target;
    size_t size = strlen(target) + sizeof format + 40;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, format, (int)(name - target), target, name, (long)getpid(), n);
    else
        errno = ENOMEM;
    return path;
}

static bool nameless = true;

void murk_beside_allow_nameless(bool allow)
{
    nameless = allow;
}

/* A file in the target's folder that has no name until it is complete, so that nothing of it is
   left whatever ends the process; -1 where the system has no such files. */
static int create_nameless(const char *target)
{
#ifdef O_TMPFILE
    const char *slash = strrchr(target, '/');
    char *folder = slash ? strndup(target, (size_t)(slash - target) + 1) : strdup(".");
    int file = -1;
    if (folder && !access("/proc/self/fd", X_OK))
        file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    free(folder);
    return file;
#else
    (void)target;
    return -1;
#endif
}

enum { TRIES = 1000, MOST_NAMED = 64 };

/* Names of files that are not complete, which a signal handler may remove at any time: who takes a
   name out of its place owns it. */
static _Atomic(char *) named[MOST_NAMED];

static void enter(char *path)
{
    for (int n = 0; n < MOST_NAMED; n++) {
        char *none = NULL;
        if (atomic_compare_exchange_strong(&named[n], &none, path))
            return;
    }
}

/* Frees a name; not one that a signal handler has just taken. */
static void strike(char *path)
{
    int reason = errno, n = 0;
    while (n < MOST_NAMED && atomic_load(&named[n]) != path)
        n++;
    char *mine = path;
    if (n == MOST_NAMED || atomic_compare_exchange_strong(&named[n], &mine, NULL))
        free(path);
    errno = reason;
}

void murk_outputs_abandon(void)
{
    for (int n = 0; n < MOST_NAMED; n++) {
        const char *path = atomic_exchange(&named[n], NULL);
        if (path)
            unlink(path);
    }
}

/* A new file in the target's folder, with the permissions that any new file gets. */
static int create_beside(const char *target, char **temporary)
{
    int file = nameless ? create_nameless(target) : -1;
    for (int n = 0; file < 0 && n < TRIES; n++) {
        char *path = name_beside(target, n);
        if (!path)
            return -1;
        enter(path); /* first, so that a signal finds it; the name is this process's alone */
        file = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            *temporary = path;
            break;
        }
        strike(path);
        if (errno != EEXIST)
            break;
    }
    return file;
}

/* Gives a file without a name one beside its target. */
static int give_name(murk_beside *beside)
{
    char here[64];
    snprintf(here, sizeof here, "/proc/self/fd/%d", beside->file);
    for (int n = 0; n < TRIES; n++) {
        char *path = name_beside(beside->target, n);
        if (!path)
            return -1;
        enter(path);
        if (!linkat(AT_FDCWD, here, AT_FDCWD, path, AT_SYMLINK_FOLLOW)) {
            beside->temporary = path;
            return 0;
        }
        strike(path);
        if (errno != EEXIST)
            break;
    }
    return -1;
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
    if (beside->temporary)
        strike(beside->temporary);
    *beside = (murk_beside){.file = -1};
}

murk_status murk_beside_finish(murk_context *context, murk_beside *beside)
{
    int failed = beside->target && !beside->temporary ? give_name(beside) : 0;
    failed |= close(beside->file);
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
