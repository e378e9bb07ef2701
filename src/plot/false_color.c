/* SPDX-License-Identifier: Apache-2.0 */
/* A channel in false colour beside its scale bar. */
#include "murk/false_color.h"

#include "context.h"
#include "image.h"
#include "percentile.h"
#include "ticks.h"

#include <math.h>
#include <stdio.h>

static const murk_color INK = {0.02f, 0.02f, 0.02f};

/* Text grows with the picture, and stays legible. */
enum { SMALLEST_TEXT = 10, PIXELS_A_TEXT = 40, SMALLEST_LABEL = 6 };

/* Where the parts of the scale bar are; lengths follow from the size of its text. */
struct layout {
    int size, width, height; /* of text, of all */
    murk_rectangle bar;
    double numbers; /* left end of the numbers */
    double label;   /* line that the turned label stands on */
};

static struct layout lay_out(const murk_image *image, double numbers_width)
{
    struct layout l = {.size = (int)fmax(SMALLEST_TEXT, image->height / PIXELS_A_TEXT)};
    const double size = l.size;
    l.height = (int)fmax(image->height, 12 * size);
    l.bar = (murk_rectangle){round(image->width + size), round(size), round(1.2 * size),
                             fmin(l.height, 60 * size) - 2 * round(size)};
    l.numbers = l.bar.x + l.bar.width + 0.7 * size;
    l.label = l.numbers + numbers_width + 1.7 * size;
    l.width = (int)ceil(l.label + 0.8 * size);
    return l;
}

/* ---- range --------------------------------------------------------------------------------- */

static murk_status choose_range(murk_context *context, const murk_image *image, int channel,
                                const murk_false_color *options, double range[2])
{
    const size_t count = (size_t)image->width * (size_t)image->height;
    const size_t stride = (size_t)image->channels;
    const murk_axis linear = {.log = false};
    range[0] = options->low;
    range[1] = options->high;
    if (isnan(range[0]) || isnan(range[1])) {
        const float *values = image->pixels + channel;
        double low = murk_percentile(values, count, stride, 0.01), chosen[2];
        double high = murk_percentile(values, count, stride, 0.99);
        if (low == high) { /* one value stands in the middle */
            double margin = fmax(1e-9, 0.1 * fabs(low));
            low -= margin;
            high += margin;
        }
        if (isnan(low) || !murk_axis_range(&linear, low, high, chosen)) {
            chosen[0] = 0; /* nothing to show */
            chosen[1] = 1;
        }
        for (int i = 0; i < 2; i++)
            range[i] = isnan(range[i]) ? chosen[i] : range[i];
    }
    if (!(range[0] < range[1] && isfinite(range[1] - range[0])))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s in false colour: from %g to %g is no range: it has to begin below its "
                         "end",
                         options->channel, range[0], range[1]);
    return MURK_OK;
}

/* ---- picture ------------------------------------------------------------------------------- */

static void put(murk_image *image, int x, int y, murk_color color)
{
    float *pixel = image->pixels + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
    pixel[0] = color.r;
    pixel[1] = color.g;
    pixel[2] = color.b;
}

/* Pixels take the nearest of so many colours, which lie closer than bytes can tell. */
enum { SHADES = 2048 };

static void draw_picture(const murk_image *image, int channel, const double range[2],
                         murk_image *out)
{
    murk_color shade[SHADES + 1];
    const double scale = SHADES / (range[1] - range[0]);
    for (int i = 0; i <= SHADES; i++)
        shade[i] = murk_false_color_at((double)i / SHADES);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            size_t pixel = (size_t)y * (size_t)image->width + (size_t)x;
            double value = image->pixels[pixel * (size_t)image->channels + (size_t)channel];
            double place = fmin(fmax((value - range[0]) * scale, 0), SHADES);
            put(out, x, y, isfinite(value) ? shade[(int)(place + 0.5)] : murk_false_color_at(NAN));
        }
}

/* ---- scale bar ----------------------------------------------------------------------------- */

