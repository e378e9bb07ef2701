/* SPDX-License-Identifier: Apache-2.0 */
#include "job.h"

#include "jobs.h"
#include "murk/memory.h"
#include "pattern.h"
#include "signals.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool cli_job_failed(murk_status status)
{
    return status != MURK_OK && status != MURK_NOT_REACHED;
}

int cli_exit_status(murk_status status)
{
    switch (status) {
    case MURK_OK:
        return 0;
    case MURK_ERROR_INPUT:
        return 1;
    case MURK_NOT_REACHED:
        return 3;
    default:
        return 2;
    }
}

murk_status cli_job_fail(struct cli_job *job, murk_status status)
{
    const char *message = murk_context_message(job->context);
    if (status == MURK_ERROR_MEMORY)
        cli_error(&job->terminal, "%s: %s (--max-memory)", job->options->input, message);
    else if (cli_job_failed(status))
        cli_error(&job->terminal, "%s", message);
    return status;
}

murk_status cli_job_start(struct cli_job *job, const struct cli_options *options,
                          const char *command, const char *command_line)
{
    *job = (struct cli_job){.options = options,
                            .command = command,
                            .command_line = command_line,
                            .started = cli_seconds()};
    cli_terminal_init(&job->terminal, options->quiet, options->verbose);
    cli_signals_catch(job->terminal.bar);
    murk_memory_limit(isnan(options->max_memory) ? murk_memory_machine()
                                                 : (uint64_t)options->max_memory);
    murk_context_options context = MURK_CONTEXT_DEFAULT;
    context.threads = cli_threads(options);
    context.kernel = options->kernel >= 0 ? CLI_KERNELS[options->kernel] : NULL;
    context.log = cli_terminal_log;
    context.progress = cli_terminal_progress;
    context.user = &job->terminal;
    murk_status status = murk_context_create(&context, &job->context);
    if (status == MURK_ERROR_INPUT)
        cli_error(&job->terminal, "--kernel %s: this processor does not have it", context.kernel);
    else if (status != MURK_OK)
        cli_error(&job->terminal, "%s", murk_status_text(status));
    return status;
}

/* What the command line says goes before what the scene says. */
static void apply_medium_options(const struct cli_options *options, const char *obscurant,
                                 struct scene_description *description)
{
    murk_medium_options *medium = &description->medium;
    if (options->grid)
        medium->extinction.grid = description->concentration.grid = options->grid;
    if (obscurant) {
        description->obscurant = obscurant;
        description->mass_extinction = NAN;
        description->albedo_named = description->asymmetry_named = false;
    }
    if (!isnan(options->scale)) {
        medium->extinction.scale = options->scale;
        medium->extinction.value = MURK_FROM_GRID;
        description->mass_extinction = NAN;
        description->obscurant = NULL;
    }
    if (!isnan(options->concentration)) {
        description->concentration.scale = options->concentration;
        description->has_concentration = true;
    }
    if (options->albedo) {
        char *end;
        double value = strtod(options->albedo, &end);
        bool number = *end == '\0';
        medium->albedo = (murk_quantity){number ? NULL : options->albedo, 1.0, number ? value : 0};
        description->albedo_named = true;
    }
    if (!isnan(options->voxel_size))
        medium->voxel_size = options->voxel_size;
    if (options->voxels >= 0)
        medium->corner = options->voxels == 1;
    if (options->up >= 0)
        description->up = options->up == 1 ? MURK_UP_Y : MURK_UP_Z;
    medium->strict |= options->strict;
}

static void apply_options(const struct cli_options *options, const char *obscurant,
                          struct scene_description *description)
{
    murk_camera *camera = &description->camera;
    apply_medium_options(options, obscurant, description);
    for (size_t n = 0; n < description->band_count; n++)
        apply_medium_options(options, obscurant, &description->band[n]);
    if (!isnan(options->eye[0]))
        memcpy(camera->eye, options->eye, sizeof camera->eye);
    if (!isnan(options->target[0]))
        memcpy(camera->target, options->target, sizeof camera->target);
    if (!isnan(options->fov))
        camera->fov = options->fov;
    if (options->size[0] > 0)
        memcpy(camera->size, options->size, sizeof camera->size);
    if (options->no_background)
        description->background = "none";
}

