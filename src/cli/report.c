/* SPDX-License-Identifier: Apache-2.0 */
#include "report.h"

#include "bake_view.h"
#include "murk/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

json_t *cli_json_number(double number)
{
    return isfinite(number) ? json_real(number) : json_null();
}

json_t *cli_json_numbers(const double *numbers, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, cli_json_number(numbers[i]));
    return array;
}

json_t *cli_json_text(const char *text)
{
    return text ? json_string_nocheck(text) : json_null();
}

void cli_print_json(json_t *object)
{
    json_dumpf(object, stdout, 0);
    fputc('\n', stdout);
    json_decref(object);
}

/* "R, G, B: " for a scene with bands, else nothing. */
static const char *band_names(const struct cli_job *job, char *text, size_t size)
{
    size_t used = 0;
    *text = '\0';
    for (size_t n = 0; n < job->scene.band_count && job->scene.band[n].name && used < size; n++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", job->scene.band[n].name,
                                 n + 1 < job->scene.band_count ? ", " : ": ");
    return text;
}

static const char *status_word(murk_status status)
{
    return status == MURK_NOT_REACHED ? "tolerance not reached" : "done";
}

static void say_outputs(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    if (!strcmp(job->command, "solve"))
        cli_say(&job->terminal, "radiosity in %s", options->output);
    else if (options->preview)
        cli_say(&job->terminal, "picture in %s, to look at in %s", options->output,
                options->preview);
    else if (strcmp(job->command, "bake")) /* which tells of its textures as it writes them */
        cli_say(&job->terminal, "picture in %s", options->output);
    if (options->deep)
        cli_say(&job->terminal, "deep picture in %s", options->deep);
    if (strcmp(job->command, "render") && options->radiosity)
        cli_say(&job->terminal, "radiosity in %s", options->radiosity);
    if (options->ground_radiosity)
        cli_say(&job->terminal, "ground radiosity in %s", options->ground_radiosity);
    if (options->usd)
        cli_say(&job->terminal, "stage in %s", options->usd);
}

/* A scale that murk chose by itself is no secret. */
static void say_scale(struct cli_job *job)
{
    murk_medium_info info;
    if (cli_job_chose_scale(job, &info) && info.zones > 0)
        cli_say(&job->terminal,
                "extinction = %g x the grid, %.2g optical depths at most; --scale sets it",
                info.extinction_scale, info.max_depth);
}

void cli_report_say(struct cli_job *job, murk_status status)
{
    const murk_report *report = cli_job_report(job);
    double seconds = cli_seconds() - job->started;
    char bands[SCENE_BANDS_MAX * 42];
    band_names(job, bands, sizeof bands);
    if (!strcmp(job->command, "render"))
        cli_say(&job->terminal, "%s%llu zones, %llu patches, %.2f s", bands,
                (unsigned long long)report->zones, (unsigned long long)report->patches, seconds);
    else
        cli_say(&job->terminal,
                "%s%llu zones, %llu patches, %d iterations, %.2f s, estimated error %.2g %% "
                "(asked for %.2g %%)",
                bands, (unsigned long long)report->zones, (unsigned long long)report->patches,
                report->iterations, seconds, 100.0 * report->estimate, 100.0 * report->tolerance);
    say_scale(job);
    say_outputs(job);
    if (status == MURK_NOT_REACHED) /* said even when quiet: it is why the exit status is 3 */
        cli_error(&job->terminal,
                  "the tolerance of %.3g %% was not reached: the estimated error is %.3g %%; the "
                  "result is written",
                  100.0 * report->tolerance, 100.0 * report->estimate);
}

static json_t *solution_json(const murk_report *report)
{
    json_t *object = json_object();
    json_object_set_new(object, "zones", json_integer((json_int_t)report->zones));
    json_object_set_new(object, "patches", json_integer((json_int_t)report->patches));
    json_object_set_new(object, "bricks", json_integer((json_int_t)report->bricks));
    json_object_set_new(object, "method", cli_json_text(report->method));
    json_object_set_new(object, "solver", cli_json_text(report->solver));
    json_object_set_new(object, "kernel", cli_json_text(report->kernel));
    json_object_set_new(object, "threads", json_integer(report->threads));
    json_object_set_new(object, "directions", json_integer(report->directions));
    json_object_set_new(object, "iterations", json_integer(report->iterations));
    json_object_set_new(object, "sweeps", json_integer(report->sweeps));
    json_object_set_new(object, "crossings", cli_json_number(report->crossings));
    json_object_set_new(object, "crossings_dark", cli_json_number(report->crossings_dark));
    json_object_set_new(object, "crossings_unseen", cli_json_number(report->crossings_unseen));
    json_object_set_new(object, "coarsening", json_integer(report->coarsening));
    json_object_set_new(object, "residual", cli_json_number(report->residual));
    json_object_set_new(object, "tolerance", cli_json_number(report->tolerance));
    json_object_set_new(object, "estimate", cli_json_number(report->estimate));
    json_object_set_new(object, "estimate_iteration", cli_json_number(report->estimate_iteration));
    json_object_set_new(object, "estimate_angular", cli_json_number(report->estimate_angular));
    json_object_set_new(object, "estimate_lattice", cli_json_number(report->estimate_lattice));
    json_object_set_new(object, "estimate_spatial", cli_json_number(report->estimate_spatial));
    json_object_set_new(object, "subdivision", json_integer(report->subdivision));
    json_object_set_new(object, "lamps", json_integer((json_int_t)report->lamps));
    json_object_set_new(object, "reached", json_boolean(report->reached));
    json_object_set_new(object, "multiplications", cli_json_number(report->multiplications));
    json_object_set_new(object, "multiplications_window",
                        cli_json_number(report->multiplications_window));
    return object;
}

