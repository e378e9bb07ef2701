/* SPDX-License-Identifier: Apache-2.0 */
/* A deep picture in memory. */
#ifndef MURK_IMAGE_DEEP_H
#define MURK_IMAGE_DEEP_H

#include "image.h"
#include "murk/deep.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The samples of some of the rows together, in any order. */
typedef struct murk_deep_strip {
    murk_deep_sample *sample;
    size_t count, capacity;
} murk_deep_strip;

struct murk_deep {
    int width, height, strip_rows;
    murk_deep_strip *strip; /* of rows strip_rows * n and following */
    size_t *first;          /* of each pixel in its strip */
    uint32_t *count;        /* of each pixel */
};

/* A picture without samples. */
murk_status murk_deep_create(murk_context *context, int width, int height, int strip_rows,
                             murk_deep **out);

/* Adds a sample to the strip of a pixel, all of whose samples come one after another. False when
   memory runs out. */
bool murk_deep_append(murk_deep *deep, int i, int j, const murk_deep_sample *sample);

/* The bytes of a deep EXR, in *bytes from malloc. */
murk_status murk_oiio_encode_deep(murk_context *context, const char *path, const murk_deep *deep,
                                  const murk_image_write_options *options, void **bytes,
                                  size_t *size) MURK_IMAGE_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
