/* SPDX-License-Identifier: Apache-2.0 */
/* murk image, solve and render. */
#ifndef CLI_WORK_H
#define CLI_WORK_H

#include "options.h"

int cli_image(const struct cli_options *options, const char *command_line);
int cli_solve(const struct cli_options *options, const char *command_line);
int cli_render(const struct cli_options *options, const char *command_line);

#endif
