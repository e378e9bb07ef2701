/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file image.h
 * Images of named float channels, and the files that hold them. murk.h includes it.
 */
#ifndef MURK_IMAGE_H
#define MURK_IMAGE_H

#include "core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Pixels with named channels, row 0 at the top. */
typedef struct murk_image murk_image;

/** Makes an image of float channels; names are copied, pixels start at 0. Fails with
 *  MURK_ERROR_INPUT for sizes below 1 or more than 2^31 values, with MURK_ERROR_MEMORY when memory
 *  runs out. */
MURK_API murk_status murk_image_create(murk_context *context, int width, int height, int channels,
                                       const char *const *names, murk_image **out);
/** Reads any image that OpenImageIO reads, as linear floats with its channel names and those of its
 *  attributes that are text; 8-bit formats lose their sRGB curve. Fails with MURK_ERROR_INPUT for a
 *  missing, damaged or foreign file. */
MURK_API murk_status murk_image_read(murk_context *context, const char *path, murk_image **out);
/** Copies the command that an image of murk's records (murk_image_write_options), "" where there is
 *  none or it takes more than `size` bytes; the pixels are not read. Fails as murk_image_read(). */
MURK_API murk_status murk_image_command(murk_context *context, const char *path, char *text,
                                        size_t size);
/** Releases an image and all that was borrowed from it; NULL is nothing. */
MURK_API void murk_image_release(murk_image *image);
/** Pixels in a row. */
MURK_API int murk_image_width(const murk_image *image);
/** Rows. */
MURK_API int murk_image_height(const murk_image *image);
/** Values a pixel. */
MURK_API int murk_image_channels(const murk_image *image);
/** The name of a channel, 0 <= channel < channels, such as "R"; lives as long as the image. */
MURK_API const char *murk_image_channel_name(const murk_image *image, int channel);
/** All pixels: width * height * channels floats, channels of a pixel together, row 0 on top. They
 *  belong to the image, and may be written to. */
MURK_API float *murk_image_pixels(murk_image *image);
/** The same, to be read alone. */
MURK_API const float *murk_image_pixels_const(const murk_image *image);
/** Gives an image an attribute, or an attribute another text; both are copied. Fails with
 *  MURK_ERROR_INPUT for an empty name, with MURK_ERROR_MEMORY when memory runs out. */
MURK_API murk_status murk_image_set_attribute(murk_image *image, const char *name,
                                              const char *text);
/** The text of an attribute, or NULL where there is none; valid until it is set again. */
MURK_API const char *murk_image_attribute(const murk_image *image, const char *name);

/** What a file gets beside the pixels, and how bright 8-bit formats show them. */
typedef struct murk_image_write_options {
    double exposure;     /**< stops, for 8-bit formats; NaN: brings the 99th percentile of the
                              luminance to the display value 0.9 */
    bool data;           /**< 8-bit formats take R, G, B and A as they are, with exposure alone: no
                              curve, alpha neither multiplied nor divided; for textures that hold
                              numbers. EXR is not changed by it */
    const char *command; /**< recorded as metadata where the format can; may be NULL */
    const char *units;   /**< likewise, "W/m^2/sr"; may be NULL */
} murk_image_write_options;

#define MURK_IMAGE_WRITE_DEFAULT                                                                   \
    {                                                                                              \
        .exposure = NAN, .data = false, .command = NULL, .units = NULL                             \
    }

/** Writes an image; the format follows the path's extension. EXR keeps all channels as linear
 *  floats and all attributes; TIFF takes R, G, B and A as linear floats, premultiplied as they are
 *  (associated alpha), and all channels of an image without these; PNG and other 8-bit formats take
 * R, G, B with exposure and the sRGB curve, values that are not finite as 0. Written beside the
 * target, then renamed. options may be
 *  NULL. Fails with MURK_ERROR_INPUT for a format that there is none for, with MURK_ERROR_IO where
 *  the file cannot be written. */
MURK_API murk_status murk_image_write(murk_context *context, const murk_image *image,
                                      const char *path, const murk_image_write_options *options);

#ifdef __cplusplus
}
#endif
#endif
