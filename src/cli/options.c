/* SPDX-License-Identifier: Apache-2.0 */
#include "options.h"

#include "nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What is being parsed, for messages. */
struct parser {
    enum cli_command command;
    const char *command_name;
    char *message;
    size_t size;
};

/* The option of some commands that an argument names; *length is that of the name there. */
static const struct cli_option *find_option(unsigned commands, const char *argument, size_t *length)
{
    size_t count;
    const struct cli_option *table = cli_option_table(&count);
    bool is_long = argument[1] == '-';
    *length = is_long ? strcspn(argument, "=") : 2;
    for (size_t i = 0; i < count; i++) {
        const char *name = table[i].name;
        if ((table[i].commands & commands) &&
            (is_long ? strlen(name) == *length - 2 && !strncmp(name, argument + 2, *length - 2)
                     : table[i].letter == argument[1]))
            return &table[i];
    }
    return NULL;
}

const struct cli_option *cli_option_named(const char *argument, size_t *length)
{
    return find_option(CLI_ALL, argument, length);
}

static bool unknown_option(const struct parser *parser, const char *argument, size_t length)
{
    size_t count;
    const struct cli_option *table = cli_option_table(&count);
    struct murk_nearest nearest = {0};
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)length, argument);
    const char *bare = name + strspn(name, "-");
    for (size_t i = 0; i < count; i++)
        if (table[i].commands & parser->command)
            murk_nearest_offer(&nearest, bare, table[i].name);
    snprintf(parser->message, parser->size,
             "%s: unknown option of murk %s; the nearest known one is --%s", name,
             parser->command_name, nearest.word);
    return false;
}

static bool bad_value(const struct parser *parser, const struct cli_option *option,
                      const char *text)
{
    int used = snprintf(parser->message, parser->size, "--%s %s: is not %s", option->name, text,
                        option->expected ? option->expected : "one of");
    for (int i = 0; !option->expected && option->choices[i]; i++)
        if (used > 0 && (size_t)used < parser->size)
            used += snprintf(parser->message + used, parser->size - (size_t)used, "%s %s",
                             i ? "," : "", option->choices[i]);
    return false;
}

/* One option at arguments[*at]; *at is moved to its value where that is an argument of its own. */
static bool parse_option(const struct parser *parser, int count, char *const *arguments, int *at,
                         struct cli_options *out)
{
    const char *argument = arguments[*at], *text = NULL;
    bool is_long = argument[1] == '-';
    size_t length;
    const struct cli_option *option = find_option(parser->command, argument, &length);
    if (!option)
        return unknown_option(parser, argument, length);
    if (argument[length])
        text = argument + length + is_long;
    if (!option->argument && text) {
        snprintf(parser->message, parser->size, "%.*s: takes no value", (int)length, argument);
        return false;
    }
    if (option->argument && !text) {
        if (*at + 1 == count) {
            snprintf(parser->message, parser->size, "%s: needs a value %s", argument,
                     option->argument);
            return false;
        }
        text = arguments[++*at];
    }
    return option->value(text, (char *)out + option->offset, option) ||
           bad_value(parser, option, text);
}

static void set_defaults(struct cli_options *options)
{
    const murk_solve_options solve = MURK_SOLVE_DEFAULT;
    *options = (struct cli_options){
        .scale = NAN,
        .concentration = NAN,
        .voxel_size = NAN,
        .voxels = -1,
        .up = -1,
        .solve = solve,
        .eye = {NAN, NAN, NAN},
        .target = {NAN, NAN, NAN},
        .fov = NAN,
        .exposure = NAN,
        .range = {NAN, NAN},
        .runs = 3,
        .netd = NAN,
        .snr = NAN,
        .max_memory = NAN,
        .against = -1,
        .kernel = -1,
    };
}

bool cli_options_parse(enum cli_command command, const char *command_name, int count,
                       char *const *arguments, struct cli_options *out, char *message, size_t size)
{
    struct parser parser = {command, command_name, message, size};
    bool only_input = false;
    set_defaults(out);
    for (int at = 0; at < count; at++) {
        const char *argument = arguments[at];
        if (!only_input && !strcmp(argument, "--")) {
            only_input = true;
        } else if (!only_input && argument[0] == '-' && argument[1]) {
            if (!parse_option(&parser, count, arguments, &at, out))
                return false;
        } else if (!(command & CLI_INPUT)) {
            snprintf(message, size, "%s: takes no INPUT such as \"%s\"", command_name, argument);
            return false;
        } else if (out->input) {
            snprintf(message, size, "%s: takes one INPUT, and \"%s\" is a second", command_name,
                     argument);
            return false;
        } else {
            out->input = argument;
        }
    }
    if ((command & CLI_INPUT) && !out->input && !out->help) {
        snprintf(message, size, "%s: needs an INPUT: %s", command_name,
                 command == CLI_CONTRAST ? "an .exr picture of a scene with bands"
                                         : "a .vdb or .json file, or -");
        return false;
    }
    out->solve.method = out->method == 1 ? MURK_PAIRWISE : MURK_LINES;
    out->solve.solver = out->solver == 1 ? MURK_GAUSS_SEIDEL : MURK_CONJUGATE_GRADIENTS;
    return true;
}
