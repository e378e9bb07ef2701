/* SPDX-License-Identifier: Apache-2.0 */
#include "help.h"

#include <string.h>

enum { INDENT = 28, WIDTH = 80 };

/* Prints text from column to WIDTH, further lines indented. */
static void print_wrapped(FILE *stream, const char *text, int column)
{
    while (*text) {
        size_t length = strcspn(text, " ");
        if (column > INDENT && column + 1 + (int)length > WIDTH) {
            fprintf(stream, "\n%*s", INDENT, "");
            column = INDENT;
        } else if (column > INDENT) {
            fputc(' ', stream);
            column++;
        }
        fprintf(stream, "%.*s", (int)length, text);
        column += (int)length;
        text += length;
        text += *text == ' ';
    }
    fputc('\n', stream);
}

static void print_option(FILE *stream, const struct cli_option *option)
{
    char left[64];
    int used =
        snprintf(left, sizeof left, "  %c%c%c --%s%s%s", option->letter ? '-' : ' ',
                 option->letter ? option->letter : ' ', option->letter ? ',' : ' ', option->name,
                 option->argument ? " " : "", option->argument ? option->argument : "");
    if (used > INDENT - 2)
        fprintf(stream, "%s\n%*s", left, INDENT, "");
    else
        fprintf(stream, "%-*s", INDENT, left);
    print_wrapped(stream, option->help, INDENT);
}

void cli_help_command(FILE *stream, const struct cli_command_info *command)
{
    size_t count;
    const struct cli_option *table = cli_option_table(&count);
    const char *section = NULL;
    fprintf(stream, "usage: murk %s\n\n%s\n", command->usage, command->summary);
    for (size_t i = 0; i < count; i++) {
        if (!(table[i].commands & command->command))
            continue;
        if (!section || strcmp(section, table[i].section)) {
            section = table[i].section;
            fprintf(stream, "\n%s:\n", section);
        }
        print_option(stream, &table[i]);
    }
}
