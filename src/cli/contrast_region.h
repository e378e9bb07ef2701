/* SPDX-License-Identifier: Apache-2.0 */
/* Regions of a picture, as options name them. */
#ifndef CLI_CONTRAST_REGION_H
#define CLI_CONTRAST_REGION_H

#include "job.h"

#include "murk/contrast.h"

struct cli_region {
    murk_region region;
    murk_image *mask; /* that the region borrows, or NULL */
};

/* Reads the value of an option ("--target"): X,Y,WxH, or the path of a mask. Has told the user
   about a failure. */
murk_status cli_region_read(struct cli_job *job, const char *option, const char *text,
                            struct cli_region *out);
void cli_region_release(struct cli_region *region);

#endif
