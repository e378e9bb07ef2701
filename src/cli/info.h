/* SPDX-License-Identifier: Apache-2.0 */
/* murk info: what is in a file, and what murk would take it for. */
#ifndef CLI_INFO_H
#define CLI_INFO_H

#include "options.h"

int cli_info(const struct cli_options *options, const char *command_line);

#endif