bool cli_has_extension(const char *path, const char *extension)
{
    size_t length = strlen(path), tail = strlen(extension);
    return length > tail && !strcasecmp(path + length - tail, extension);
}

/* Puts the frame's file where a scene names a pattern. */
static murk_status name_frame_files(struct cli_job *job)
{
    const char **files[SCENE_FILE_MAX];
    size_t count = scene_files(&job->description, files);
    for (size_t i = 0; i < count; i++) {
        if (!strcmp(*files[i], "-")) {
            cli_error(&job->terminal, "%s: a sequence reads files, not standard input",
                      job->options->input);
            return MURK_ERROR_INPUT;
        }
        char *path = scene_path(&job->description, *files[i]);
        bool pattern = path && cli_pattern_is_input(path);
        bool memory = path;
        free(path);
        if (pattern) {
            job->files[i] = cli_pattern_expand(*files[i], *job->frame);
            memory = job->files[i];
            *files[i] = job->files[i];
        }
        if (!memory) {
            cli_error(&job->terminal, "out of memory");
            return MURK_ERROR_MEMORY;
        }
    }
    return MURK_OK;
}

murk_status cli_job_describe(struct cli_job *job)
{
    const char *input = job->options->input;
    char message[SCENE_MESSAGE_SIZE] = "";
    murk_status status = MURK_OK;
    if (!strcmp(job->command, "contrast"))
        return MURK_OK;
    if (cli_has_extension(input, ".json"))
        status = scene_parse(input, &job->description, message);
    else
        scene_describe_volume(input, &job->description);
    if (status == MURK_OK && job->options->bands)
        status = scene_choose_bands(&job->description, job->options->bands, message);
    if (status == MURK_OK && job->options->obscurant && !job->obscurant &&
        !(job->obscurant = realpath(job->options->obscurant, NULL))) {
        snprintf(message, sizeof message, "--obscurant %s: cannot read: %s",
                 job->options->obscurant, strerror(errno));
        status = MURK_ERROR_INPUT;
    }
    if (status != MURK_OK)
        cli_error(&job->terminal, "%s", message);
    else
        apply_options(job->options, job->obscurant, &job->description);
    return status == MURK_OK && job->frame ? name_frame_files(job) : status;
}

/* What the scene says of a failure. */
static void tell(struct cli_job *job, murk_status status, const char *message)
{
    cli_error(&job->terminal, "%s%s", message,
              status == MURK_ERROR_MEMORY ? " (--max-memory)" : "");
}

murk_status cli_job_read(struct cli_job *job)
{
    char message[SCENE_MESSAGE_SIZE] = "";
    murk_status status = scene_read_volume(job->context, &job->description, &job->scene, message);
    if (status != MURK_OK)
        tell(job, status, message);
    job->seconds_read = cli_seconds() - job->started;
    return status;
}

static bool has_mass(const struct scene *scene)
{
    for (size_t n = 0; n < scene->band_count; n++)
        if (scene->band[n].mass_extinction > 0)
            return true;
    return false;
}

murk_status cli_job_build(struct cli_job *job)
{
    char message[SCENE_MESSAGE_SIZE] = "";
    double start = cli_seconds();
    murk_status status = scene_build(job->context, &job->description, &job->scene, message);
    if (status != MURK_OK) {
        tell(job, status, message);
    } else if (!isnan(job->options->concentration) && !has_mass(&job->scene)) {
        cli_error(&job->terminal, "--concentration: the scene has no mass extinction coefficients; "
                                  "--scale sets the extinction");
        status = MURK_ERROR_INPUT;
    } else if (job->options->ground_radiosity && !job->scene.band[0].ground) {
        cli_error(&job->terminal, "--ground-radiosity: the scene has no ground");
        status = MURK_ERROR_INPUT;
    }
    job->seconds_read += cli_seconds() - start;
    return status;
}

