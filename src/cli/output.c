/* SPDX-License-Identifier: Apache-2.0 */
#include "output.h"

#include "show.h"
#include "usd.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum output_kind { PICTURE, DEEP, RADIOSITY, GROUND, STAGE };

struct output {
    const char *option; /* "--preview" */
    const char *path;   /* NULL: not asked for */
    enum output_kind kind;
};

static const char PICTURE_UNITS[] = "W/m^2/sr, Z in m";

enum { OUTPUT_COUNT = 6 };

/* The radiosity VDB that the run writes, or NULL. */
static const char *radiosity_path(const struct cli_job *job)
{
    if (!strcmp(job->command, "solve"))
        return job->options->output;
    return strcmp(job->command, "image") ? NULL : job->options->radiosity;
}

/* In the order of writing: what took longest first, the pictures last. */
static void list_outputs(const struct cli_job *job, struct output list[OUTPUT_COUNT])
{
    const struct cli_options *options = job->options;
    bool solve = !strcmp(job->command, "solve"), image = !strcmp(job->command, "image");
    list[0] = (struct output){"--radiosity", image ? options->radiosity : NULL, RADIOSITY};
    list[1] = (struct output){"--ground-radiosity", options->ground_radiosity, GROUND};
    list[2] = (struct output){"-o", options->output, solve ? RADIOSITY : PICTURE};
    list[3] = (struct output){"--deep", options->deep, DEEP};
    list[4] = (struct output){"--preview", options->preview, PICTURE};
    list[5] = (struct output){"--usd", options->usd, STAGE};
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
    if (output->kind == DEEP && !cli_has_extension(output->path, ".exr"))
        return usage_error(job, output, "is not an .exr file; deep pictures are written as EXR");
    return MURK_OK;
}

static murk_status check_stage(struct cli_job *job, const struct output *output)
{
    const char *vdb = radiosity_path(job);
    if (!cli_has_extension(output->path, ".usda"))
        return usage_error(job, output, "is not a .usda file; the stage is written as text");
    if (!vdb || !strcmp(vdb, "-"))
        return usage_error(job, output,
                           strcmp(job->command, "solve")
                               ? "a stage refers to a radiosity file; name it with --radiosity"
                               : "a stage refers to a radiosity file; name it with -o");
    return cli_job_fail(job, murk_file_check(job->context, output->path));
}

static murk_status check_output(struct cli_job *job, const struct output *output)
{
    switch (output->kind) {
    case RADIOSITY:
        return check_radiosity(job, output);
    case STAGE:
        return check_stage(job, output);
    default:
        return check_image(job, output);
    }
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
        murk_status status = check_output(job, &list[i]);
        for (int j = 0; j < i && status == MURK_OK; j++)
            if (list[j].path && !strcmp(list[i].path, list[j].path))
                status = usage_error(job, &list[i], "is the same file as another output");
        if (status == MURK_OK && list[i].kind != STAGE)
            status = cli_job_fail(job, murk_output_check(job->context, list[i].path));
        if (status != MURK_OK)
            return status;
    }
    return cli_show_check(job);
}

static murk_status write_image(struct cli_job *job, const murk_image *image, const char *path,
                               double exposure, const char *units)
{
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = exposure;
    options.command = job->command_line;
    options.units = units;
    return murk_image_write(job->context, image, path, &options);
}

murk_status cli_output_radiosity(struct cli_job *job, const char *const names[], size_t count,
                                 const char *path)
{
    murk_write_options options = MURK_WRITE_DEFAULT;
    options.source = job->scene.volume;
    options.emission_coefficient = job->options->emission_coefficient;
    options.extinction = job->options->extinction_grid;
    options.albedo = job->options->albedo_grid;
    options.half = job->options->half;
    options.command = job->command_line;
    return murk_solutions_write((const murk_solution *const *)job->solution, names, count, path,
                                &options);
}

static murk_status write_radiosity(struct cli_job *job, const char *path)
{
    const char *names[SCENE_BANDS_MAX];
    for (size_t n = 0; n < job->scene.band_count; n++)
        names[n] = job->scene.band[n].name;
    return cli_output_radiosity(job, names, job->scene.band_count, path);
}

/* One channel a band, by its name, or Y. */
static murk_status write_ground(struct cli_job *job, const char *path)
{
    const char *names[SCENE_BANDS_MAX];
    const int count = (int)job->scene.band_count;
    murk_image *image = NULL;
    int size[2];
    murk_ground_patches(job->scene.band[0].ground, size);
    for (int n = 0; n < count; n++)
        names[n] = job->scene.band[n].name ? job->scene.band[n].name : "Y";
    murk_status status = murk_image_create(job->context, size[0], size[1], count, names, &image);
    float *one = malloc(sizeof *one * (size_t)size[0] * (size_t)size[1]);
    if (!one)
        status = MURK_ERROR_MEMORY;
    for (int n = 0; n < count && status == MURK_OK; n++) {
        status = murk_solution_ground(job->solution[n], one);
        for (int i = 0; i < size[0] * size[1] && status == MURK_OK; i++)
            murk_image_pixels(image)[i * count + n] = one[i];
    }
    free(one);
    if (status == MURK_OK)
        status = write_image(job, image, path, job->options->exposure, "W/m^2");
    murk_image_release(image);
    return status;
}

/* shown: what the option --show asks for, or NULL. */
static murk_status write_picture(struct cli_job *job, const murk_image *shown, const char *path)
{
    if (cli_show_wanted(job, path))
        return write_image(job, shown, path, 0, NULL);
    return write_image(job, job->picture, path, job->options->exposure, PICTURE_UNITS);
}

static murk_status write_deep(struct cli_job *job, const char *path)
{
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.command = job->command_line;
    options.units = PICTURE_UNITS;
    return murk_deep_write(job->context, job->deep, path, &options);
}

static murk_status write_output(struct cli_job *job, const murk_image *shown,
                                const struct output *output)
{
    switch (output->kind) {
    case RADIOSITY:
        return write_radiosity(job, output->path);
    case GROUND:
        return write_ground(job, output->path);
    case STAGE:
        return cli_usd_write(job, output->path, radiosity_path(job));
    case DEEP:
        return write_deep(job, output->path);
    default:
        return write_picture(job, shown, output->path);
    }
}

murk_status cli_output_write(struct cli_job *job)
{
    struct output list[OUTPUT_COUNT];
    double start = cli_seconds();
    murk_image *shown = NULL;
    murk_status status = cli_show_make(job, &shown);
    int written = 0;
    list_outputs(job, list);
    for (int i = 0; i < OUTPUT_COUNT && status == MURK_OK; i++)
        if (list[i].path) {
            status = cli_job_fail(job, write_output(job, shown, &list[i]));
            written += status == MURK_OK;
        }
    for (int i = 0; status != MURK_OK && i < OUTPUT_COUNT && written > 0; i++)
        if (list[i].path && strcmp(list[i].path, "-")) {
            cli_say(&job->terminal, "%s is complete", list[i].path);
            written--;
        }
    murk_image_release(shown);
    job->seconds_write = cli_seconds() - start;
    return status;
}
