/* SPDX-License-Identifier: Apache-2.0 */
/* The options that name files. */
#ifndef CLI_PATHS_H
#define CLI_PATHS_H

#include "options.h"

enum { CLI_PATH_MAX = 9 };

struct cli_path {
    const char *option; /* "--preview" */
    const char **text;
    bool input;
};

/* Lists the paths that are given to a command for each frame, INPUT first; gives their number. The
   outputs of murk contrast and the sheets of a flipbook are not among them: they hold all frames.
 */
size_t cli_paths(struct cli_options *options, const char *command,
                 struct cli_path list[CLI_PATH_MAX]);

/* The options of one frame. */
struct cli_frame_options {
    struct cli_options options;
    char *texts[CLI_PATH_MAX];
};

/* Puts the frame where the paths are patterns. Fails with MURK_ERROR_MEMORY. */
murk_status cli_frame_options_make(const struct cli_options *options, const char *command,
                                   int frame, struct cli_frame_options *out);
void cli_frame_options_release(struct cli_frame_options *frame_options);

#endif