static json_t *energy_json(const murk_report *report)
{
    json_t *object = json_object();
    json_object_set_new(object, "emitted", cli_json_number(report->energy_emitted));
    json_object_set_new(object, "sun", cli_json_number(report->energy_sun));
    json_object_set_new(object, "diffuse", cli_json_number(report->energy_diffuse));
    json_object_set_new(object, "absorbed", cli_json_number(report->energy_absorbed));
    json_object_set_new(object, "escaped", cli_json_number(report->energy_escaped));
    json_object_set_new(object, "balance", cli_json_number(report->energy_balance));
    return object;
}

/* Every band's own report. */
static json_t *bands_json(const struct cli_job *job)
{
    json_t *array = json_array();
    for (size_t n = 0; n < job->scene.band_count; n++) {
        const struct scene_band *band = &job->scene.band[n];
        const murk_report *report = murk_solution_report(job->solution[n]);
        json_t *object = json_object();
        json_object_set_new(object, "name", cli_json_text(band->name));
        json_object_set_new(object, "wavelength", cli_json_numbers(band->band.wavelength, 2));
        json_object_set_new(object, "mass_extinction",
                            band->mass_extinction > 0 ? cli_json_number(band->mass_extinction)
                                                      : json_null());
        json_object_update_new(object, solution_json(report));
        json_object_set_new(object, "energy", energy_json(report));
        json_array_append_new(array, object);
    }
    return array;
}

/* Likewise of every light of bake. */
static json_t *lights_json(const struct cli_job *job)
{
    json_t *array = json_array();
    for (int side = 0; side < CLI_BAKE_SIDES; side++) {
        json_t *object = json_object();
        json_object_set_new(object, "name", cli_json_text(CLI_BAKE_SIDE[side]));
        json_object_update_new(object, solution_json(murk_solution_report(job->solution[side])));
        json_array_append_new(array, object);
    }
    return array;
}

static json_t *seconds_json(const struct cli_job *job, const murk_report *report)
{
    json_t *object = json_object();
    json_object_set_new(object, "read", cli_json_number(job->seconds_read));
    json_object_set_new(object, "setup", cli_json_number(report->seconds_setup));
    json_object_set_new(object, "light", cli_json_number(report->seconds_light));
    json_object_set_new(object, "solve", cli_json_number(report->seconds_solve));
    json_object_set_new(object, "finish", cli_json_number(report->seconds_finish));
    json_object_set_new(object, "exchange", cli_json_number(report->seconds_exchange));
    json_object_set_new(object, "render", cli_json_number(job->seconds_render));
    json_object_set_new(object, "write", cli_json_number(job->seconds_write));
    json_object_set_new(object, "total", cli_json_number(cli_seconds() - job->started));
    return object;
}

/* Bytes: what was estimated of the solve, and what the whole process took so far. */
static json_t *memory_json(const murk_report *report)
{
    json_t *object = json_object();
    json_object_set_new(object, "estimate", json_integer((json_int_t)report->memory));
    json_object_set_new(object, "peak", json_integer((json_int_t)murk_memory_peak()));
    return object;
}

void cli_report_json(const struct cli_job *job, murk_status status)
{
    const struct cli_options *options = job->options;
    const murk_report *report = cli_job_report(job);
    bool render = !strcmp(job->command, "render");
    json_t *object = json_object(), *inputs = json_object(), *outputs = json_object();
    json_object_set_new(inputs, "input", cli_json_text(options->input));
    json_object_set_new(inputs, "medium", cli_json_text(job->description.medium_file));
    json_object_set_new(inputs, "radiosity", cli_json_text(render ? options->radiosity : NULL));
    json_object_set_new(outputs, "output", cli_json_text(options->output));
    json_object_set_new(outputs, "preview", cli_json_text(options->preview));
    json_object_set_new(outputs, "deep", cli_json_text(options->deep));
    json_object_set_new(outputs, "radiosity", cli_json_text(render ? NULL : options->radiosity));
    json_object_set_new(outputs, "ground_radiosity", cli_json_text(options->ground_radiosity));
    json_object_set_new(outputs, "usd", cli_json_text(options->usd));
    json_object_set_new(object, "murk", json_string(MURK_VERSION));
    json_object_set_new(object, "command", cli_json_text(job->command_line));
    if (job->frame)
        json_object_set_new(object, "frame", json_integer(*job->frame));
    json_object_set_new(object, "status", json_string(status_word(status)));
    murk_medium_info medium = {0};
    if (murk_medium_info_get(job->scene.band[0].medium, &medium) == MURK_OK)
        json_object_set_new(inputs, "extinction_scale", cli_json_number(medium.extinction_scale));
    json_object_set_new(object, "inputs", inputs);
    json_object_set_new(object, "outputs", outputs);
    json_object_update_new(object, solution_json(report));
    json_object_set_new(object, "energy", energy_json(report));
    if (job->scene.band[0].name && strcmp(job->command, "bake"))
        json_object_set_new(object, "bands", bands_json(job));
    json_object_set_new(object, "memory", memory_json(report));
    if (!strcmp(job->command, "bake"))
        json_object_set_new(object, "lights", lights_json(job));
    json_object_set_new(object, "seconds", seconds_json(job, report));
    cli_print_json(object);
}

void cli_report_frame(int frame, const char *status, const char *text)
{
    json_t *object = json_object();
    json_object_set_new(object, "frame", json_integer(frame));
    json_object_set_new(object, "status", json_string(status));
    if (text)
        json_object_set_new(object, "message", cli_json_text(text));
    cli_print_json(object);
}
