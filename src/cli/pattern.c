/* SPDX-License-Identifier: Apache-2.0 */
#include "pattern.h"

#include <ctype.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* One digit, or none, of a width at *text, which is moved behind it. */
static int digit_at(const char **text)
{
    return isdigit((unsigned char)**text) ? *(*text)++ - '0' : 0;
}

/* The length of a place for the frame at the start of text, and its least number of digits; 0
   where there is none. */
static size_t place_at(const char *text, int *digits)
{
    const char *end = text;
    if (*text == '#') {
        *digits = (int)strspn(text, "#");
        return (size_t)*digits;
    }
    if (text[0] == '%') {
        end += text[1] == '0' ? 2 : 1;
        *digits = text[1] == '0' ? digit_at(&end) : 0;
        return *end == 'd' ? (size_t)(end - text) + 1 : 0;
    }
    if (text[0] == '$' && text[1] == 'F') {
        end += 2;
        *digits = digit_at(&end);
        return isalnum((unsigned char)*end) ? 0 : (size_t)(end - text);
    }
    return 0;
}

/* The length of the folder at the start of a path that is there under just this name. */
static size_t literal_part(const char *path)
{
    char *folder = strdup(path), *slash = folder;
    size_t length = 0;
    while (folder && !length && (slash = strrchr(folder, '/'))) {
        *slash = '\0';
        length = !access(folder, F_OK) ? (size_t)(slash - folder) : 0;
    }
    free(folder);
    return length;
}

/* Where the first place begins; at the end of the path where it has none. */
static size_t first_place(const char *path)
{
    size_t at = literal_part(path);
    int digits;
    while (path[at] && !place_at(path + at, &digits))
        at++;
    return at;
}

bool cli_pattern_has(const char *path)
{
    return path[first_place(path)] != '\0';
}

bool cli_pattern_is_input(const char *path)
{
    return cli_pattern_has(path) && access(path, F_OK) != 0;
}

char *cli_pattern_expand(const char *path, int frame)
{
    char *expanded = NULL;
    size_t size, literal = literal_part(path);
    FILE *stream = open_memstream(&expanded, &size);
    if (!stream)
        return NULL;
    fwrite(path, 1, literal, stream);
    path += literal;
    while (*path) {
        int digits;
        size_t length = place_at(path, &digits);
        if (length)
            fprintf(stream, "%0*d", digits, frame);
        else
            fputc(*path, stream);
        path += length ? length : 1;
    }
    if (fclose(stream) == 0)
        return expanded;
    free(expanded);
    return NULL;
}

/* A pattern for glob() that finds every frame, and more; from malloc. */
static char *wildcard(const char *path)
{
    char *result = malloc(2 * strlen(path) + 1), *end = result;
    const char *places = path + literal_part(path);
    if (!result)
        return NULL;
    while (*path) {
        int digits;
        size_t length = path < places ? 0 : place_at(path, &digits);
        if (!length && strchr("*?[]\\", *path))
            *end++ = '\\';
        *end++ = length ? '*' : *path;
        path += length ? length : 1;
    }
    *end = '\0';
    return result;
}

/* Adds the frame of a path that glob() found, if it is the pattern's path of that frame. */
static murk_status add_found(const char *path, const char *found, struct cli_frames *frames)
{
    const char *digits = found + first_place(path);
    int frame;
    if (!cli_frame_read(&digits, &frame))
        return MURK_OK;
    char *expected = cli_pattern_expand(path, frame);
    if (!expected)
        return MURK_ERROR_MEMORY;
    bool same = !strcmp(expected, found);
    free(expected);
    return same ? cli_frames_add(frames, frame) : MURK_OK;
}

murk_status cli_pattern_find(const char *path, struct cli_frames *out)
{
    struct cli_frames frames = {0};
    glob_t found = {0};
    char *pattern = wildcard(path);
    int failed = pattern ? glob(pattern, GLOB_NOSORT, NULL, &found) : GLOB_NOSPACE;
    murk_status status = failed == GLOB_NOSPACE ? MURK_ERROR_MEMORY : MURK_OK;
    for (size_t i = 0; !failed && status == MURK_OK && i < found.gl_pathc; i++)
        status = add_found(path, found.gl_pathv[i], &frames);
    globfree(&found);
    free(pattern);
    if (status == MURK_OK) {
        cli_frames_sort(&frames);
        *out = frames;
    } else {
        cli_frames_release(&frames);
    }
    return status;
}
