/* SPDX-License-Identifier: Apache-2.0 */
/* The commands: one table drives the program, its help, the manual pages and the completion. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

#include "options.h"

struct cli_command_info {
    enum cli_command command;
    const char *name, *usage, *summary;
    const char *files; /* usual extensions of INPUT, "vdb json"; NULL: any */
    int (*run)(const struct cli_options *options, const char *command_line);
};

/* The table; *count rows in the order of the help text. */
const struct cli_command_info *cli_command_table(size_t *count);

#endif
