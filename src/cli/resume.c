/* SPDX-License-Identifier: Apache-2.0 */
#include "resume.h"

#include "paths.h"
#include "recorded.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool is_later(const struct timespec *a, const struct timespec *b)
{
    return a->tv_sec > b->tv_sec || (a->tv_sec == b->tv_sec && a->tv_nsec > b->tv_nsec);
}

/* Moves *newest on to when a file was written; false where there is none. */
static bool take_input(const char *path, struct timespec *newest)
{
    struct stat info;
    if (!path || stat(path, &info))
        return false;
    if (is_later(&info.st_mtim, newest))
        *newest = info.st_mtim;
    return true;
}

static bool take_scene_files(struct cli_job *job, struct timespec *newest)
{
    const char **files[SCENE_FILE_MAX];
    size_t count = scene_files(&job->description, files);
    bool found = true;
    for (size_t i = 0; i < count && found; i++) {
        char *path = scene_path(&job->description, *files[i]);
        found = take_input(path, newest);
        free(path);
    }
    return found;
}

/* Whether the command that is running made an output; it asks each file that can tell. */
static bool made_by_this(struct cli_job *job, const char *path)
{
    char *line = malloc(CLI_RECORD_SIZE);
    if (!line)
        return false;
    cli_recorded(job->context, path, line);
    bool same = cli_recorded_same(line, job->command_line);
    if (!same && job->options->verbose)
        cli_say(&job->terminal, "%s: %s%s; made again", path,
                *line ? "was made by another command: " : "does not tell the command that made it",
                line);
    free(line);
    return same;
}

bool cli_resume_done(struct cli_job *job)
{
    struct cli_options options = *job->options;
    struct cli_path list[CLI_PATH_MAX];
    struct timespec newest = {0};
    size_t count = cli_paths(&options, job->command, list);
    for (size_t i = 0; i < count; i++)
        if (list[i].input && !take_input(*list[i].text, &newest))
            return false;
    if (!take_scene_files(job, &newest))
        return false;
    for (size_t i = 0; i < count; i++) {
        struct stat info;
        if (!list[i].input && (stat(*list[i].text, &info) || !is_later(&info.st_mtim, &newest)))
            return false;
    }
    for (size_t i = 0; i < count; i++)
        if (!list[i].input && !made_by_this(job, *list[i].text))
            return false;
    return true;
}
