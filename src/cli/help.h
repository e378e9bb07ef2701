/* SPDX-License-Identifier: Apache-2.0 */
/* Help texts, from the table of options. */
#ifndef CLI_HELP_H
#define CLI_HELP_H

#include "commands.h"

#include <stdio.h>

void cli_help_command(FILE *stream, const struct cli_command_info *command);

#endif
