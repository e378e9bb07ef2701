/* SPDX-License-Identifier: Apache-2.0 */
/* Rectangles and lines, by the part of each pixel that they cover. */
#include "canvas.h"

#include "image.h"

#include <math.h>

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

murk_color murk_color_srgb(uint32_t rgb)
{
    float light[3];
    for (int c = 0; c < 3; c++)
        light[c] = (float)murk_display_linear((double)(rgb >> (16 - 8 * c) & 255) / 255);
    return (murk_color){light[0], light[1], light[2]};
}

murk_status murk_canvas_create(murk_context *context, int width, int height, murk_image **out)
{
    static const char *const NAMES[] = {"R", "G", "B", "A"};
    murk_status status = murk_image_create(context, width, height, 4, NAMES, out);
    if (status)
        return status;
    for (size_t i = 0; i < (size_t)width * (size_t)height * 4; i++)
        (*out)->pixels[i] = 1;
    return MURK_OK;
}

bool murk_canvas_open(murk_image *image, const murk_rectangle *clip, murk_canvas *out)
{
    static const char *const NAMES[4] = {"R", "G", "B", "A"};
    const double size[2] = {image->width, image->height};
    const double lo[2] = {clip ? clip->x : 0, clip ? clip->y : 0};
    const double extent[2] = {clip ? clip->width : size[0], clip ? clip->height : size[1]};
    out->pixels = image->pixels;
    out->width = image->width;
    out->channels = image->channels;
    for (int c = 0; c < 4; c++)
        out->channel[c] = murk_image_channel(image, NAMES[c]);
    for (int a = 0; a < 2; a++) {
        out->lo[a] = (int)clamp(round(lo[a]), 0, size[a]);
        out->hi[a] = (int)clamp(round(lo[a] + extent[a]), 0, size[a]);
    }
    return out->channel[0] >= 0 && out->channel[1] >= 0 && out->channel[2] >= 0;
}

void murk_canvas_cover(const murk_canvas *canvas, int x, int y, double part, murk_color color)
{
    if (!(part > 0) || x < canvas->lo[0] || x >= canvas->hi[0] || y < canvas->lo[1] ||
        y >= canvas->hi[1])
        return;
    float *pixel =
        canvas->pixels + ((size_t)y * (size_t)canvas->width + (size_t)x) * (size_t)canvas->channels;
    const float light[3] = {color.r, color.g, color.b};
    for (int c = 0; c < 3; c++) {
        float *value = &pixel[canvas->channel[c]];
        double below = murk_display_value(*value), above = murk_display_value(light[c]);
        *value = part < 1 ? (float)murk_display_linear(below + part * (above - below)) : light[c];
    }
    if (canvas->channel[3] >= 0) {
        float *alpha = &pixel[canvas->channel[3]];
        *alpha += (float)part * (1 - *alpha);
    }
}

void murk_rectangle_draw(murk_image *image, const murk_rectangle *rectangle, murk_color color)
{
    murk_canvas canvas;
    if (!murk_canvas_open(image, NULL, &canvas))
        return;
    const double lo[2] = {rectangle->x, rectangle->y};
    const double hi[2] = {lo[0] + rectangle->width, lo[1] + rectangle->height};
    int first[2], last[2];
    for (int a = 0; a < 2; a++) {
        first[a] = (int)clamp(floor(lo[a]), canvas.lo[a], canvas.hi[a]);
        last[a] = (int)clamp(ceil(hi[a]), canvas.lo[a], canvas.hi[a]);
    }
    for (int y = first[1]; y < last[1]; y++)
        for (int x = first[0]; x < last[0]; x++) {
            double wide = fmin(hi[0], x + 1) - fmax(lo[0], x);
            double high = fmin(hi[1], y + 1) - fmax(lo[1], y);
            murk_canvas_cover(&canvas, x, y, fmax(0, wide) * fmax(0, high), color);
        }
}

/* Distance of a point from the line from a to b. */
static double distance(double x, double y, const double a[2], const double b[2])
{
    double u = b[0] - a[0], v = b[1] - a[1], square = u * u + v * v;
    double t = square > 0 ? clamp(((x - a[0]) * u + (y - a[1]) * v) / square, 0, 1) : 0;
    return hypot(x - a[0] - t * u, y - a[1] - t * v);
}

void murk_canvas_line(const murk_canvas *canvas, const double from[2], const double to[2],
                      double width, murk_color color)
{
    double reach = 0.5 * width + 0.5;
    int first[2], last[2];
    for (int a = 0; a < 2; a++) {
        first[a] = (int)clamp(floor(fmin(from[a], to[a]) - reach), canvas->lo[a], canvas->hi[a]);
        last[a] = (int)clamp(ceil(fmax(from[a], to[a]) + reach), canvas->lo[a], canvas->hi[a]);
    }
    for (int y = first[1]; y < last[1]; y++)
        for (int x = first[0]; x < last[0]; x++) {
            double part = reach - distance(x + 0.5, y + 0.5, from, to);
            murk_canvas_cover(canvas, x, y, clamp(part, 0, fmin(1, width)), color);
        }
}

void murk_line_draw(murk_image *image, const double from[2], const double to[2], double width,
                    murk_color color)
{
    murk_canvas canvas;
    if (murk_canvas_open(image, NULL, &canvas))
        murk_canvas_line(&canvas, from, to, width, color);
}
