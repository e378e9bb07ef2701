/* SPDX-License-Identifier: Apache-2.0 */
/* murk bake: a medium lit from six sides, as textures for game engines. */
#ifndef CLI_BAKE_H
#define CLI_BAKE_H

#include "options.h"

int cli_bake(const struct cli_options *options, const char *command_line);

#endif
