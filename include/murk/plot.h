/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file plot.h
 * Drawing on images: lines, rectangles and text, and plots of curves. Everything is in pixels; the
 * point (0, 0) is the top left corner of the image, pixel (i, j) covers [i, i + 1] x [j, j + 1].
 * Shapes have smooth edges, and are cut at the edges of the image. Colours go to the channels R, G,
 * B, and A becomes opaque where there is one; other channels stay as they are, and an image without
 * R, G and B is left alone. What is drawn shows in its colours where murk_image_write() is told the
 * exposure 0.
 */
#ifndef MURK_PLOT_H
#define MURK_PLOT_H

#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Red, green and blue in [0, 1], as linear light. */
typedef struct murk_color {
    float r, g, b;
} murk_color;

/** From what is written in hexadecimal as 0xRRGGBB on the sRGB curve. */
MURK_API murk_color murk_color_srgb(uint32_t rgb);

/** A rectangle with upright sides. */
typedef struct murk_rectangle {
    double x, y, width, height; /**< (x, y) is the top left corner */
} murk_rectangle;

/** Makes a white image with the channels R, G, B and A to draw on. */
MURK_API murk_status murk_canvas_create(murk_context *context, int width, int height,
                                        murk_image **out);

/** Fills a rectangle. */
MURK_API void murk_rectangle_draw(murk_image *image, const murk_rectangle *rectangle,
                                  murk_color color);

/** A straight line with round ends; with both ends at one point it is a disc. */
MURK_API void murk_line_draw(murk_image *image, const double from[2], const double to[2],
                             double width, murk_color color);

/** A line of text to draw; the text is borrowed for the call. */
typedef struct murk_text {
    const char *text; /**< one line of ASCII; digits and signs that follow a ^ are raised: m^2 */
    double at[2];     /**< where `align` is put */
    double align[2];  /**< point of the text: 0 its left end ... 1 its right end; 0 the top of its
                           digits ... 1 the line it stands on */
    int size;         /**< of the font */
    bool upward;      /**< turned to read from below; align turns with it */
    murk_color color;
} murk_text;

/** Whether there is a font to draw text in; without one murk_text_draw() draws nothing, and
 *  murk_plot_draw() warns that it goes without text. */
MURK_API bool murk_text_possible(void);

/** Draws a line of text. Fails with MURK_ERROR_INTERNAL for a font that cannot be used, with
 *  MURK_ERROR_MEMORY when memory runs out. */
MURK_API murk_status murk_text_draw(murk_context *context, murk_image *image,
                                    const murk_text *text);

/** The width that a text takes; 0 where there is no font. */
MURK_API double murk_text_width(const char *text, int size);

/** An axis of a plot. */
typedef struct murk_axis {
    const char *label; /**< what it shows, with its unit; may be NULL */
    bool log;          /**< logarithmic: values that are not positive are left out */
    double min, max;   /**< where it begins and ends; both 0: such that all points are on it */
} murk_axis;

/** A curve through count points; it has gaps where a value is not finite. */
typedef struct murk_curve {
    const char *name; /**< in the legend; NULL: not in it */
    size_t count;
    const double *x, *y;
    murk_color color;
    double width;             /**< of the line; 0: none */
    double marker;            /**< diameter of the discs at the points; 0: none */
    const char *const *label; /**< what stands beside each point, or NULL; NULL: nothing at all */
} murk_curve;

/** Everything is borrowed. */
typedef struct murk_plot {
    const char *title; /**< may be NULL */
    murk_axis x, y;
    const murk_curve *curve;
    size_t curve_count;
    int text_size; /**< of the font; 0: 16 */
} murk_plot;

/** Draws a plot with its title, axes and legend into a rectangle of an image. Fails with
 *  MURK_ERROR_INPUT where a logarithmic axis does not begin above 0. */
MURK_API murk_status murk_plot_draw(murk_context *context, murk_image *image,
                                    const murk_rectangle *rectangle, const murk_plot *plot);

/** The n-th of eight colours that stay apart for colour-blind readers too (n from 0; the ninth is
 *  the first again). */
MURK_API murk_color murk_plot_color(int n);

#ifdef __cplusplus
}
#endif
#endif
