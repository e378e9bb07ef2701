/* SPDX-License-Identifier: Apache-2.0 */
#include "memory.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A line of /proc/self/status such as "VmHWM:  1234 kB", in bytes. */
static double status_bytes(const char *key)
{
    char line[256];
    double kilobytes = NAN;
    size_t length = strlen(key);
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file))
        if (!strncmp(line, key, length) && line[length] == ':')
            sscanf(line + length + 1, "%lf", &kilobytes);
    if (file)
        fclose(file);
    return 1024 * kilobytes;
}

double bench_memory_start(void)
{
    malloc_trim(0);
    FILE *file = fopen("/proc/self/clear_refs", "w"); /* proc(5): 5 resets the peak */
    if (!file)
        return NAN;
    fputs("5\n", file);
    return fclose(file) == 0 ? status_bytes("VmRSS") : NAN;
}

double bench_memory_peak(void)
{
    return status_bytes("VmHWM");
}
