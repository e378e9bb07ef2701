/* SPDX-License-Identifier: Apache-2.0 */
#include "contrast.h"

#include "contrast_region.h"
#include "sequence.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static murk_status usage_error(struct cli_job *job, const char *option, const char *value,
                               const char *text)
{
    cli_error(&job->terminal, "%s %s: %s", option, value, text);
    return MURK_ERROR_INPUT;
}

static murk_status out_of_memory(struct cli_job *job)
{
    cli_error(&job->terminal, "out of memory");
    return MURK_ERROR_MEMORY;
}

/* ---- before all work ----------------------------------------------------------------------- */

static murk_status check_table(struct cli_job *job)
{
    const char *path = job->options->output;
    if (!path)
        return MURK_OK;
    if (!cli_has_extension(path, ".csv"))
        return usage_error(job, "-o", path,
                           "is not a .csv file; without -o the table goes to standard output");
    return cli_job_fail(job, murk_file_check(job->context, path));
}

static murk_status check_plot(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    const char *path = options->plot;
    if (!path && options->against >= 0)
        return usage_error(job, "--against", CLI_AGAINST[options->against],
                           "is for curves; name their file with --plot");
    if (!path)
        return MURK_OK;
    if (!job->frame)
        return usage_error(
            job, "--plot", path,
            "is for sequences; name the picture with a pattern such as pic.####.exr");
    if (!strcmp(path, "-") || cli_has_extension(path, ".vdb") || cli_has_extension(path, ".exr"))
        return usage_error(job, "--plot", path, "the curves are to be looked at; name a .png file");
    return cli_job_fail(job, murk_output_check(job->context, path));
}

static murk_status check(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    if (!options->target_region || !options->background_region) {
        cli_error(&job->terminal,
                  "contrast: needs %s REGION: a rectangle such as 100,120,40x30, or a mask",
                  options->target_region ? "--background" : "--target");
        return MURK_ERROR_INPUT;
    }
    murk_status status = check_table(job);
    return status == MURK_OK ? check_plot(job) : status;
}

/* ---- a picture ----------------------------------------------------------------------------- */

/* What is wrong with a picture that could be read. */
static murk_status fail_picture(struct cli_job *job, murk_status status)
{
    if (status != MURK_OK)
        cli_error(&job->terminal, "%s: %s", job->options->input,
                  murk_context_message(job->context));
    return status;
}

