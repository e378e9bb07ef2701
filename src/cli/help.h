/* SPDX-License-Identifier: Apache-2.0 */
/* Help texts, from the table of options. */
#ifndef CLI_HELP_H
#define CLI_HELP_H

#include "options.h"

#include <stdio.h>

/* What a command is: the rows of main.c. */
struct cli_command_info {
    enum cli_command command;
    const char *name, *usage, *summary;
    int (*run)(const struct cli_options *options, const char *command_line);
};

void cli_help_command(FILE *stream, const struct cli_command_info *command);

#endif
