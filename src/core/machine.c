/* SPDX-License-Identifier: Apache-2.0 */
/* What the machine can give, and whether that is enough. */
#include "memory.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* The number in a file; UINT64_MAX where there is no file, or no limit in it ("max"). */
static uint64_t number_in(const char *path)
{
    uint64_t number = UINT64_MAX;
    FILE *file = fopen(path, "r");
    if (file && fscanf(file, "%" SCNu64, &number) != 1)
        number = UINT64_MAX;
    if (file)
        fclose(file);
    return number;
}

/* The smallest limit of a control group and those that it is in. Inside of a container the file
   system may begin at the group itself: then the last step finds it. */
static uint64_t group_limit(const char *root, char *group, const char *name)
{
    uint64_t limit = UINT64_MAX;
    for (;;) {
        char path[4400];
        snprintf(path, sizeof path, "%s%s/%s", root, group, name);
        limit = least(limit, number_in(path));
        char *slash = strrchr(group, '/');
        if (!slash)
            return limit;
        *slash = '\0';
    }
}

static uint64_t groups_limit(void)
{
    char line[4200];
    uint64_t limit = UINT64_MAX;
    FILE *file = fopen("/proc/self/cgroup", "r");
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        char *controllers = strchr(line, ':');
        char *group = controllers ? strchr(controllers + 1, ':') : NULL;
        if (!group)
            continue;
        *group++ = '\0';
        if (!controllers[1])
            limit = least(limit, group_limit("/sys/fs/cgroup", group, "memory.max"));
        else if (strstr(controllers, "memory"))
            limit =
                least(limit, group_limit("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
    }
    if (file)
        fclose(file);
    return limit;
}

uint64_t murk_memory_machine(void)
{
    struct rlimit space;
    uint64_t limit = (uint64_t)sysconf(_SC_PHYS_PAGES) * (uint64_t)sysconf(_SC_PAGESIZE);
    if (!getrlimit(RLIMIT_AS, &space) && space.rlim_cur != RLIM_INFINITY)
        limit = least(limit, space.rlim_cur);
    return least(limit, groups_limit());
}

const char *murk_memory_text(uint64_t bytes, char text[MURK_MEMORY_TEXT])
{
    static const char *const UNITS[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    double value = (double)bytes;
    int unit = 0;
    for (; value >= 1024 && unit < 4; unit++)
        value /= 1024;
    snprintf(text, MURK_MEMORY_TEXT, "%.*f %s", unit && value < 10, value, UNITS[unit]);
    return text;
}

murk_status murk_memory_check(murk_context *context, const char *what, uint64_t bytes)
{
    char need[MURK_MEMORY_TEXT], left[MURK_MEMORY_TEXT], used[MURK_MEMORY_TEXT];
    if (bytes == UINT64_MAX)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", what);
    if (bytes <= murk_memory_left())
        return MURK_OK;
    return murk_fail(context, MURK_ERROR_MEMORY,
                     "%s needs about %s, the memory limit leaves %s beside the %s that are taken; "
                     "use a smaller medium or picture, or a larger limit",
                     what, murk_memory_text(bytes, need),
                     murk_memory_text(murk_memory_left(), left),
                     murk_memory_text(murk_memory_used(), used));
}
