/* SPDX-License-Identifier: Apache-2.0 */
/* The two textures of six-way lighting, a cell for each frame. */
#ifndef CLI_BAKE_SHEET_H
#define CLI_BAKE_SHEET_H

#include "job.h"

struct cli_bake_sheet {
    murk_image
        *half[2]; /* positive: right, top, back, opacity; negative: left, bottom, front, glow */
    int cell[2], columns;
};

murk_status cli_bake_sheet_create(struct cli_job *job, const int cell[2], const int cells[2],
                                  struct cli_bake_sheet *out);
void cli_bake_sheet_clear(struct cli_bake_sheet *sheet);

/* Puts the radiance of a picture of murk_render() into a channel of a cell: 0 ... 2 of the positive
   half, 3 ... 5 of the negative one, then the glow. The opacity goes with each. */
void cli_bake_sheet_put(struct cli_bake_sheet *sheet, int at, int channel,
                        const murk_image *picture);

/* Whether path names a format with an alpha channel; fails where it, or one of the two files that
   it stands for, cannot be written. */
murk_status cli_bake_sheet_check(struct cli_job *job, const char *path);

/* Writes both halves; the sheet is changed to what they hold. */
murk_status cli_bake_sheet_write(struct cli_job *job, struct cli_bake_sheet *sheet,
                                 const char *path);

#endif
