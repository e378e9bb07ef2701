/* SPDX-License-Identifier: Apache-2.0 */
#include "target.h"

#include "context.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static murk_status target_fail(murk_context *context, const char *path, int error)
{
    return murk_fail(context, MURK_ERROR_IO, "%s: cannot write: %s", path, strerror(error));
}

static size_t target_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

murk_status murk_target_check(murk_context *context, const char *path)
{
    size_t name = target_name(path);
    char *folder = murk_alloc(name + 2, 1);
    if (!folder)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    memcpy(folder, name ? path : "./", name ? name : 2);
    struct stat what;
    murk_status status = MURK_OK;
    if (stat(folder, &what) != 0 || access(folder, W_OK | X_OK) != 0)
        status = murk_fail(context, MURK_ERROR_IO, "%s: cannot write: folder %s: %s", path, folder,
                           strerror(errno));
    else if (stat(path, &what) == 0 && !S_ISREG(what.st_mode))
        status = murk_fail(context, MURK_ERROR_IO, "%s: cannot write: not a regular file", path);
    murk_free(folder);
    return status;
}

murk_status murk_target_open(murk_context *context, const char *path, murk_target *target)
{
    murk_status status = murk_target_check(context, path);
    if (status != MURK_OK)
        return status;
    size_t name = target_name(path), size = strlen(path) + 64;
    const char *dot = strrchr(path + name, '.');
    char *temporary = murk_alloc(size, 1);
    if (!temporary)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    for (int attempt = 0;; attempt++) {
        snprintf(temporary, size, "%.*s.murk-%ld-%d%s", (int)name, path, (long)getpid(), attempt,
                 dot ? dot : "");
        int file = open(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (file >= 0) {
            close(file);
            break;
        }
        if (errno != EEXIST) {
            int error = errno;
            murk_free(temporary);
            return target_fail(context, path, error);
        }
    }
    *target = (murk_target){.path = path, .temporary = temporary};
    return MURK_OK;
}

murk_status murk_target_close(murk_context *context, murk_target *target, murk_status status)
{
    if (status == MURK_OK && rename(target->temporary, target->path) != 0)
        status = target_fail(context, target->path, errno);
    if (status != MURK_OK)
        unlink(target->temporary);
    murk_free(target->temporary);
    target->temporary = NULL;
    return status;
}
