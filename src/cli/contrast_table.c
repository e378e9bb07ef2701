/* SPDX-License-Identifier: Apache-2.0 */
/* What murk contrast prints: a table of values separated by commas, or JSON. */
#include "contrast.h"
#include "report.h"

#include <math.h>
#include <stdio.h>

/* Numbers of a row by name; radiances are per um where the band is one wavelength. */
static const struct column {
    const char *name;
    size_t offset; /* in murk_contrast */
} COLUMNS[] = {
#define CONTRAST(name, field) {name, offsetof(murk_contrast, field)},
#define MEAN(name, unit, field)                                                                    \
    CONTRAST(name "_target" unit, target.field)                                                    \
    CONTRAST(name "_background" unit, background.field)
    CONTRAST("contrast_inherent", inherent) CONTRAST("contrast_apparent", apparent)
        CONTRAST("contrast_transmittance", transmittance) CONTRAST("dt_inherent_K", dt_inherent)
            CONTRAST("dt_apparent_K", dt_apparent) CONTRAST("cnr_thermal", cnr_thermal)
                CONTRAST("cnr_radiance", cnr_radiance) MEAN("transmittance", "", transmittance)
                    MEAN("depth", "", optical_depth) MEAN("cl", "_g_m2", cl)
                        MEAN("radiance", "_W_m2_sr", radiance)
                            MEAN("radiance_inherent", "_W_m2_sr", inherent)
                                MEAN("scattered", "_W_m2_sr", scattered)
                                    MEAN("emitted", "_W_m2_sr", emitted)
                                        MEAN("temperature", "_K", temperature)
                                            MEAN("temperature_inherent", "_K", temperature_inherent)
#undef MEAN
#undef CONTRAST
};
enum { COLUMN_COUNT = sizeof COLUMNS / sizeof *COLUMNS };

static double value_of(const struct cli_contrast_row *row, const struct column *column)
{
    return *(const double *)((const char *)&row->contrast + column->offset);
}

static void print_row(FILE *stream, const struct cli_contrast_row *row)
{
    if (row->has_frame)
        fprintf(stream, "%d", row->frame);
    fprintf(stream, ",%s", row->band.name);
    for (int c = 0; c < COLUMN_COUNT; c++) {
        double value = value_of(row, &COLUMNS[c]);
        if (isfinite(value))
            fprintf(stream, ",%.6g", value);
        else
            fputc(',', stream);
    }
    fprintf(stream, ",%llu,%llu\n", (unsigned long long)row->contrast.target.pixels,
            (unsigned long long)row->contrast.background.pixels);
}

char *cli_contrast_table(const struct cli_contrast *contrast)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        return NULL;
    fputs("frame,band", stream);
    for (int c = 0; c < COLUMN_COUNT; c++)
        fprintf(stream, ",%s", COLUMNS[c].name);
    fputs(",pixels_target,pixels_background\n", stream);
    for (size_t i = 0; i < contrast->count; i++)
        print_row(stream, &contrast->row[i]);
    if (fclose(stream) == 0)
        return text;
    free(text);
    return NULL;
}

static json_t *row_json(const struct cli_contrast_row *row)
{
    const double *wavelength = row->band.band.wavelength;
    json_t *object = json_object();
    json_object_set_new(object, "band", json_string(row->band.name));
    json_object_set_new(object, "wavelength_m",
                        wavelength[0] > 0 ? cli_json_numbers(wavelength, 2) : json_null());
    for (int c = 0; c < COLUMN_COUNT; c++)
        json_object_set_new(object, COLUMNS[c].name, cli_json_number(value_of(row, &COLUMNS[c])));
    json_object_set_new(object, "pixels_target",
                        json_integer((json_int_t)row->contrast.target.pixels));
    json_object_set_new(object, "pixels_background",
                        json_integer((json_int_t)row->contrast.background.pixels));
    return object;
}

void cli_contrast_json(const struct cli_job *job, const struct cli_contrast_row *row, size_t count)
{
    const struct cli_options *options = job->options;
    json_t *object = json_object(), *bands = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(bands, row_json(&row[i]));
    json_object_set_new(object, "murk", json_string(MURK_VERSION));
    json_object_set_new(object, "command", cli_json_text(job->command_line));
    if (job->frame)
        json_object_set_new(object, "frame", json_integer(*job->frame));
    json_object_set_new(object, "status", json_string("done"));
    json_object_set_new(object, "input", cli_json_text(options->input));
    json_object_set_new(object, "target", cli_json_text(options->target_region));
    json_object_set_new(object, "background", cli_json_text(options->background_region));
    json_object_set_new(object, "bands", bands);
    cli_print_json(object);
}
