/* SPDX-License-Identifier: Apache-2.0 */
/* A plot: frame, ticks, curves, legend. */
#include "murk/plot.h"

#include "canvas.h"
#include "context.h"
#include "ticks.h"

#include <math.h>
#include <string.h>

static const murk_color BLACK = {0, 0, 0};
static const murk_color GREY = {0.15f, 0.15f, 0.15f};  /* of the frame */
static const murk_color LIGHT = {0.78f, 0.78f, 0.78f}; /* of the grid */

/* A plot while it is drawn. */
struct drawing {
    murk_context *context;
    murk_image *image;
    const murk_plot *plot;
    murk_rectangle frame;
    int size; /* of text; all distances follow from it */
    double range[2][2];
    murk_tick ticks[2][MURK_TICKS_MOST];
    int tick_count[2];
};

murk_color murk_plot_color(int n)
{
    /* After Okabe & Ito 2008, the yellow darkened for lines on white. */
    static const uint32_t COLORS[] = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                      0xE69F00, 0x56B4E9, 0x000000, 0xB8A800};
    return murk_color_srgb(COLORS[n & 7]);
}

static const murk_axis *axis_of(const struct drawing *d, int a)
{
    return a == 0 ? &d->plot->x : &d->plot->y;
}

/* ---- layout -------------------------------------------------------------------------------- */

/* The smallest and the largest value on an axis, of points that both axes can show. */
static void find_extent(const murk_plot *plot, int a, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t c = 0; c < plot->curve_count; c++)
        for (size_t i = 0; i < plot->curve[c].count; i++) {
            double x = plot->curve[c].x[i], y = plot->curve[c].y[i], value = a == 0 ? x : y;
            if (!isfinite(x) || !isfinite(y) || (plot->x.log && x <= 0) || (plot->y.log && y <= 0))
                continue;
            *low = fmin(*low, value);
            *high = fmax(*high, value);
        }
    if (*low > *high) { /* nothing to show */
        *low = 1;
        *high = 10;
    }
}

static double legend_width(const struct drawing *d)
{
    double width = 0;
    for (size_t c = 0; c < d->plot->curve_count; c++)
        if (d->plot->curve[c].name)
            width = fmax(width, murk_text_width(d->plot->curve[c].name, d->size) + 4 * d->size);
    return width;
}

/* Leaves room around the frame for what stands there. */
static void place_frame(struct drawing *d, const murk_rectangle *all)
{
    double labels = 0, size = d->size;
    for (int i = 0; i < d->tick_count[1]; i++)
        labels = fmax(labels, murk_text_width(d->ticks[1][i].label, d->size));
    double left = labels + (d->plot->y.label ? 3.2 : 1.8) * size;
    double right = fmax(2 * size, legend_width(d));
    double top = (d->plot->title ? 3.2 : 1) * size;
    double bottom = (d->plot->x.label ? 4 : 2.2) * size;
    d->frame = (murk_rectangle){round(all->x + left), round(all->y + top),
                                fmax(1, round(all->width - left - right)),
                                fmax(1, round(all->height - top - bottom))};
}

static void point_of(const struct drawing *d, double x, double y, double out[2])
{
    out[0] = d->frame.x + d->frame.width * murk_axis_place(d->plot->x.log, d->range[0], x);
    out[1] = d->frame.y + d->frame.height * (1 - murk_axis_place(d->plot->y.log, d->range[1], y));
}

/* ---- drawing ------------------------------------------------------------------------------- */

static murk_status draw_text(const struct drawing *d, const char *text, double x, double y,
                             double align_x, double align_y)
{
    const murk_text line = {text, {x, y}, {align_x, align_y}, d->size, false, BLACK};
    return murk_text_draw(d->context, d->image, &line);
}

/* A line along the edge of pixels is drawn on one row of them, sharply. */
static void draw_straight(const struct drawing *d, double x, double y, double width, double height,
                          murk_color color)
{
    const murk_rectangle line = {round(x), round(y), fmax(1, width), fmax(1, height)};
    murk_rectangle_draw(d->image, &line, color);
}

static void draw_grid(const struct drawing *d)
{
    const murk_rectangle *f = &d->frame;
    for (int a = 0; a < 2; a++)
        for (int i = 0; i < d->tick_count[a]; i++) {
            const murk_tick *tick = &d->ticks[a][i];
            double place = murk_axis_place(axis_of(d, a)->log, d->range[a], tick->value);
            double x = f->x + place * f->width, y = f->y + (1 - place) * f->height;
            double length = 0.3 * d->size;
            if (*tick->label && a == 0)
                draw_straight(d, x, f->y, 1, f->height, LIGHT);
            else if (*tick->label)
                draw_straight(d, f->x, y, f->width, 1, LIGHT);
            else if (a == 0)
                draw_straight(d, x, f->y + f->height - length, 1, length, GREY);
            else
                draw_straight(d, f->x, y, length, 1, GREY);
        }
}

static void draw_frame(const struct drawing *d)
{
    const murk_rectangle *f = &d->frame;
    draw_straight(d, f->x, f->y, f->width, 1, GREY);
    draw_straight(d, f->x, f->y + f->height, f->width + 1, 1, GREY);
    draw_straight(d, f->x, f->y, 1, f->height, GREY);
    draw_straight(d, f->x + f->width, f->y, 1, f->height, GREY);
}

