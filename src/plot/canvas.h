/* SPDX-License-Identifier: Apache-2.0 */
/* What all drawing comes down to: colour on a pixel, in part. */
#ifndef MURK_PLOT_CANVAS_H
#define MURK_PLOT_CANVAS_H

#include "murk/plot.h"

/* An image's channels, and the part of it that may be drawn on. */
typedef struct murk_canvas {
    float *pixels;
    int width, channels;
    int channel[4];   /* R, G, B, A; A -1 where there is none */
    int lo[2], hi[2]; /* pixels, hi exclusive */
} murk_canvas;

/* clip NULL: all of the image. False where the image has no R, G and B. */
bool murk_canvas_open(murk_image *image, const murk_rectangle *clip, murk_canvas *out);

/* Covers a part in [0, 1] of a pixel. The mixing is one of displayed values, as text and thin lines
   are made for. */
void murk_canvas_cover(const murk_canvas *canvas, int x, int y, double part, murk_color color);

/* murk_line_draw() on a part of the image. */
void murk_canvas_line(const murk_canvas *canvas, const double from[2], const double to[2],
                      double width, murk_color color);

#endif
