/* SPDX-License-Identifier: Apache-2.0 */
#include "plan.h"

#include "paths.h"
#include "pattern.h"

#include <stdlib.h>
#include <string.h>

static murk_status out_of_memory(struct cli_job *job)
{
    cli_error(&job->terminal, "out of memory");
    return MURK_ERROR_MEMORY;
}

/* The first pattern of the scene's files, from malloc; NULL where there is none. */
static murk_status scene_pattern(struct cli_job *job, char **out)
{
    const char **files[SCENE_FILE_MAX];
    murk_status status = cli_job_describe(job);
    size_t count = status == MURK_OK ? scene_files(&job->description, files) : 0;
    *out = NULL;
    for (size_t i = 0; i < count && !*out; i++) {
        char *path = scene_path(&job->description, *files[i]);
        if (!path)
            return out_of_memory(job);
        if (cli_pattern_is_input(path))
            *out = path;
        else
            free(path);
    }
    return status;
}

/* The pattern that says which frames there are, from malloc; NULL where there is none. */
static murk_status input_pattern(struct cli_job *job, char **out)
{
    const struct cli_options *options = job->options;
    const char *given = NULL;
    murk_status status = MURK_OK;
    *out = NULL;
    if (cli_pattern_is_input(options->input))
        given = options->input;
    else
        status = scene_pattern(job, out);
    if (status == MURK_OK && !given && !*out && !strcmp(job->command, "render") &&
        cli_pattern_is_input(options->radiosity))
        given = options->radiosity;
    if (given) {
        *out = strdup(given);
        status = *out ? MURK_OK : out_of_memory(job);
    }
    return status;
}

static murk_status usage_error(struct cli_job *job, const char *option, const char *value,
                               const char *text)
{
    cli_error(&job->terminal, "%s%s%s: %s", option, *value ? " " : "", value, text);
    return MURK_ERROR_INPUT;
}

/* Whether the paths are those of a sequence, whose first input pattern is given. */
static murk_status check_paths(struct cli_job *job, const char *pattern)
{
    struct cli_options options = *job->options;
    struct cli_path list[CLI_PATH_MAX];
    size_t count = cli_paths(&options, job->command, list);
    for (size_t i = 0; i < count; i++)
        if (!strcmp(*list[i].text, "-"))
            return usage_error(job, list[i].option, "-",
                               "a sequence has no streams; name files with a pattern such as ####");
    if (!pattern)
        return usage_error(job, options.frames ? "--frames" : "--resume", "",
                           "is for sequences, but no input is one; name it with a pattern such as "
                           "plume.####.vdb");
    for (size_t i = 0; i < count; i++)
        if (!list[i].input && !cli_pattern_has(*list[i].text))
            return usage_error(job, list[i].option, *list[i].text,
                               "frames would overwrite one another; put a pattern such as #### "
                               "into the name");
    return MURK_OK;
}

static murk_status parse_frames(struct cli_job *job, struct cli_frames *out)
{
    murk_status status = cli_frames_parse(job->options->frames, out);
    if (status == MURK_ERROR_MEMORY)
        return out_of_memory(job);
    if (status != MURK_OK)
        cli_error(&job->terminal,
                  "--frames %s: is not a list of at most %d frames such as 1-100, 1-100x2 or "
                  "1,3,10-20",
                  job->options->frames, CLI_FRAME_COUNT_MAX);
    return status;
}

static murk_status find_frames(struct cli_job *job, const char *pattern, struct cli_frames *out)
{
    enum { LIST_SIZE = 1000 };
    struct cli_frames frames;
    char text[LIST_SIZE];
    if (cli_pattern_find(pattern, &frames) != MURK_OK)
        return out_of_memory(job);
    if (frames.count == 0) {
        cli_error(&job->terminal, "%s: there is no file of this pattern", pattern);
        return MURK_ERROR_INPUT;
    }
    cli_frames_text(&frames, text, sizeof text);
    cli_say(&job->terminal, "%s: found %zu: %s", pattern, frames.count, text);
    *out = frames;
    return MURK_OK;
}

murk_status cli_plan(struct cli_job *job, struct cli_frames *out)
{
    const struct cli_options *options = job->options;
    char *pattern;
    murk_status status = input_pattern(job, &pattern);
    if (status == MURK_OK && (pattern || options->frames || options->resume))
        status = check_paths(job, pattern);
    if (status == MURK_OK && pattern)
        status = options->frames ? parse_frames(job, out) : find_frames(job, pattern, out);
    free(pattern);
    return status;
}
