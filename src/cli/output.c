/* SPDX-License-Identifier: Apache-2.0 */
#include "output.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum output_kind { PICTURE, RADIOSITY, GROUND };

struct output {
    const char *option; /* "--preview" */
    const char *path;   /* NULL: not asked for */
    enum output_kind kind;
};

enum { OUTPUT_COUNT = 4 };

/* In the order of writing: what took longest first, the pictures last. */
static void list_outputs(const struct cli_job *job, struct output list[OUTPUT_COUNT])
{
    const struct cli_options *options = job->options;
    bool solve = !strcmp(job->command, "solve"), image = !strcmp(job->command, "image");
    list[0] = (struct output){"--radiosity", image ? options->radiosity : NULL, RADIOSITY};
    list[1] = (struct output){"--ground-radiosity", options->ground_radiosity, GROUND};
    list[2] = (struct output){"-o", options->output, solve ? RADIOSITY : PICTURE};
    list[3] = (struct output){"--preview", options->preview, PICTURE};
}

static murk_status usage_error(struct cli_job *job, const struct output *output, const char *text)
{
    cli_error(&job->terminal, "%s %s: %s", output->option, output->path, text);
    return MURK_ERROR_INPUT;
}

static murk_status check_radiosity(struct cli_job *job, const struct output *output)
{
    if (strcmp(output->path, "-"))
        return cli_has_extension(output->path, ".vdb")
                   ? MURK_OK
                   : usage_error(job, output,
                                 "is not a .vdb file; the radiosity is written as VDB");
    if (job->options->json)
        return usage_error(job, output, "standard output cannot take both a VDB and --json");
    if (isatty(STDOUT_FILENO))
        return usage_error(job, output, "a VDB stream will not go to a terminal; redirect it");
    return MURK_OK;
}

static murk_status check_image(struct cli_job *job, const struct output *output)
{
    if (!strcmp(output->path, "-"))
        return usage_error(job, output, "an image cannot go to standard output; name a file");
    if (cli_has_extension(output->path, ".vdb"))
        return usage_error(job, output, "is a VDB, not an image; name an .exr file");
    return MURK_OK;
}

murk_status cli_output_check(struct cli_job *job)
{
    struct output list[OUTPUT_COUNT];
    list_outputs(job, list);
    if (!job->options->output) {
        cli_error(&job->terminal, "%s: needs an output: -o FILE%s", job->command,
                  list[2].kind == RADIOSITY ? ".vdb" : ".exr");
        return MURK_ERROR_INPUT;
    }
    for (int i = 0; i < OUTPUT_COUNT; i++) {
        if (!list[i].path)
            continue;
        murk_status status =
            list[i].kind == RADIOSITY ? check_radiosity(job, &list[i]) : check_image(job, &list[i]);
        for (int j = 0; j < i && status == MURK_OK; j++)
            if (list[j].path && !strcmp(list[i].path, list[j].path))
                status = usage_error(job, &list[i], "is the same file as another output");
        if (status == MURK_OK)
            status = cli_job_fail(job, murk_output_check(job->context, list[i].path));
        if (status != MURK_OK)
            return status;
    }
    return MURK_OK;
}

static murk_status write_image(struct cli_job *job, const murk_image *image, const char *path,
                               const char *units)
{
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = job->options->exposure;
    options.command = job->command_line;
    options.units = units;
    return murk_image_write(job->context, image, path, &options);
}

static murk_status write_radiosity(struct cli_job *job, const char *path)
{
    murk_write_options options = MURK_WRITE_DEFAULT;
    options.source = job->scene.volume;
    options.emission_coefficient = job->options->emission_coefficient;
    options.extinction = job->options->extinction_grid;
    options.albedo = job->options->albedo_grid;
    options.half = job->options->half;
    options.command = job->command_line;
    return murk_solution_write(job->solution[0], path, &options);
}

static murk_status write_ground(struct cli_job *job, const char *path)
{
    static const char *const NAMES[] = {"Y"};
    murk_image *image = NULL;
    int size[2];
    murk_ground_patches(job->scene.band[0].ground, size);
    murk_status status = murk_image_create(job->context, size[0], size[1], 1, NAMES, &image);
    if (status == MURK_OK)
        status = murk_solution_ground(job->solution[0], murk_image_pixels(image));
    if (status == MURK_OK)
        status = write_image(job, image, path, "W/m^2");
    murk_image_release(image);
    return status;
}

static murk_status write_output(struct cli_job *job, const struct output *output)
{
    switch (output->kind) {
    case RADIOSITY:
        return write_radiosity(job, output->path);
    case GROUND:
        return write_ground(job, output->path);
    default:
        return write_image(job, job->picture, output->path, "W/m^2/sr, Z in m");
    }
}

murk_status cli_output_write(struct cli_job *job)
{
    struct output list[OUTPUT_COUNT];
    double start = cli_seconds();
    murk_status status = MURK_OK;
    int written = 0;
    list_outputs(job, list);
    for (int i = 0; i < OUTPUT_COUNT && status == MURK_OK; i++)
        if (list[i].path) {
            status = cli_job_fail(job, write_output(job, &list[i]));
            written += status == MURK_OK;
        }
    for (int i = 0; status != MURK_OK && i < OUTPUT_COUNT && written > 0; i++)
        if (list[i].path && strcmp(list[i].path, "-")) {
            cli_say(&job->terminal, "%s is complete", list[i].path);
            written--;
        }
    job->seconds_write = cli_seconds() - start;
    return status;
}
