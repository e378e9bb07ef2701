/* SPDX-License-Identifier: Apache-2.0 */
/* murk's command line: finds the command and hands over. */
#include "bake.h"
#include "bench.h"
#include "contrast.h"
#include "help.h"
#include "info.h"
#include "nearest.h"
#include "work.h"

#include <stdlib.h>
#include <string.h>

static const struct cli_command_info COMMANDS[] = {
    {CLI_IMAGE, "image", "image INPUT -o FILE.exr [OPTION]...",
     "Solves the light in the medium, then renders the picture.", cli_image},
    {CLI_SOLVE, "solve", "solve INPUT -o FILE.vdb [OPTION]...",
     "Solves the light in the medium and writes its radiosity.", cli_solve},
    {CLI_RENDER, "render", "render INPUT --radiosity FILE.vdb -o FILE.exr [OPTION]...",
     "Renders another view of a solution; nothing is solved again.", cli_render},
    {CLI_BAKE, "bake", "bake INPUT -o FILE.png [OPTION]...",
     "Lights the medium from six sides, to the textures of six-way lighting in game engines.",
     cli_bake},
    {CLI_INFO, "info", "info INPUT [OPTION]...",
     "Tells what is in a file, and what murk would take it for.", cli_info},
    {CLI_CONTRAST, "contrast", "contrast INPUT --target REGION --background REGION [OPTION]...",
     "Tells what of a target is seen through the smoke, in each band of a picture.", cli_contrast},
    {CLI_BENCH, "bench", "bench [-o FILE.png] [OPTION]...",
     "Measures run time, memory and error on media made in memory.", cli_bench},
};
enum { COMMAND_COUNT = sizeof COMMANDS / sizeof *COMMANDS };

static void print_usage(FILE *stream)
{
    fputs("murk lights smoke, fog and clouds, and renders what they obscure.\n\nusage:\n", stream);
    for (int i = 0; i < COMMAND_COUNT; i++)
        fprintf(stream, "  murk %s\n      %s\n", COMMANDS[i].usage, COMMANDS[i].summary);
    fputs(
        "\nINPUT is a .vdb file, a scene file (.json), or - for a VDB stream; for contrast it is\n"
        "an .exr picture of a scene with bands. A frame pattern (####, %04d, $F4) makes image,\n"
        "solve, render, bake and contrast run over a sequence.\n"
        "murk COMMAND --help lists the options of a command; murk --version tells the version.\n"
        "Exit status: 0 done, 1 bad input or usage, 2 the system failed, 3 tolerance not "
        "reached;\nof a sequence the status of its worst frame: 2 before 1 before 3.\n",
        stream);
}

static const struct cli_command_info *find_command(const char *name)
{
    struct scene_nearest nearest = {0};
    for (int i = 0; i < COMMAND_COUNT; i++) {
        if (!strcmp(COMMANDS[i].name, name))
            return &COMMANDS[i];
        scene_nearest_offer(&nearest, name, COMMANDS[i].name);
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
