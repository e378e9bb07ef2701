/* SPDX-License-Identifier: Apache-2.0 */
/* Makes the manual: murk_manual PROSE OUT, where PROSE is the folder of the pages' own texts, and
   OUT that of man1, man5 and completions. A page without a text consists of what the tables say. */
#include "manual.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_SIZE = 4096 };

static FILE *open_or_exit(const char *path)
{
    FILE *file = fopen(path, "w");
    if (file)
        return file;
    perror(path);
    exit(2);
}

static void close_or_exit(FILE *file, const char *path)
{
    if (!ferror(file) && fclose(file) == 0)
        return;
    perror(path);
    exit(2);
}

/* Writes OUT/manN/PAGE.N from PROSE/PAGE.N; "" is the page of murk itself. */
static void make_page(const char *prose_folder, const char *out_folder, const char *name,
                      int section, const struct cli_command_info *command)
{
    char from[PATH_SIZE], to[PATH_SIZE];
    const char *dash = *name ? "-" : "";
    snprintf(from, sizeof from, "%s/murk%s%s.%d", prose_folder, dash, name, section);
    snprintf(to, sizeof to, "%s/man%d/murk%s%s.%d", out_folder, section, dash, name, section);
    FILE *prose = fopen(from, "r");
    FILE *stream = open_or_exit(to);
    if (command)
        manual_command(stream, prose, command);
    else if (section == 5)
        manual_format(stream, prose, name);
    else
        manual_program(stream, prose);
    close_or_exit(stream, to);
    if (prose)
        fclose(prose);
}

/* One page for each text of section 5. */
static void make_formats(const char *prose_folder, const char *out_folder)
{
    DIR *folder = opendir(prose_folder);
    if (!folder) {
        perror(prose_folder);
        exit(2);
    }
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[64];
        int end = 0;
        if (sscanf(entry->d_name, "murk-%63[a-z].5%n", name, &end) == 1 && end &&
            !entry->d_name[end])
            make_page(prose_folder, out_folder, name, 5, NULL);
    }
    closedir(folder);
}

int main(int argc, char **argv)
{
    char path[PATH_SIZE];
    size_t count;
    const struct cli_command_info *commands = cli_command_table(&count);
    if (argc != 3) {
        fprintf(stderr, "usage: murk_manual PROSE OUT\n");
        return 1;
    }
    make_page(argv[1], argv[2], "", 1, NULL);
    for (size_t i = 0; i < count; i++)
        make_page(argv[1], argv[2], commands[i].name, 1, &commands[i]);
    make_formats(argv[1], argv[2]);
    snprintf(path, sizeof path, "%s/completions/murk", argv[2]);
    FILE *stream = open_or_exit(path);
    manual_completion(stream);
    close_or_exit(stream, path);
    return 0;
}
