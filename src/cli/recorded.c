/* SPDX-License-Identifier: Apache-2.0 */
#include "recorded.h"

#include "job.h"
#include "options.h"

#include <stdlib.h>
#include <string.h>

void cli_recorded(murk_context *context, const char *path, char line[CLI_RECORD_SIZE])
{
    murk_status status = cli_has_extension(path, ".vdb")
                             ? murk_volume_command(context, path, line, CLI_RECORD_SIZE)
                             : murk_image_command(context, path, line, CLI_RECORD_SIZE);
    if (status != MURK_OK)
        *line = '\0';
}

/* Takes a word off a line as main() has quoted it, into room for all of the line; false at the
   end. */
static bool take_word(const char **line, char *word)
{
    bool quoted = false;
    *line += strspn(*line, " ");
    if (!**line)
        return false;
    for (; **line && (quoted || **line != ' '); ++*line) {
        if (**line == '\'')
            quoted = !quoted;
        else if (!quoted && **line == '\\' && (*line)[1])
            *word++ = *++*line;
        else
            *word++ = **line;
    }
    *word = '\0';
    return true;
}

/* A setting of a command line: an option and its value, or a word that is none. */
struct setting {
    const struct cli_option *option; /* NULL: none */
    char *text;
};

/* Takes the next setting that matters; false at the end. */
static bool take_setting(const char **line, char *word, struct setting *out)
{
    do {
        size_t length = 0;
        if (!take_word(line, word))
            return false;
        out->option = word[0] == '-' ? cli_option_named(word, &length) : NULL;
        out->text = word + length;
        if (!out->option)
            continue;
        if (out->option->argument && !*out->text)
            take_word(line, out->text);
        else if (word[1] == '-' && *out->text)
            out->text++; /* = */
    } while (out->option && out->option->aside);
    return true;
}

bool cli_recorded_same(const char *one, const char *other)
{
    char *words = malloc(strlen(one) + strlen(other) + 2), *second = words + strlen(one) + 1;
    bool same = words, more = words;
    while (same && more) {
        struct setting a, b;
        more = take_setting(&one, words, &a);
        same = more == take_setting(&other, second, &b) &&
               (!more || (a.option == b.option && !strcmp(a.text, b.text)));
    }
    free(words);
    return same;
}
