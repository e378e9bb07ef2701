/* SPDX-License-Identifier: Apache-2.0 */
/* The image inside the library, and the thin C face of OpenImageIO. */
#ifndef MURK_IMAGE_IMAGE_H
#define MURK_IMAGE_IMAGE_H

#include "murk/murk.h"

#ifdef __cplusplus
#define MURK_IMAGE_NOEXCEPT noexcept
extern "C" {
#else
#define MURK_IMAGE_NOEXCEPT
#endif

/* In the order of their first setting. */
typedef struct murk_attribute {
    char *name, *text;
    struct murk_attribute *next;
} murk_attribute;

struct murk_image {
    int width, height, channels;
    char **names;
    float *pixels;
    murk_attribute *attributes;
};

void murk_attributes_release(murk_attribute *first);

/* More values than this in one image are taken for a damaged header. */
#define MURK_IMAGE_VALUES_MAX ((uint64_t)1 << 31)

/* Channel number by name, or -1. */
int murk_image_channel(const murk_image *image, const char *name);

/* What a picture for looking at is made of: R, G, B by name; without them Y or else the first
   channel for all three. Each of width * height pixels gets 3 bytes: 2^exposure times the value,
   clipped, on the sRGB curve; values that are not finite become 0. */
void murk_display_encode(const murk_image *image, double exposure, uint8_t *rgb);

/* The bytes of data: of each pixel R, G, B times 2^exposure, and A, clipped. False where the image
   lacks one of them. */
bool murk_display_data(const murk_image *image, double exposure, uint8_t *rgba);

/* The sRGB curve between linear light and what a display is told, both in [0, 1]. */
double murk_display_value(double light);
double murk_display_linear(double value);

/* The exposure in stops that brings the 99th percentile of the luminance, over the pixels that have
   any, to the display value 0.9; 0 for a black image. Depends on the pixels alone. */
double murk_display_exposure(const murk_image *image);

/* Pixels as OpenImageIO is to store them. */
typedef struct murk_oiio_pixels {
    int width, height, channels;
    const char *const *names;
    const float *floats;              /* stored as linear floats, or NULL */
    const uint8_t *bytes;             /* stored as sRGB bytes where floats is NULL */
    bool data;                        /* the bytes are no colours */
    const murk_attribute *attributes; /* metadata; may be NULL */
    const char *command, *units;      /* likewise */
} murk_oiio_pixels;

/* Reads the whole display window as linear floats, if the file can hold what it claims. */
murk_status murk_oiio_read(murk_context *context, const char *path,
                           murk_image **out) MURK_IMAGE_NOEXCEPT;

/* The text of an image file's "murk:command", "" where there is none or it is too long. */
murk_status murk_oiio_command(murk_context *context, const char *path, char *text,
                              size_t size) MURK_IMAGE_NOEXCEPT;

/* The bytes of an image file in the format of path's extension, in *bytes from malloc. */
murk_status murk_oiio_encode(murk_context *context, const char *path,
                             const murk_oiio_pixels *pixels, void **bytes,
                             size_t *size) MURK_IMAGE_NOEXCEPT;

/* The pixels that a line of text covers; top is that of the first row, negative above the line that
   the text stands on. */
typedef struct murk_oiio_box {
    int width, height, top;
} murk_oiio_box;

/* False where the font file cannot be used. */
bool murk_oiio_text_box(const char *font, const char *text, int size,
                        murk_oiio_box *out) MURK_IMAGE_NOEXCEPT;

/* The part of each pixel of the box that the text covers, from malloc. */
murk_status murk_oiio_text_cover(murk_context *context, const char *font, const char *text,
                                 int size, const murk_oiio_box *box,
                                 float **out) MURK_IMAGE_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
