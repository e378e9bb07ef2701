/* SPDX-License-Identifier: Apache-2.0 */
/* The command lines that murk records in what it writes. */
#ifndef CLI_RECORDED_H
#define CLI_RECORDED_H

#include "murk/murk.h"

enum { CLI_RECORD_SIZE = 65536 };

/* The command line that made an output of murk's; "" where the file holds none. */
void cli_recorded(murk_context *context, const char *path, char line[CLI_RECORD_SIZE]);

/* Whether two command lines ask for the same outputs: they are the same but for options that are
   aside (struct cli_option), and for how options are written. */
bool cli_recorded_same(const char *one, const char *other);

#endif
