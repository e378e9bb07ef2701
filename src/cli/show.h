/* SPDX-License-Identifier: Apache-2.0 */
/* --show: one channel of the picture in false colour. */
#ifndef CLI_SHOW_H
#define CLI_SHOW_H

#include "job.h"

/* Fails where --show has no 8-bit picture to go to, and where --range or --exposure do not go with
   it. */
murk_status cli_show_check(struct cli_job *job);

/* Fails where the picture of the job's scene will have no such channel. */
murk_status cli_show_check_channel(struct cli_job *job);

/* Whether a picture at path is to show the channel: where the option is given and path is not that
   of an .exr, which keeps everything. */
bool cli_show_wanted(const struct cli_job *job, const char *path);

/* The channel of the job's picture in false colour; NULL where the option is not given. */
murk_status cli_show_make(struct cli_job *job, murk_image **out);

#endif