static void release_solutions(murk_solution *solution[SCENE_BANDS_MAX])
{
    for (size_t n = 0; n < SCENE_BANDS_MAX; n++) {
        murk_solution_release(solution[n]);
        solution[n] = NULL;
    }
}

murk_status cli_job_solve(struct cli_job *job)
{
    murk_solve_options options = job->options->solve;
    murk_scene scenes[SCENE_BANDS_MAX];
    if (!strcmp(job->command, "image") && !job->options->radiosity)
        options.camera = &job->scene.camera; /* nothing else will see the solution */
    for (size_t n = 0; n < job->scene.band_count; n++)
        scenes[n] = job->scene.band[n].scene;
    murk_status status =
        murk_solve_many(job->context, scenes, job->scene.band_count, &options, NULL, job->solution);
    cli_terminal_clear(&job->terminal);
    return cli_job_fail(job, status);
}

bool cli_job_chose_scale(const struct cli_job *job, murk_medium_info *info)
{
    const struct scene_description *first =
        job->description.band_count ? job->description.band : &job->description;
    const struct scene_band *band = &job->scene.band[0];
    return first->medium.extinction.scale == 0.0 && !(band->mass_extinction > 0.0) &&
           murk_medium_info_get(band->medium, info) == MURK_OK && info->extinction_scale > 0.0;
}

const murk_report *cli_job_report(const struct cli_job *job)
{
    const murk_report *worst = NULL;
    for (size_t n = 0; n < SCENE_BANDS_MAX && job->solution[n]; n++) {
        const murk_report *report = murk_solution_report(job->solution[n]);
        if (!worst || report->estimate > worst->estimate)
            worst = report;
    }
    return worst;
}

size_t cli_job_views(const struct cli_job *job, murk_band_view view[SCENE_BANDS_MAX])
{
    const struct scene *scene = &job->scene;
    for (size_t n = 0; n < scene->band_count; n++) {
        const struct scene_band *band = &scene->band[n];
        view[n] = (murk_band_view){.name = band->name,
                                   .band = band->band,
                                   .mass_extinction = band->mass_extinction,
                                   .scene = &band->scene,
                                   .solution = job->solution[n]};
    }
    return scene->band[0].name ? scene->band_count : 0;
}

static murk_status render(struct cli_job *job, const murk_render_options *options)
{
    const struct scene *scene = &job->scene;
    murk_band_view view[SCENE_BANDS_MAX];
    const size_t count = cli_job_views(job, view);
    murk_status status =
        count ? murk_render_bands(job->context, view, count, &scene->camera, options, &job->picture)
              : murk_render(job->context, &scene->band[0].scene, job->solution[0], &scene->camera,
                            options, &job->picture);
    if (status == MURK_OK && job->options->deep)
        status = murk_render_deep(job->context, view, scene->band_count, &scene->camera, options,
                                  &job->deep);
    return status;
}

murk_status cli_job_render(struct cli_job *job)
{
    double start = cli_seconds();
    murk_render_options options = MURK_RENDER_DEFAULT;
    options.samples = job->options->samples;
    options.no_background = job->scene.no_background;
    options.background = job->scene.background;
    murk_status status = render(job, &options);
    cli_terminal_clear(&job->terminal);
    job->seconds_render = cli_seconds() - start;
    return cli_job_fail(job, status);
}

void cli_job_next(struct cli_job *job)
{
    murk_image_release(job->picture);
    murk_deep_release(job->deep);
    release_solutions(job->solution);
    job->picture = NULL;
    job->deep = NULL;
    scene_release(&job->scene);
    scene_description_release(&job->description);
    for (int i = 0; i < SCENE_FILE_MAX; i++) {
        free(job->files[i]);
        job->files[i] = NULL;
    }
    job->seconds_read = job->seconds_render = job->seconds_write = 0.0;
    job->started = cli_seconds();
}

int cli_job_end(struct cli_job *job, murk_status status)
{
    cli_terminal_clear(&job->terminal);
    cli_job_next(job);
    murk_context_release(job->context);
    free(job->obscurant);
    return cli_exit_status(status);
}
