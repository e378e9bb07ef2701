/* SPDX-License-Identifier: Apache-2.0 */
/* What murk bench draws. */
#include "bench.h"

#include "cases.h"
#include "murk/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PANEL_WIDTH = 800, PANEL_HEIGHT = 560, TEXT_SIZE = 18, PANELS_MOST = 4, NAME_SIZE = 32 };
enum { CURVES_MOST = 2 * (BENCH_CASE_COUNT + 1), POINTS_MOST = 32 };

/* One plot of the picture, with its own copy of the numbers. */
struct panel {
    murk_plot plot;
    murk_curve curve[CURVES_MOST];
    char name[CURVES_MOST][NAME_SIZE];
    double x[CURVES_MOST][POINTS_MOST], y[CURVES_MOST][POINTS_MOST];
};

/* The curve of a medium and method, made where there is none. */
static murk_curve *curve_of(struct panel *panel, const struct cli_bench_row *row)
{
    const char *name = BENCH_CASES[row->medium].name;
    bool pairwise = row->solve.method == MURK_PAIRWISE;
    char wanted[NAME_SIZE];
    snprintf(wanted, sizeof wanted, "%s%s", name, pairwise ? ", pairwise" : "");
    size_t c = 0;
    while (c < panel->plot.curve_count && strcmp(panel->name[c], wanted))
        c++;
    if (c == panel->plot.curve_count) {
        panel->plot.curve_count++;
        strcpy(panel->name[c], wanted);
        panel->curve[c] = (murk_curve){
            .color = murk_plot_color(row->medium + pairwise), .width = 2.5, .marker = 9};
    }
    return &panel->curve[c];
}

static void add_point(struct panel *panel, const struct cli_bench_row *row, double x, double y)
{
    if (isnan(x) || isnan(y))
        return;
    murk_curve *curve = curve_of(panel, row);
    size_t c = (size_t)(curve - panel->curve), at = curve->count++;
    panel->x[c][at] = x;
    panel->y[c][at] = y;
}

/* Puts the points on the plot. */
static murk_status draw(struct panel *panel, murk_context *context, murk_image *image,
                        const murk_rectangle *place)
{
    panel->plot.curve = panel->curve;
    for (size_t c = 0; c < panel->plot.curve_count; c++) {
        panel->curve[c].name = panel->name[c];
        panel->curve[c].x = panel->x[c];
        panel->curve[c].y = panel->y[c];
    }
    return murk_plot_draw(context, image, place, &panel->plot);
}

static struct panel empty_panel(const char *title, const char *x, const char *y)
{
    return (struct panel){.plot = {.title = title,
                                   .x = {.label = x, .log = true},
                                   .y = {.label = y, .log = true},
                                   .text_size = TEXT_SIZE}};
}

/* The panels that there is something to show in; their number. */
static int fill(const struct cli_bench *bench, struct panel panel[PANELS_MOST])
{
    panel[0] = empty_panel("Run time", "zones", "seconds");
    panel[1] = empty_panel("Error after run time", "seconds", "relative error [%]");
    panel[2] = empty_panel("Memory at the peak", "zones", "bytes per zone");
    panel[3] = empty_panel("Work", "zones", "ns per zone, direction and core");
    for (size_t i = 0; i < bench->count; i++) {
        const struct cli_bench_row *row = &bench->row[i];
        const struct bench_result *r = &row->outcome.median;
        if (row->part == CLI_BENCH_GROWTH) {
            add_point(&panel[0], row, r->zones, r->seconds);
            add_point(&panel[2], row, r->zones, r->bytes_per_zone);
            add_point(&panel[3], row, r->zones, r->ns_per_crossing);
        }
        if (row->part == CLI_BENCH_ERROR)
            add_point(&panel[1], row, r->seconds, 100 * r->error);
    }
    int count = 0;
    for (int p = 0; p < PANELS_MOST; p++)
        if (panel[p].plot.curve_count > 0)
            panel[count++] = panel[p];
    return count;
}

murk_status cli_bench_plot(const struct cli_bench *bench, const char *path)
{
    struct panel panel[PANELS_MOST];
    int count = fill(bench, panel), across = count > 1 ? 2 : 1, down = (count + 1) / 2;
    murk_image *image = NULL;
    murk_status status = murk_canvas_create(bench->context, across * PANEL_WIDTH,
                                            (down > 0 ? down : 1) * PANEL_HEIGHT, &image);
    for (int p = 0; p < count && !status; p++) {
        const murk_rectangle place = {p % 2 * PANEL_WIDTH, p / 2 * PANEL_HEIGHT, PANEL_WIDTH,
                                      PANEL_HEIGHT};
        status = draw(&panel[p], bench->context, image, &place);
    }
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = 0;
    options.command = bench->command_line;
    if (!status)
        status = murk_image_write(bench->context, image, path, &options);
    murk_image_release(image);
    return status;
}
