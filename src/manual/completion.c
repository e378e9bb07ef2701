/* SPDX-License-Identifier: Apache-2.0 */
#include "manual.h"
#include "values.h"

#include <string.h>

static const char FUNCTIONS[] =
    "# bash completion for murk; made by murk_manual from the tables of the command line.\n"
    "\n"
    "_murk_words() # those words that go on from what is typed\n"
    "{\n"
    "    mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$current\")\n"
    "}\n"
    "\n"
    "_murk_list() # the same after the last comma\n"
    "{\n"
    "    local typed=${current%\"${current##*,}\"}\n"
    "    mapfile -t COMPREPLY < <(compgen -P \"$typed\" -W \"$1\" -- \"${current##*,}\")\n"
    "}\n"
    "\n"
    "_murk_files() # folders, and files with one of the extensions; any where there are none\n"
    "{\n"
    "    local file\n"
    "    compopt -o filenames 2>/dev/null\n"
    "    while IFS= read -r file; do\n"
    "        [[ -z $1 || -d $file || \" $1 \" == *\" ${file##*.} \"* ]] && COMPREPLY+=(\"$file\")\n"
    "    done < <(compgen -f -- \"$current\")\n"
    "}\n"
    "\n";

static const char BEGIN[] =
    "_murk()\n"
    "{\n"
    "    local current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}\n"
    "    local command=${COMP_WORDS[1]}\n"
    "    COMPREPLY=()\n"
    "    if [[ $current == = ]]; then # --method=lines comes as three words\n"
    "        current=\n"
    "    elif [[ $option == = ]]; then\n"
    "        option=${COMP_WORDS[COMP_CWORD - 2]}\n"
    "    fi\n";

/* The names of all commands. */
static void put_commands(FILE *stream)
{
    size_t count;
    const struct cli_command_info *table = cli_command_table(&count);
    for (size_t i = 0; i < count; i++)
        fprintf(stream, "%s%s", i ? " " : "", table[i].name);
}

static bool is_file(const struct cli_option *option)
{
    return option->files || !strcmp(option->argument, "FILE") ||
           !strcmp(option->argument, "REGION");
}

/* What may follow an option: its choices, files, or what only the user knows. */
static void put_value(FILE *stream, const char *command, const struct cli_option *option)
{
    fprintf(stream, "    %s:--%s", command, option->name);
    if (option->letter)
        fprintf(stream, " | %s:-%c", command, option->letter);
    fputs(") ", stream);
    if (option->choices) {
        fputs(option->value == cli_value_set ? "_murk_list \"" : "_murk_words \"", stream);
        for (int i = 0; option->choices[i]; i++)
            fprintf(stream, "%s%s", i ? " " : "", option->choices[i]);
        fputs("\" ;;\n", stream);
    } else if (is_file(option)) {
        fprintf(stream, "_murk_files \"%s\" ;;\n", option->files ? option->files : "");
    } else {
        fputs(";;\n", stream);
    }
}

/* What stands alone: an option's name, or else INPUT. */
static void put_words(FILE *stream, const struct cli_command_info *command)
{
    size_t count;
    const struct cli_option *table = cli_option_table(&count);
    fprintf(stream, "    %s:*)\n        if [[ $current == -* ]]; then\n            _murk_words \"",
            command->name);
    const char *space = "";
    for (size_t i = 0; i < count; i++) {
        if (!(table[i].commands & command->command))
            continue;
        if (table[i].letter)
            fprintf(stream, "%s-%c", space, table[i].letter);
        fprintf(stream, "%s--%s", table[i].letter ? " " : space, table[i].name);
        space = " ";
    }
    fputs("\"\n", stream);
    if (command->command & CLI_INPUT)
        fprintf(stream, "        else\n            _murk_files \"%s\"\n",
                command->files ? command->files : "");
    fputs("        fi\n        ;;\n", stream);
}

void manual_completion(FILE *stream)
{
    size_t commands, options;
    const struct cli_command_info *command = cli_command_table(&commands);
    const struct cli_option *option = cli_option_table(&options);
    fputs(FUNCTIONS, stream);
    fputs(BEGIN, stream);
    fputs("    if ((COMP_CWORD == 1)); then\n        _murk_words \"", stream);
    put_commands(stream);
    fputs(" help --help --version\"\n        return\n    fi\n    case $command:$option in\n",
          stream);
    fputs("    help:help) _murk_words \"", stream);
    put_commands(stream);
    fputs("\" ;;\n", stream);
    for (size_t c = 0; c < commands; c++) {
        for (size_t i = 0; i < options; i++)
            if ((option[i].commands & command[c].command) && option[i].argument)
                put_value(stream, command[c].name, &option[i]);
        put_words(stream, &command[c]);
    }
    fputs("    esac\n}\n\ncomplete -F _murk murk\n", stream);
}
