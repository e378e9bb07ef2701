/* SPDX-License-Identifier: Apache-2.0 */
#include "job.h"

#include "murk/memory.h"

#include <math.h>
#include <stdio.h>

/* "1.5 GiB" */
static const char *memory_text(double bytes, char text[32])
{
    static const char *const UNITS[] = {"KiB", "MiB", "GiB"};
    int unit = 0;
    for (bytes /= 1024; bytes >= 1024 && unit < 2; unit++)
        bytes /= 1024;
    snprintf(text, 32, "%.*f %s", bytes < 10, bytes, UNITS[unit]);
    return text;
}

murk_status cli_job_afford(struct cli_job *job, size_t solutions, const char *what, double bytes)
{
    const double limit =
        isnan(job->options->max_memory) ? (double)murk_memory_machine() : job->options->max_memory;
    const double left = fmax(0, limit - (double)murk_memory_used()), brick = 512 * sizeof(float);
    char need[32], keep[32], have[32];
    murk_medium_info info;
    murk_status status = murk_medium_info_get(job->scene.band[0].medium, &info);
    const double kept = status ? 0 : brick * (double)solutions * (double)info.bricks;
    if (bytes + kept <= left)
        return MURK_OK;
    cli_error(&job->terminal,
              "%s: %s needs about %s beside the %s of the solution%s, the memory limit leaves %s; "
              "use a smaller picture or medium, or a larger limit (--max-memory)",
              job->options->input, what, memory_text(bytes, need), memory_text(kept, keep),
              solutions == 1 ? "" : "s", memory_text(left, have));
    return MURK_ERROR_MEMORY;
}