/* Rows from the high end to the low one, each of which has its end's colour exactly. */
static void draw_bar(const struct layout *l, murk_image *out)
{
    const int rows = (int)l->bar.height;
    for (int row = 0; row < rows; row++)
        for (int x = 0; x < (int)l->bar.width; x++)
            put(out, (int)l->bar.x + x, (int)l->bar.y + row,
                murk_false_color_at(1 - (double)row / (rows - 1)));
}

static murk_status draw_number(murk_context *context, const struct layout *l, double part,
                               const char *number, murk_image *out)
{
    const double y = l->bar.y + 0.5 + (1 - part) * (l->bar.height - 1);
    const double thick = fmax(1, round(0.08 * l->size));
    const murk_rectangle tick = {l->bar.x + l->bar.width, round(y - 0.5 * thick),
                                 round(0.4 * l->size), thick};
    const murk_text text = {
        .text = number, .at = {l->numbers, y}, .align = {0, 0.5}, .size = l->size, .color = INK};
    murk_rectangle_draw(out, &tick, INK);
    return murk_text_draw(context, out, &text);
}

/* Both ends of the range have their number, and the ticks between as far as there is room. */
static murk_status draw_numbers(murk_context *context, const struct layout *l,
                                const double range[2], murk_image *out)
{
    murk_tick ticks[MURK_TICKS_MOST];
    const double room = 1.5 * l->size / l->bar.height;
    int most = (int)fmin(10, fmax(2, 0.6 / room));
    int count = murk_axis_ticks(false, range, most, ticks);
    murk_status status = MURK_OK;
    for (int end = 0; end < 2 && !status; end++) {
        char number[MURK_LABEL_SIZE];
        snprintf(number, sizeof number, "%.6g", range[end]);
        status = draw_number(context, l, end, number, out);
    }
    for (int i = 0; i < count && !status; i++) {
        double part = murk_axis_place(false, range, ticks[i].value);
        if (part > room && part < 1 - room)
            status = draw_number(context, l, part, ticks[i].label, out);
    }
    return status;
}

/* Beside the middle of the bar; smaller where it is longer than the image is high. */
static murk_status draw_label(murk_context *context, const struct layout *l, const char *label,
                              murk_image *out)
{
    int size = l->size;
    while (size > SMALLEST_LABEL && murk_text_width(label, size) > l->height - 0.5 * l->size)
        size--;
    const murk_text text = {.text = label,
                            .at = {l->label, l->bar.y + 0.5 * l->bar.height},
                            .align = {0.5, 1},
                            .size = size,
                            .upward = true,
                            .color = INK};
    return murk_text_draw(context, out, &text);
}

/* The room of the widest number; that of five digits at least, so that a sequence keeps its size.
 */
static double numbers_width(const murk_image *image, const double range[2])
{
    int size = lay_out(image, 0).size;
    double width = murk_text_width("000.00", size);
    for (int end = 0; end < 2; end++) {
        char number[MURK_LABEL_SIZE];
        snprintf(number, sizeof number, "%.6g", range[end]);
        width = fmax(width, murk_text_width(number, size));
    }
    return width;
}

murk_status murk_false_color_create(murk_context *context, const murk_image *image,
                                    const murk_false_color *options, murk_image **out)
{
    double range[2];
    murk_image *made = NULL;
    int channel = murk_image_channel(image, options->channel);
    if (channel < 0)
        return murk_fail(context, MURK_ERROR_INPUT, "the image has no channel %s",
                         options->channel);
    murk_status status = choose_range(context, image, channel, options, range);
    if (status)
        return status;
    if (!murk_text_possible())
        murk_warn(context, "the scale bar goes without text: there is no font such as that of "
                           "Debian's package fonts-dejavu-core");
    const struct layout l = lay_out(image, numbers_width(image, range));
    status = murk_canvas_create(context, l.width, l.height, &made);
    if (status)
        return status;
    draw_picture(image, channel, range, made);
    draw_bar(&l, made);
    status = draw_numbers(context, &l, range, made);
    if (!status)
        status = draw_label(context, &l, options->label ? options->label : options->channel, made);
    if (status)
        murk_image_release(made);
    else
        *out = made;
    return status;
}
