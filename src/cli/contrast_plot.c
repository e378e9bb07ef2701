/* SPDX-License-Identifier: Apache-2.0 */
/* The curves of murk contrast: one panel below another, in each a curve for every band. */
#include "contrast.h"

#include "murk/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 900, HEIGHT = 400, TEXT_SIZE = 18, MARKED_MOST = 60 };
static const double MARGIN = 0.06; /* between the curves and the frame */

static const struct panel {
    const char *title, *label;
    size_t offset; /* in murk_contrast */
    double from;   /* wavelength of the bands that it shows [m] */
} PANELS[] = {
    {"Contrast transmittance", "C / C0", offsetof(murk_contrast, transmittance), 0},
    {"Apparent contrast", "C", offsetof(murk_contrast, apparent), 0},
    /* Below 3 um what is as warm as the ground shows other light than its own. */
    {"Apparent temperature difference", "K", offsetof(murk_contrast, dt_apparent), 3e-6},
};
enum { PANEL_COUNT = sizeof PANELS / sizeof *PANELS };

static const char *const LABELS[] = {"frame", "transmittance to the target",
                                     "optical depth to the target", "CL to the target [g/m^2]"};

struct point {
    double x, y;
};

/* The curves of a panel. */
struct curves {
    struct point *point; /* of one curve, while it is sorted */
    double *x, *y;       /* of all, one curve behind another */
    murk_curve *curve;
    size_t count, points;
    double low, high; /* of their values, and 0 */
};

static double place_of(const struct cli_contrast_row *row, int against)
{
    switch (against) {
    case CLI_AGAINST_TRANSMITTANCE:
        return row->contrast.target.transmittance;
    case CLI_AGAINST_DEPTH:
        return row->contrast.target.optical_depth;
    case CLI_AGAINST_CL:
        return row->contrast.target.cl;
    default:
        return row->frame;
    }
}

/* NaN where a panel does not show a row. */
static double value_of(const struct cli_contrast_row *row, const struct panel *panel)
{
    if (row->band.band.wavelength[0] < panel->from)
        return NAN;
    return *(const double *)((const char *)&row->contrast + panel->offset);
}

static int by_place(const void *a, const void *b)
{
    const struct point *p = a, *q = b;
    return (p->x > q->x) - (p->x < q->x);
}

/* Whether a band is in a row before. */
static bool is_known(const struct cli_contrast *contrast, size_t row)
{
    for (size_t i = 0; i < row; i++)
        if (!strcmp(contrast->row[i].band.name, contrast->row[row].band.name))
            return true;
    return false;
}

/* Adds the curve of a band, the n-th, where it has points. */
static void add_curve(struct curves *curves, const struct cli_contrast *contrast, const char *band,
                      int n, const struct panel *panel, int against)
{
    size_t count = 0;
    bool seen = false;
    double *x = curves->x + curves->points, *y = curves->y + curves->points;
    for (size_t i = 0; i < contrast->count; i++) {
        const struct cli_contrast_row *row = &contrast->row[i];
        if (!strcmp(row->band.name, band) && isfinite(place_of(row, against)))
            curves->point[count++] = (struct point){place_of(row, against), value_of(row, panel)};
    }
    qsort(curves->point, count, sizeof *curves->point, by_place);
    for (size_t i = 0; i < count; i++) {
        x[i] = curves->point[i].x;
        y[i] = curves->point[i].y;
        curves->low = fmin(curves->low, y[i]); /* neither takes a NaN */
        curves->high = fmax(curves->high, y[i]);
        seen |= isfinite(y[i]);
    }
    if (!seen)
        return;
    curves->points += count;
    curves->curve[curves->count] = (murk_curve){.name = band,
                                                .count = count,
                                                .x = x,
                                                .y = y,
                                                .color = murk_plot_color(n),
                                                .width = 2.5,
                                                .marker = count <= MARKED_MOST ? 8 : 0};
    curves->count++;
}

static void make_curves(struct curves *curves, const struct cli_contrast *contrast,
                        const struct panel *panel, int against)
{
    int n = 0;
    curves->count = curves->points = 0;
    curves->low = curves->high = 0;
    for (size_t i = 0; i < contrast->count; i++)
        if (!is_known(contrast, i))
            add_curve(curves, contrast, contrast->row[i].band.name, n++, panel, against);
}

/* Whether there is a point to be seen. */
static bool shows(const struct cli_contrast *contrast, const struct panel *panel, int against)
{
    for (size_t i = 0; i < contrast->count; i++)
        if (isfinite(value_of(&contrast->row[i], panel)) &&
            isfinite(place_of(&contrast->row[i], against)))
            return true;
    return false;
}

static murk_status draw(murk_context *context, const struct cli_contrast *contrast, int against,
                        const struct panel *const *shown, int count, murk_image **out)
{
    struct curves curves = {.point = calloc(contrast->count, sizeof *curves.point),
                            .x = calloc(contrast->count, sizeof *curves.x),
                            .y = calloc(contrast->count, sizeof *curves.y),
                            .curve = calloc(contrast->count, sizeof *curves.curve)};
    bool memory = curves.point && curves.x && curves.y && curves.curve;
    murk_status status =
        memory ? murk_canvas_create(context, WIDTH, count * HEIGHT, out) : MURK_ERROR_MEMORY;
    for (int p = 0; p < count && status == MURK_OK; p++) {
        const murk_rectangle place = {0, p * HEIGHT, WIDTH, HEIGHT};
        make_curves(&curves, contrast, shown[p], against);
        const double margin = MARGIN * (curves.high - curves.low);
        const murk_plot plot = {.title = shown[p]->title,
                                .x = {.label = LABELS[against]},
                                .y = {.label = shown[p]->label,
                                      .min = curves.low < 0 ? curves.low - margin : 0,
                                      .max = curves.high > 0 ? curves.high + margin : 0},
                                .curve = curves.curve,
                                .curve_count = curves.count,
                                .text_size = TEXT_SIZE};
        status = murk_plot_draw(context, *out, &place, &plot);
    }
    free(curves.point);
    free(curves.x);
    free(curves.y);
    free(curves.curve);
    return status;
}

murk_status cli_contrast_plot(struct cli_job *job, const struct cli_contrast *contrast)
{
    const struct cli_options *options = job->options;
    int against = options->against >= 0 ? options->against : CLI_AGAINST_FRAME, count = 0;
    const struct panel *shown[PANEL_COUNT];
    murk_image *image = NULL;
    for (int p = 0; p < PANEL_COUNT; p++)
        if (shows(contrast, &PANELS[p], against))
            shown[count++] = &PANELS[p];
    if (count == 0) {
        cli_error(&job->terminal, "--plot %s: there is nothing to draw against %s%s", options->plot,
                  CLI_AGAINST[against],
                  against == CLI_AGAINST_CL ? "; pictures of scenes with a mass_extinction have it"
                                            : "");
        return MURK_ERROR_INPUT;
    }
    murk_status status = draw(job->context, contrast, against, shown, count, &image);
    murk_image_write_options write = MURK_IMAGE_WRITE_DEFAULT;
    write.exposure = 0;
    write.command = job->command_line;
    if (status == MURK_OK)
        status = murk_image_write(job->context, image, options->plot, &write);
    murk_image_release(image);
    if (status == MURK_ERROR_MEMORY)
        cli_error(&job->terminal, "--plot %s: out of memory", options->plot);
    else
        cli_job_fail(job, status);
    if (status == MURK_OK)
        cli_say(&job->terminal, "curves in %s", options->plot);
    return status;
}
