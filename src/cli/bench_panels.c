/* SPDX-License-Identifier: Apache-2.0 */
#include "bench_panels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PANEL_WIDTH = 800, PANEL_HEIGHT = 520, TEXT_SIZE = 19 };

struct cli_panel *cli_panels_find(struct cli_panels *panels, const char *title, const char *x,
                                  const char *y)
{
    int p = 0;
    while (p < panels->count && strcmp(panels->panel[p].title, title))
        p++;
    if (p == CLI_PANELS_MOST)
        return NULL;
    struct cli_panel *panel = &panels->panel[p];
    if (p == panels->count) {
        panels->count++;
        snprintf(panel->title, sizeof panel->title, "%s", title);
        panel->plot.x = (murk_axis){.label = x, .log = true};
        panel->plot.y = (murk_axis){.label = y, .log = true};
        panel->plot.text_size = TEXT_SIZE;
    }
    return panel;
}

/* Adds to the label of the curve's last point, where that is as good as at the same height. */
static bool join(struct cli_panel *panel, size_t c, const struct cli_point *point)
{
    size_t count = panel->curve[c].count;
    if (count == 0 || !point->label || !*point->label ||
        fabs(panel->y[c][count - 1] / point->y - 1) > 0.02)
        return false;
    char *label = panel->label[c][count - 1];
    size_t used = strlen(label);
    snprintf(label + used, CLI_LABEL_SIZE - used, ", %s", point->label);
    return true;
}

bool cli_panel_add(struct cli_panel *panel, const struct cli_point *point)
{
    size_t c = 0;
    if (isnan(point->x) || isnan(point->y))
        return true;
    while (c < panel->plot.curve_count && strcmp(panel->name[c], point->curve))
        c++;
    if (c == CLI_CURVES_MOST)
        return false;
    if (c == panel->plot.curve_count) {
        panel->plot.curve_count++;
        snprintf(panel->name[c], sizeof panel->name[c], "%s", point->curve);
        panel->curve[c] = (murk_curve){.color = point->color, .width = 2.5, .marker = 10};
    }
    if (join(panel, c, point))
        return true;
    if (panel->curve[c].count == CLI_POINTS_MOST)
        return false;
    size_t at = panel->curve[c].count++;
    panel->x[c][at] = point->x;
    panel->y[c][at] = point->y;
    snprintf(panel->label[c][at], CLI_LABEL_SIZE, "%s", point->label ? point->label : "");
    return true;
}

bool cli_panels_append(struct cli_panels *panels, const struct cli_panels *others)
{
    if (panels->count + others->count > CLI_PANELS_MOST)
        return false;
    for (int p = 0; p < others->count; p++)
        panels->panel[panels->count++] = others->panel[p];
    return true;
}

/* Puts the points on the plot. */
static murk_status draw(struct cli_panel *panel, murk_context *context, murk_image *image,
                        const murk_rectangle *place)
{
    panel->plot.title = panel->title;
    panel->plot.curve = panel->curve;
    for (size_t c = 0; c < panel->plot.curve_count; c++) {
        murk_curve *curve = &panel->curve[c];
        curve->name = panel->name[c];
        curve->x = panel->x[c];
        curve->y = panel->y[c];
        curve->label = panel->shown[c];
        for (size_t i = 0; i < curve->count; i++)
            panel->shown[c][i] = *panel->label[c][i] ? panel->label[c][i] : NULL;
    }
    return murk_plot_draw(context, image, place, &panel->plot);
}

murk_status cli_panels_draw(struct cli_panels *panels, murk_context *context, murk_image **out)
{
    int across = panels->count > 1 ? 2 : 1, down = panels->count > 0 ? (panels->count + 1) / 2 : 1;
    murk_image *image = NULL;
    murk_status status =
        murk_canvas_create(context, across * PANEL_WIDTH, down * PANEL_HEIGHT, &image);
    for (int p = 0; p < panels->count && !status; p++) {
        const murk_rectangle place = {p % 2 * PANEL_WIDTH, p / 2 * PANEL_HEIGHT, PANEL_WIDTH,
                                      PANEL_HEIGHT};
        status = draw(&panels->panel[p], context, image, &place);
    }
    if (status)
        murk_image_release(image);
    else
        *out = image;
    return status;
}

/* ---- points of other programs -------------------------------------------------------------- */

/* Adds the point of a line; false where it is none. */
static bool read_point(struct cli_panels *panels, const char *line)
{
    char title[CLI_TITLE_SIZE], name[CLI_NAME_SIZE], label[CLI_LABEL_SIZE] = "";
    struct cli_point point = {.curve = name, .label = label};
    int end = 0;
    int found = sscanf(line, "%63[^,\n],%31[^,\n],%lf,%lf%n,%47[^,\n]", title, name, &point.x,
                       &point.y, &end, label);
    if (found < 4 || (found == 4 && line[end] != '\n') || !(point.x > 0) || !(point.y > 0))
        return false;
    struct cli_panel *panel = cli_panels_find(panels, title, "seconds", "relative error [%]");
    if (!panel)
        return false;
    point.color = murk_plot_color(strstr(name, "murk") ? 0 : 3 + (int)panel->plot.curve_count);
    return cli_panel_add(panel, &point);
}

murk_status cli_panels_read(struct cli_panels *panels, const char *path,
                            struct cli_terminal *terminal)
{
    char line[256];
    murk_status status = MURK_OK;
    FILE *file = fopen(path, "r");
    if (!file) {
        cli_error(terminal, "--curves %s: cannot be read", path);
        return MURK_ERROR_INPUT;
    }
    for (int n = 1; fgets(line, sizeof line, file) && !status; n++)
        if (!read_point(panels, line)) {
            cli_error(terminal,
                      "%s, line %d: is no point: it takes PANEL,CURVE,SECONDS,ERROR or "
                      "PANEL,CURVE,SECONDS,ERROR,LABEL, with numbers > 0",
                      path, n);
            status = MURK_ERROR_INPUT;
        }
    fclose(file);
    return status;
}
