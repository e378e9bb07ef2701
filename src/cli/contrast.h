/* SPDX-License-Identifier: Apache-2.0 */
/* murk contrast: what of a target is seen through the smoke. */
#ifndef CLI_CONTRAST_H
#define CLI_CONTRAST_H

#include "job.h"

#include "murk/contrast.h"

/* What was measured in a band of a picture. */
struct cli_contrast_row {
    bool has_frame;
    int frame;
    murk_picture_band band;
    murk_contrast contrast;
};

struct cli_contrast {
    struct cli_contrast_row *row;
    size_t count;
};

int cli_contrast(const struct cli_options *options, const char *command_line);

/* The text of a table with a line for each row, from malloc; NULL when memory runs out. */
char *cli_contrast_table(const struct cli_contrast *contrast);

/* Prints one object for the picture that the count rows are of. */
void cli_contrast_json(const struct cli_job *job, const struct cli_contrast_row *row, size_t count);

/* Draws the rows and writes the picture of them. Has told the user about a failure. */
murk_status cli_contrast_plot(struct cli_job *job, const struct cli_contrast *contrast);

#endif