static murk_status no_such_band(struct cli_job *job, const char *name,
                                const murk_picture_band *bands, size_t count)
{
    char list[512] = "";
    size_t used = 0;
    for (size_t i = 0; i < count && used < sizeof list; i++)
        used +=
            (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", bands[i].name);
    cli_error(&job->terminal, "--bands: %s has no band %s, but %s", job->options->input, name,
              list);
    return MURK_ERROR_INPUT;
}

/* Puts those of the list "R,LWIR" first, in its order; *count becomes their number. */
static murk_status choose_bands(struct cli_job *job, murk_picture_band *bands, size_t *count)
{
    char *names = strdup(job->options->bands), *rest = NULL;
    murk_status status = names ? MURK_OK : out_of_memory(job);
    size_t kept = 0;
    for (char *name = names ? strtok_r(names, ",", &rest) : NULL; name && status == MURK_OK;
         name = strtok_r(NULL, ",", &rest)) {
        size_t at = kept;
        while (at < *count && strcmp(bands[at].name, name))
            at++;
        if (at == *count) {
            status = no_such_band(job, name, bands, *count);
        } else {
            murk_picture_band found = bands[at];
            bands[at] = bands[kept];
            bands[kept++] = found;
        }
    }
    if (status == MURK_OK && !kept)
        status = no_such_band(job, "", bands, *count);
    free(names);
    *count = kept;
    return status;
}

/* The bands of the picture that are asked for, from malloc. */
static murk_status find_bands(struct cli_job *job, const murk_image *picture,
                              murk_picture_band **out, size_t *count)
{
    size_t all;
    murk_status status =
        fail_picture(job, murk_picture_bands(job->context, picture, 0, NULL, &all));
    if (status != MURK_OK)
        return status;
    murk_picture_band *bands = malloc(all * sizeof *bands);
    if (!bands)
        return out_of_memory(job);
    status = fail_picture(job, murk_picture_bands(job->context, picture, all, bands, &all));
    if (status == MURK_OK && job->options->bands)
        status = choose_bands(job, bands, &all);
    if (status != MURK_OK) {
        free(bands);
        return status;
    }
    *out = bands;
    *count = all;
    return MURK_OK;
}

/* Room for count more rows behind those there are; NULL when memory runs out. */
static struct cli_contrast_row *make_room(struct cli_contrast *contrast, size_t count)
{
    struct cli_contrast_row *row =
        realloc(contrast->row, (contrast->count + count) * sizeof *contrast->row);
    if (!row)
        return NULL;
    contrast->row = row;
    return memset(row + contrast->count, 0, count * sizeof *row);
}

/* Adds a row for each band, all of them or none. */
static murk_status add_rows(struct cli_job *job, const murk_image *picture,
                            const murk_picture_band *bands, size_t count,
                            const struct cli_region *target, const struct cli_region *background)
{
    struct cli_contrast *contrast = job->state;
    struct cli_contrast_row *row = make_room(contrast, count);
    const murk_sensor sensor = {job->options->netd, job->options->snr};
    murk_status status = row ? MURK_OK : out_of_memory(job);
    for (size_t i = 0; i < count && status == MURK_OK; i++) {
        row[i].has_frame = job->frame;
        row[i].frame = job->frame ? *job->frame : 0;
        row[i].band = bands[i];
        status = fail_picture(job, murk_contrast_measure(job->context, picture, &bands[i],
                                                         &target->region, &background->region,
                                                         &sensor, &row[i].contrast));
    }
    if (status != MURK_OK)
        return status;
    contrast->count += count;
    if (job->options->json)
        cli_contrast_json(job, row, count);
    return MURK_OK;
}

static murk_status measure(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    struct cli_region target = {0}, background = {0};
    murk_picture_band *bands = NULL;
    size_t count = 0;
    murk_status status =
        cli_job_fail(job, murk_image_read(job->context, options->input, &job->picture));
    if (status == MURK_OK)
        status = find_bands(job, job->picture, &bands, &count);
    if (status == MURK_OK)
        status = cli_region_read(job, "--target", options->target_region, &target);
    if (status == MURK_OK)
        status = cli_region_read(job, "--background", options->background_region, &background);
    if (status == MURK_OK)
        status = add_rows(job, job->picture, bands, count, &target, &background);
    cli_region_release(&target);
    cli_region_release(&background);
    free(bands);
    return status;
}

/* ---- after all of them --------------------------------------------------------------------- */

static murk_status write_table(struct cli_job *job)
{
    const struct cli_contrast *contrast = job->state;
    const char *path = job->options->output;
    murk_status status = MURK_OK;
    char *text = cli_contrast_table(contrast);
    if (!text)
        return out_of_memory(job);
    if (path)
        status = cli_job_fail(job, murk_file_write(job->context, path, text, strlen(text)));
    else
        fputs(text, stdout); /* main() tells about errors */
    free(text);
    if (path && status == MURK_OK)
        cli_say(&job->terminal, "table in %s", path);
    return status;
}

static murk_status finish(struct cli_job *job)
{
    const struct cli_contrast *contrast = job->state;
    murk_status status = MURK_OK;
    if (contrast->count == 0)
        return MURK_OK;
    if (job->options->output || !job->options->json)
        status = write_table(job);
    if (status == MURK_OK && job->options->plot)
        status = cli_contrast_plot(job, contrast);
    return status;
}

int cli_contrast(const struct cli_options *options, const char *command_line)
{
    struct cli_contrast contrast = {0};
    const struct cli_steps steps = {
        .check = check, .work = measure, .finish = finish, .state = &contrast};
    int exit_status = cli_run(options, "contrast", command_line, &steps);
    free(contrast.row);
    return exit_status;
}
