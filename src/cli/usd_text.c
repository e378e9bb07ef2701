/* SPDX-License-Identifier: Apache-2.0 */
#include "usd_text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void cli_usd_quote(FILE *stream, const char *text)
{
    fputc('"', stream);
    for (const char *c = text; *c; c++) {
        if (*c == '\n')
            fputs("\\n", stream);
        else if (*c == '"' || *c == '\\')
            fprintf(stream, "\\%c", *c);
        else
            fputc(*c, stream);
    }
    fputc('"', stream);
}

void cli_usd_identifier(FILE *stream, const char *text)
{
    if (!*text || isdigit((unsigned char)*text))
        fputc('_', stream);
    for (const char *c = text; *c; c++)
        fputc(isalnum((unsigned char)*c) ? *c : '_', stream);
}

void cli_usd_vector(FILE *stream, const double vector[3])
{
    fprintf(stream, "(%.9g, %.9g, %.9g)", vector[0], vector[1], vector[2]);
}

void cli_usd_transform(FILE *stream, const double axes[3][3], const double origin[3])
{
    fputs("        matrix4d xformOp:transform = ( ", stream);
    for (int a = 0; a < 3; a++)
        fprintf(stream, "(%.9g, %.9g, %.9g, 0), ", axes[a][0], axes[a][1], axes[a][2]);
    fprintf(stream, "(%.9g, %.9g, %.9g, 1) )\n", origin[0], origin[1], origin[2]);
    fputs("        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n", stream);
}

/* The folder of a file without links, ending in '/', from malloc. */
static char *real_folder(const char *file)
{
    const char *slash = strrchr(file, '/');
    char *folder = slash ? strndup(file, (size_t)(slash - file) + 1) : strdup(".");
    char *real = folder ? realpath(folder, NULL) : NULL;
    char *out = real ? malloc(strlen(real) + 2) : NULL;
    if (out)
        stpcpy(stpcpy(out, real), strcmp(real, "/") ? "/" : "");
    free(folder);
    free(real);
    return out;
}

char *cli_usd_relative(const char *file, const char *from)
{
    const char *slash = strrchr(file, '/');
    const char *name = slash ? slash + 1 : file;
    char *to = real_folder(file), *start = real_folder(from), *out = NULL;
    if (to && start) {
        size_t shared = 0, up = 0;
        for (size_t i = 0; to[i] && to[i] == start[i]; i++)
            if (to[i] == '/')
                shared = i + 1;
        for (const char *c = start + shared; *c; c++)
            up += *c == '/';
        out = malloc(3 + 3 * up + strlen(to + shared) + strlen(name));
        char *end = out ? stpcpy(out, up ? "" : "./") : NULL;
        for (size_t i = 0; i < up && end; i++)
            end = stpcpy(end, "../");
        if (end)
            stpcpy(stpcpy(end, to + shared), name);
    }
    free(to);
    free(start);
    return out;
}
