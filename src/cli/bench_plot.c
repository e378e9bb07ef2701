/* SPDX-License-Identifier: Apache-2.0 */
/* What murk bench draws. */
#include "bench.h"

#include "cases.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A point of a medium's curve in a panel of the growth with the number of zones. */
static bool add_growth(struct cli_panels *panels, const struct cli_bench_row *row,
                       const char *title, const char *label, double value)
{
    struct cli_panel *panel = cli_panels_find(panels, title, "zones", label);
    const struct cli_point point = {row->name, murk_plot_color(row->medium),
                                    row->outcome.median.zones, value, NULL};
    return panel && cli_panel_add(panel, &point);
}

/* A point of a method's curve in the panel of a medium; lines with the tolerance they were asked
   for, pairwise with its window. */
static bool add_error(struct cli_panels *panels, const struct cli_bench_row *row)
{
    static const char *const METHODS[] = {"lines", "pairwise", "Monte Carlo", "pairwise, window"};
    const struct bench_result *r = &row->outcome.median;
    char title[CLI_TITLE_SIZE], label[CLI_LABEL_SIZE] = "";
    int method = 0;
    while (strcmp(METHODS[method], cli_bench_method(row)))
        method++;
    if (row->packets > 0)
        snprintf(label, sizeof label, "10^%.0f", log10(r->packets));
    else if (row->solve.window[0] > 0)
        snprintf(label, sizeof label, "%d^3", row->solve.window[0]);
    else if (row->solve.method == MURK_LINES)
        snprintf(label, sizeof label, "%g %%", 100 * row->solve.tolerance);
    snprintf(title, sizeof title, "%s, %.0f zones", row->name, r->zones);
    struct cli_panel *panel =
        cli_panels_find(panels, title, "seconds", "error of the radiosity [%]");
    const struct cli_point point = {METHODS[method], murk_plot_color(method), r->seconds,
                                    100 * r->error, label};
    return panel && cli_panel_add(panel, &point);
}

static bool add_row(struct cli_panels *panels, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    if (row->part == CLI_BENCH_ERROR)
        return add_error(panels, row);
    return row->part != CLI_BENCH_GROWTH ||
           (add_growth(panels, row, "Run time", "seconds", r->seconds) &&
            add_growth(panels, row, "Memory at the peak", "bytes per zone", r->bytes_per_zone) &&
            add_growth(panels, row, "Work", "ns per zone, direction and core", r->ns_per_crossing));
}

murk_status cli_bench_plot(const struct cli_bench *bench, const char *path)
{
    struct cli_panels *panels = calloc(1, sizeof *panels);
    murk_image *image = NULL;
    bool room = panels != NULL;
    for (size_t i = 0; i < bench->count && room; i++)
        room = add_row(panels, &bench->row[i]);
    if (room && bench->curves)
        room = cli_panels_append(panels, bench->curves);
    murk_status status = room ? MURK_OK : MURK_ERROR_MEMORY;
    if (!status)
        status = cli_panels_draw(panels, bench->context, &image);
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = 0;
    options.command = bench->command_line;
    if (!status)
        status = murk_image_write(bench->context, image, path, &options);
    murk_image_release(image);
    free(panels);
    return status;
}
