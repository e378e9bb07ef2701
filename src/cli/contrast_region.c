/* SPDX-License-Identifier: Apache-2.0 */
#include "contrast_region.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Nine digits at most, so that no number is too large. */
static bool read_rectangle(const char *text, murk_region *out)
{
    int end = 0;
    murk_region r = {0};
    if (strspn(text, "0123456789,x") != strlen(text) ||
        sscanf(text, "%9d,%9d,%9dx%9d%n", &r.x, &r.y, &r.width, &r.height, &end) != 4 || text[end])
        return false;
    *out = r;
    return true;
}

murk_status cli_region_read(struct cli_job *job, const char *option, const char *text,
                            struct cli_region *out)
{
    struct cli_region region = {0};
    if (!read_rectangle(text, &region.region)) {
        if (access(text, F_OK) != 0) {
            cli_error(&job->terminal,
                      "%s %s: is neither a rectangle such as 100,120,40x30 nor an image file",
                      option, text);
            return MURK_ERROR_INPUT;
        }
        murk_status status = murk_image_read(job->context, text, &region.mask);
        if (status != MURK_OK)
            return cli_job_fail(job, status);
        region.region.mask = region.mask;
    }
    *out = region;
    return MURK_OK;
}

void cli_region_release(struct cli_region *region)
{
    murk_image_release(region->mask);
    *region = (struct cli_region){0};
}