static murk_status draw_labels(const struct drawing *d)
{
    const murk_rectangle *f = &d->frame;
    const murk_plot *plot = d->plot;
    double size = d->size, bottom = f->y + f->height, left = f->x;
    murk_status status = MURK_OK;
    for (int a = 0; a < 2; a++)
        for (int i = 0; i < d->tick_count[a] && !status; i++) {
            const murk_tick *tick = &d->ticks[a][i];
            double place = murk_axis_place(axis_of(d, a)->log, d->range[a], tick->value);
            if (a == 0)
                status =
                    draw_text(d, tick->label, f->x + place * f->width, bottom + 0.6 * size, 0.5, 0);
            else
                status = draw_text(d, tick->label, f->x - 0.5 * size, bottom - place * f->height, 1,
                                   0.5);
            left = fmin(left, f->x - murk_text_width(tick->label, d->size) * (a == 1));
        }
    if (!status && plot->x.label)
        status = draw_text(d, plot->x.label, f->x + f->width / 2, bottom + 2.4 * size, 0.5, 0);
    if (!status && plot->y.label) {
        const murk_text label = {plot->y.label, {left - 1.3 * size, f->y + f->height / 2},
                                 {0.5, 1},      d->size,
                                 true,          BLACK};
        status = murk_text_draw(d->context, d->image, &label);
    }
    if (!status && plot->title)
        status = draw_text(d, plot->title, f->x + f->width / 2, f->y - size, 0.5, 1);
    return status;
}

/* Whether a point is in the frame or on its edge; false where a number is missing. */
static bool in_frame(const struct drawing *d, const double at[2])
{
    const murk_rectangle *f = &d->frame;
    return at[0] >= f->x - 0.5 && at[0] <= f->x + f->width + 0.5 && at[1] >= f->y - 0.5 &&
           at[1] <= f->y + f->height + 0.5;
}

static void draw_curve(const struct drawing *d, const murk_curve *curve)
{
    murk_canvas lines, markers;
    double before[2] = {NAN, NAN}, at[2];
    /* A marker on the frame's edge is seen whole; a line ends there. */
    if (!murk_canvas_open(d->image, &d->frame, &lines) ||
        !murk_canvas_open(d->image, NULL, &markers))
        return;
    for (size_t i = 0; i < curve->count; i++) {
        point_of(d, curve->x[i], curve->y[i], at);
        if (curve->width > 0 && isfinite(before[0] + before[1] + at[0] + at[1]))
            murk_canvas_line(&lines, before, at, curve->width, curve->color);
        memcpy(before, at, sizeof before);
    }
    for (size_t i = 0; i < curve->count && curve->marker > 0; i++) {
        point_of(d, curve->x[i], curve->y[i], at);
        if (in_frame(d, at))
            murk_canvas_line(&markers, at, at, curve->marker, curve->color);
    }
}

/* What stands beside the points, above them to the right and a little smaller than other text. */
static murk_status draw_point_labels(const struct drawing *d, const murk_curve *curve)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < curve->count && curve->label && !status; i++) {
        double at[2];
        point_of(d, curve->x[i], curve->y[i], at);
        if (!curve->label[i] || !in_frame(d, at))
            continue;
        const murk_text text = {.text = curve->label[i],
                                .at = {at[0] + 0.4 * curve->marker, at[1] - 0.6 * curve->marker},
                                .align = {0, 1},
                                .size = (int)round(0.8 * d->size),
                                .color = curve->color};
        status = murk_text_draw(d->context, d->image, &text);
    }
    return status;
}

static murk_status draw_legend(const struct drawing *d)
{
    double x = d->frame.x + d->frame.width + 0.8 * d->size, y = d->frame.y + 0.8 * d->size;
    murk_status status = MURK_OK;
    for (size_t c = 0; c < d->plot->curve_count && !status; c++) {
        const murk_curve *curve = &d->plot->curve[c];
        if (!curve->name)
            continue;
        const double from[2] = {x, y}, to[2] = {x + 1.6 * d->size, y};
        const double middle[2] = {x + 0.8 * d->size, y};
        if (curve->width > 0)
            murk_line_draw(d->image, from, to, curve->width, curve->color);
        if (curve->marker > 0)
            murk_line_draw(d->image, middle, middle, curve->marker, curve->color);
        status = draw_text(d, curve->name, x + 2.2 * d->size, y, 0, 0.5);
        y += 1.6 * d->size;
    }
    return status;
}

murk_status murk_plot_draw(murk_context *context, murk_image *image,
                           const murk_rectangle *rectangle, const murk_plot *plot)
{
    struct drawing d = {.context = context,
                        .image = image,
                        .plot = plot,
                        .size = plot->text_size > 0 ? plot->text_size : 16};
    if (!murk_text_possible())
        murk_warn(context, "the plot goes without text: there is no font such as that of Debian's "
                           "package fonts-dejavu-core");
    for (int a = 0; a < 2; a++) {
        double low, high, length = a == 0 ? rectangle->width : rectangle->height;
        find_extent(plot, a, &low, &high);
        if (!murk_axis_range(axis_of(&d, a), low, high, d.range[a]))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "plot: the %c axis from %g to %g%s: it has to begin below its end%s",
                             "xy"[a], d.range[a][0], d.range[a][1],
                             axis_of(&d, a)->log ? ", logarithmic" : "",
                             axis_of(&d, a)->log ? " and above 0" : "");
        int most = (int)fmax(2, length / ((a == 0 ? 6 : 4) * d.size));
        d.tick_count[a] = murk_axis_ticks(axis_of(&d, a)->log, d.range[a], most, d.ticks[a]);
    }
    place_frame(&d, rectangle);
    draw_grid(&d);
    draw_frame(&d);
    for (size_t c = 0; c < plot->curve_count; c++)
        draw_curve(&d, &plot->curve[c]);
    murk_status status = draw_labels(&d);
    for (size_t c = 0; c < plot->curve_count && !status; c++)
        status = draw_point_labels(&d, &plot->curve[c]);
    return status ? status : draw_legend(&d);
}
