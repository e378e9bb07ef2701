/* SPDX-License-Identifier: Apache-2.0 */
#include "manual.h"

#include <ctype.h>
#include <string.h>

enum { LINE_SIZE = 1024 };

/* Text as man wants it: no sign of it is a command, and a minus sign stays one. */
static void put_text(FILE *stream, const char *text)
{
    if (*text == '.' || *text == '\'')
        fputs("\\&", stream);
    for (const char *c = text; *c; c++) {
        bool hyphen = c > text && isalnum((unsigned char)c[-1]) && isalpha((unsigned char)c[1]);
        if (*c == '\\')
            fputs("\\e", stream);
        else if (*c == '-' && !hyphen)
            fputs("\\-", stream);
        else if (*c == '^')
            fputs("\\(ha", stream);
        else if (*c == '~')
            fputs("\\(ti", stream);
        else
            fputc(*c, stream);
    }
}

static void put_title(FILE *stream, const char *name, int section)
{
    fputs(".\\\" Made by murk_manual from the tables of the command line; not to be edited.\n.TH ",
          stream);
    for (; *name; name++)
        fputc(toupper((unsigned char)*name), stream);
    fprintf(stream, " %d \"\" \"murk %s\" \"murk manual\"\n", section, MURK_VERSION);
}

/* A sentence as the description of a page: no capital, no full stop. */
static void put_name(FILE *stream, const struct cli_command_info *command)
{
    char summary[LINE_SIZE];
    snprintf(summary, sizeof summary, "%s", command->summary);
    summary[0] = (char)tolower((unsigned char)summary[0]);
    summary[strcspn(summary, ".")] = '\0';
    fprintf(stream, ".SH NAME\nmurk-%s \\- ", command->name);
    put_text(stream, summary);
    fputc('\n', stream);
}

/* What stands in capitals is for the user to fill in. */
static void put_usage(FILE *stream, const char *usage)
{
    char words[LINE_SIZE];
    snprintf(words, sizeof words, "%s", usage);
    fputs("\\fBmurk", stream);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " ")) {
        size_t plain = strcspn(word, "ABCDEFGHIJKLMNOPQRSTUVWXYZ");
        size_t capitals = strspn(word + plain, "ABCDEFGHIJKLMNOPQRSTUVWXYZ");
        fprintf(stream, " \\fB%s", strchr(word, '[') ? "\\fR" : "");
        for (size_t i = 0; i < plain; i++)
            fprintf(stream, "%s%c", word[i] == '-' ? "\\" : "", word[i]);
        fprintf(stream, "\\fI%.*s\\fR%s", (int)capitals, word + plain, word + plain + capitals);
    }
    fputs("\\fR\n", stream);
}

static void put_option(FILE *stream, const struct cli_option *option)
{
    fputs(".TP\n", stream);
    if (option->letter)
        fprintf(stream, "\\fB\\-%c\\fR, ", option->letter);
    fputs("\\fB\\-\\-", stream);
    for (const char *c = option->name; *c; c++)
        fprintf(stream, "%s%c", *c == '-' ? "\\" : "", *c);
    if (option->argument)
        fprintf(stream, "\\fR \\fI%s", option->argument);
    fputs("\\fR\n", stream);
    put_text(stream, option->help);
    fputc('\n', stream);
}

static void put_options(FILE *stream, enum cli_command command)
{
    size_t count;
    const struct cli_option *table = cli_option_table(&count);
    const char *section = NULL;
    fputs(".SH OPTIONS\n", stream);
    for (size_t i = 0; i < count; i++) {
        if (!(table[i].commands & command))
            continue;
        if (!section || strcmp(section, table[i].section)) {
            section = table[i].section;
            fputs(".SS \"", stream);
            put_text(stream, section);
            fputs("\"\n", stream);
        }
        put_option(stream, &table[i]);
    }
}

static void put_commands(FILE *stream)
{
    size_t count;
    const struct cli_command_info *table = cli_command_table(&count);
    for (size_t i = 0; i < count; i++) {
        fprintf(stream, ".TP\n.BR murk\\-%s (1)\n", table[i].name);
        put_text(stream, table[i].summary);
        fputc('\n', stream);
    }
}

static void put_exit_status(FILE *stream)
{
    fputs(".SH \"EXIT STATUS\"\n"
          ".TP\n0\nDone.\n"
          ".TP\n1\nBad input or usage: one line on standard error says what, and what would be "
          "right.\n"
          ".TP\n2\nThe system failed: memory, disk.\n"
          ".TP\n3\nThe tolerance was not reached. The result is written all the same.\n"
          ".PP\nOf a sequence, the status of its worst frame: 2 before 1 before 3.\n",
          stream);
}

/* All the other pages; all but own, which may be NULL. */
static void put_see_also(FILE *stream, const char *own)
{
    static const char *const FORMATS[] = {"scene", "obscurant", "vdb", "exr", "report"};
    size_t count, formats = sizeof FORMATS / sizeof *FORMATS;
    const struct cli_command_info *table = cli_command_table(&count);
    fputs(".SH \"SEE ALSO\"\n", stream);
    if (own)
        fputs(".BR murk (1),\n", stream);
    for (size_t i = 0; i < count; i++)
        if (!own || strcmp(own, table[i].name))
            fprintf(stream, ".BR murk\\-%s (1),\n", table[i].name);
    for (size_t i = 0; i < formats; i++)
        if (!own || strcmp(own, FORMATS[i]))
            fprintf(stream, ".BR murk\\-%s (5)%s\n", FORMATS[i], i + 1 < formats ? "," : "");
}

/* Copies the page's own text; what the tables say goes where it wants it, or else to its end. */
static void put_prose(FILE *stream, FILE *prose, enum cli_command command)
{
    char line[LINE_SIZE];
    bool options = false;
    while (prose && fgets(line, sizeof line, prose)) {
        if (!strcmp(line, "@COMMANDS@\n")) {
            put_commands(stream);
        } else if (!strcmp(line, "@OPTIONS@\n")) {
            put_options(stream, command);
            options = true;
        } else {
            fputs(line, stream);
        }
    }
    if (!options && command)
        put_options(stream, command);
}

void manual_program(FILE *stream, FILE *prose)
{
    put_title(stream, "murk", 1);
    put_prose(stream, prose, 0);
    put_exit_status(stream);
    put_see_also(stream, NULL);
}

void manual_command(FILE *stream, FILE *prose, const struct cli_command_info *command)
{
    char name[LINE_SIZE];
    snprintf(name, sizeof name, "murk-%s", command->name);
    put_title(stream, name, 1);
    put_name(stream, command);
    fputs(".SH SYNOPSIS\n", stream);
    put_usage(stream, command->usage);
    put_prose(stream, prose, command->command);
    put_exit_status(stream);
    put_see_also(stream, command->name);
}

void manual_format(FILE *stream, FILE *prose, const char *name)
{
    char title[LINE_SIZE];
    snprintf(title, sizeof title, "murk-%s", name);
    put_title(stream, title, 5);
    put_prose(stream, prose, 0);
    put_see_also(stream, name);
}
