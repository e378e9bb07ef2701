/* SPDX-License-Identifier: Apache-2.0 */
#include "cgroup.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static double limit_of(const char *group, const char *name)
{
    char path[PATH_MAX + 64];
    double limit, period;
    snprintf(path, sizeof path, "/sys/fs/cgroup%s/%s", group, name);
    FILE *file = fopen(path, "r");
    if (!file)
        return INFINITY;
    int count = fscanf(file, "%lf %lf", &limit, &period); /* "max" is no number */
    fclose(file);
    return count == 2 && period > 0 ? limit / period : count >= 1 ? limit : INFINITY;
}

double cli_cgroup_limit(const char *name)
{
    char line[PATH_MAX] = "";
    double least = INFINITY;
    FILE *file = fopen("/proc/self/cgroup", "r");
    if (!file)
        return least;
    while (strncmp(line, "0::/", 4) && fgets(line, sizeof line, file))
        ;
    fclose(file);
    if (strncmp(line, "0::/", 4))
        return least;
    char *group = line + 3;
    group[strcspn(group, "\n")] = '\0';
    for (char *end; (end = strrchr(group, '/')); *end = '\0')
        least = fmin(least, limit_of(group, name));
    return least;
}
