/* SPDX-License-Identifier: Apache-2.0 */
/* The plots of the picture that murk bench draws, with their own copies of all numbers and texts.
 */
#ifndef CLI_BENCH_PANELS_H
#define CLI_BENCH_PANELS_H

#include "terminal.h"

#include "murk/plot.h"

enum {
    CLI_CURVES_MOST = 16,
    CLI_POINTS_MOST = 32,
    CLI_PANELS_MOST = 16,
    CLI_TITLE_SIZE = 64,
    CLI_NAME_SIZE = 32,
    CLI_LABEL_SIZE = 48
};

struct cli_panel {
    murk_plot plot;
    char title[CLI_TITLE_SIZE];
    murk_curve curve[CLI_CURVES_MOST];
    char name[CLI_CURVES_MOST][CLI_NAME_SIZE];
    double x[CLI_CURVES_MOST][CLI_POINTS_MOST], y[CLI_CURVES_MOST][CLI_POINTS_MOST];
    char label[CLI_CURVES_MOST][CLI_POINTS_MOST][CLI_LABEL_SIZE];
    const char *shown[CLI_CURVES_MOST][CLI_POINTS_MOST]; /* the labels there are */
};

struct cli_panels {
    int count;
    struct cli_panel panel[CLI_PANELS_MOST];
};

/* A point of a curve in a panel. */
struct cli_point {
    const char *curve;
    murk_color color; /* of the curve, where this is its first point */
    double x, y;
    const char *label; /* beside the point, or NULL */
};

/* The panel of this title, made with these names of its logarithmic axes where there is none; NULL
   where there are too many. */
struct cli_panel *cli_panels_find(struct cli_panels *panels, const char *title, const char *x,
                                  const char *y);

/* Adds a point; one without numbers (NaN) is left out, and one with nearly the y of the point
   before gives it a further label. False where there are too many. */
bool cli_panel_add(struct cli_panel *panel, const struct cli_point *point);

/* Puts all panels of others behind; false where there are too many. */
bool cli_panels_append(struct cli_panels *panels, const struct cli_panels *others);

/* Draws the panels in two columns. */
murk_status cli_panels_draw(struct cli_panels *panels, murk_context *context, murk_image **out);

/* Adds the points of a text file, each in a line PANEL,CURVE,SECONDS,ERROR or with ,LABEL behind.
   Prints what is wrong. */
murk_status cli_panels_read(struct cli_panels *panels, const char *path,
                            struct cli_terminal *terminal);

#endif
