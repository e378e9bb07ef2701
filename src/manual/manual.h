/* SPDX-License-Identifier: Apache-2.0 */
/* The manual pages and the completion of bash, made from the tables of the command line. */
#ifndef MANUAL_H
#define MANUAL_H

#include "commands.h"

#include <stdio.h>

/* The page of murk itself, of one command, or of a file format, in man's language. prose is the
   page's own text, or NULL; its line @OPTIONS@ or @COMMANDS@ stands for what the tables say. */
void manual_program(FILE *stream, FILE *prose);
void manual_command(FILE *stream, FILE *prose, const struct cli_command_info *command);
void manual_format(FILE *stream, FILE *prose, const char *name);

void manual_completion(FILE *stream);

#endif
