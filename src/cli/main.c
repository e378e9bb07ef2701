/* SPDX-License-Identifier: Apache-2.0 */
/* murk's command line: finds the command and hands over. */
#include "help.h"
#include "nearest.h"

#include <stdlib.h>
#include <string.h>

static void print_usage(FILE *stream)
{
    size_t count;
    const struct cli_command_info *commands = cli_command_table(&count);
    fputs("murk lights smoke, fog and clouds, and renders what they obscure.\n\nusage:\n", stream);
    for (size_t i = 0; i < count; i++)
        fprintf(stream, "  murk %s\n      %s\n", commands[i].usage, commands[i].summary);
    fputs(
        "\nINPUT is a .vdb file, a scene file (.json), or - for a VDB stream; for contrast it is\n"
        "an .exr picture of a scene with bands. A frame pattern (####, %04d, $F4) makes image,\n"
        "solve, render, bake, info and contrast run over a sequence.\n"
        "murk COMMAND --help lists the options of a command; murk --version tells the version.\n"
        "Exit status: 0 done, 1 bad input or usage, 2 the system failed, 3 tolerance not "
        "reached;\nof a sequence the status of its worst frame: 2 before 1 before 3.\n",
        stream);
}

static const struct cli_command_info *find_command(const char *name)
{
    size_t count;
    const struct cli_command_info *commands = cli_command_table(&count);
    struct murk_nearest nearest = {0};
    for (size_t i = 0; i < count; i++) {
        if (!strcmp(commands[i].name, name))
            return &commands[i];
        murk_nearest_offer(&nearest, name, commands[i].name);
    }
    fprintf(stderr, "murk: \"%s\": unknown command; the nearest known one is %s\n", name,
            nearest.word);
    return NULL;
}

/* The command line as a shell would take it, from malloc: recorded in what murk writes. */
static char *quote_command(int argc, char **argv)
{
    size_t size = 8;
    for (int i = 1; i < argc; i++)
        size += 4 * strlen(argv[i]) + 3; /* a quote becomes '\'' */
    char *line = malloc(size);
    if (!line)
        return NULL;
    char *end = stpcpy(line, "murk");
    for (int i = 1; i < argc; i++) {
        const char *plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                            "_-./,:=%+@";
        bool quoted = !*argv[i] || argv[i][strspn(argv[i], plain)];
        end = stpcpy(end, quoted ? " '" : " ");
        for (const char *c = argv[i]; *c; c++) {
            if (*c == '\'')
                end = stpcpy(end, "'\\'");
            *end++ = *c;
        }
        end = stpcpy(end, quoted ? "'" : "");
    }
    return line;
}

static int run_command(const struct cli_command_info *command, int argc, char **argv)
{
    struct cli_options options;
    char message[512];
    if (!cli_options_parse(command->command, command->name, argc - 2, argv + 2, &options, message,
                           sizeof message)) {
        fprintf(stderr, "murk: %s\n", message);
        return 1;
    }
    if (options.help) {
        cli_help_command(stdout, command);
        return 0;
    }
    char *line = quote_command(argc, argv);
    if (!line) {
        fputs("murk: out of memory\n", stderr);
        return 2;
    }
    int exit_status = command->run(&options, line);
    free(line);
    return exit_status;
}

/* Text to standard output counts only once it has arrived. */
static int flushed(int exit_status)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return exit_status;
    perror("murk: standard output");
    return exit_status ? exit_status : 2;
}

int main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : NULL;
    if (!name) {
        print_usage(stderr);
        return 1;
    }
    if (!strcmp(name, "--help") || !strcmp(name, "-h") || !strcmp(name, "help")) {
        const struct cli_command_info *command = argc > 2 ? find_command(argv[2]) : NULL;
        if (command)
            cli_help_command(stdout, command);
        else if (argc > 2)
            return 1;
        else
            print_usage(stdout);
        return flushed(0);
    }
    if (!strcmp(name, "--version")) {
        puts("murk " MURK_VERSION);
        return flushed(0);
    }
    const struct cli_command_info *command = find_command(name);
    return command ? flushed(run_command(command, argc, argv)) : 1;
}
