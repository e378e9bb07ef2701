/* SPDX-License-Identifier: Apache-2.0 */
/* Images in memory. */
#include "image.h"

#include "context.h"

#include <string.h>

static murk_status image_allocate(murk_image *image, const char *const *names)
{
    image->pixels =
        murk_alloc((size_t)image->width * image->height * image->channels, sizeof(float));
    image->names = murk_alloc(image->channels, sizeof *image->names);
    if (!image->pixels || !image->names)
        return MURK_ERROR_MEMORY;
    for (int c = 0; c < image->channels; c++) {
        size_t size = strlen(names[c]) + 1;
        image->names[c] = murk_alloc(size, 1);
        if (!image->names[c])
            return MURK_ERROR_MEMORY;
        memcpy(image->names[c], names[c], size);
    }
    return MURK_OK;
}

murk_status murk_image_create(murk_context *context, int width, int height, int channels,
                              const char *const *names, murk_image **out)
{
    if (width < 1 || height < 1 || channels < 1)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "image of %d x %d pixels, %d channels: each must be at least 1", width,
                         height, channels);
    if ((uint64_t)width * (uint64_t)height > MURK_IMAGE_VALUES_MAX / (uint64_t)channels)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "image of %d x %d pixels, %d channels: more than 2^31 values", width,
                         height, channels);
    murk_image *image = murk_alloc(1, sizeof *image);
    if (image) {
        image->width = width;
        image->height = height;
        image->channels = channels;
    }
    if (!image || image_allocate(image, names) != MURK_OK) {
        murk_image_release(image);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for an image of %d x %d pixels",
                         width, height);
    }
    *out = image;
    return MURK_OK;
}

void murk_image_release(murk_image *image)
{
    if (!image)
        return;
    for (int c = 0; image->names && c < image->channels; c++)
        murk_free(image->names[c]);
    murk_free(image->names);
    murk_free(image->pixels);
    murk_attributes_release(image->attributes);
    murk_free(image);
}

int murk_image_width(const murk_image *image)
{
    return image->width;
}

int murk_image_height(const murk_image *image)
{
    return image->height;
}

int murk_image_channels(const murk_image *image)
{
    return image->channels;
}

const char *murk_image_channel_name(const murk_image *image, int channel)
{
    return channel >= 0 && channel < image->channels ? image->names[channel] : NULL;
}

int murk_image_channel(const murk_image *image, const char *name)
{
    for (int c = 0; c < image->channels; c++)
        if (!strcmp(image->names[c], name))
            return c;
    return -1;
}

float *murk_image_pixels(murk_image *image)
{
    return image->pixels;
}

const float *murk_image_pixels_const(const murk_image *image)
{
    return image->pixels;
}
