/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file false_color.h
 * Pictures of a quantity in false colour, with a scale bar: temperatures, depths, transmittances.
 *
 * The colours run from a dark violet over red and orange to a pale yellow, so that what is hot is
 * bright. They are made in OKLab (B. Ottosson, "A perceptual color space for image processing",
 * 2020), where equal steps look equal: the lightness L rises in proportion to the value from 0.16
 * to 0.97, and the chroma and hue run on a Catmull-Rom spline through seven points, which keeps
 * within what sRGB can show. A picture printed in grey is therefore still in the right order.
 */
#ifndef MURK_FALSE_COLOR_H
#define MURK_FALSE_COLOR_H

#include "plot.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The colour of a value at a part of the range, 0 its low end ... 1 its high end, clipped there;
 *  grey for NaN. */
MURK_API murk_color murk_false_color_at(double part);

/** What to show, and how; texts are borrowed for the call. */
typedef struct murk_false_color {
    const char *channel; /**< of the image */
    double low, high;    /**< the ends of the scale bar; what lies beyond has the end's colour. NaN:
                              chosen, such that the 1st to the 99th percentile of the finite values
                              is within, and a round number */
    const char *label;   /**< beside the scale bar, with the unit: "LWIR apparent temperature [K]";
                              NULL: the channel's name */
} murk_false_color;

/**
 * Makes an image with the channels R, G, B, A to be looked at (murk_image_write() with the exposure
 * 0): at the top left the channel in false colour, pixel by pixel, values that are not finite in
 * grey; to the right of it the scale bar with ticks, numbers and the label. Text and bar grow with
 * the picture's height; a picture too low for them (some 120 pixels) gets white below. Its size
 * depends on that of the picture, not on the range, as long as the numbers have up to 5 digits.
 * Warns where there is no font, and goes without text. Fails with MURK_ERROR_INPUT where there is
 * no such channel and where low is not below high.
 */
MURK_API murk_status murk_false_color_create(murk_context *context, const murk_image *image,
                                             const murk_false_color *options, murk_image **out);

#ifdef __cplusplus
}
#endif
#endif
