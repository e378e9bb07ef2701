/* SPDX-License-Identifier: Apache-2.0 */
#include "pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static murk_status take_channel(const murk_image *image, double max, float **out, char *message,
                                size_t room)
{
    int width = murk_image_width(image), channels = murk_image_channels(image);
    size_t count = (size_t)width * murk_image_height(image);
    const float *pixels = murk_image_pixels_const(image);
    float *values = malloc(count * sizeof *values);
    if (!values) {
        snprintf(message, room, "out of memory");
        return MURK_ERROR_MEMORY;
    }
    for (size_t p = 0; p < count; p++) {
        values[p] = pixels[p * channels];
        if (isfinite(values[p]) && values[p] >= 0.0f && values[p] <= max)
            continue;
        snprintf(message, room, "pixel (%zu, %zu) is %g, not %s", p % width, p / width,
                 (double)values[p], max <= 1.0 ? "between 0 and 1" : "a finite number >= 0");
        free(values);
        return MURK_ERROR_INPUT;
    }
    *out = values;
    return MURK_OK;
}

murk_status scene_read_pixels(murk_context *context, const struct scene_description *description,
                              const char *key, const char *file, double max, int size[2],
                              float **out, char message[SCENE_MESSAGE_SIZE])
{
    murk_image *image = NULL;
    char *path = scene_path(description, file);
    int used = snprintf(message, SCENE_MESSAGE_SIZE, "%s: %s: ", description->path, key);
    size_t room = SCENE_MESSAGE_SIZE - (size_t)used;
    if (used >= SCENE_MESSAGE_SIZE || !path) {
        free(path);
        return MURK_ERROR_MEMORY;
    }
    murk_status status = murk_image_read(context, path, &image);
    if (status != MURK_OK) {
        snprintf(message + used, room, "%s", murk_context_message(context));
        free(path);
        return status;
    }
    int found[2] = {murk_image_width(image), murk_image_height(image)};
    int prefix = snprintf(message + used, room, "%s: ", path);
    free(path);
    if ((size_t)prefix >= room)
        prefix = 0;
    if (size[0] != 0 && (size[0] != found[0] || size[1] != found[1])) {
        snprintf(message + used + prefix, room - (size_t)prefix,
                 "has %d x %d pixels, but the ground has %d x %d patches; pixels fall on patches",
                 found[0], found[1], size[0], size[1]);
        status = MURK_ERROR_INPUT;
    } else {
        status = take_channel(image, max, out, message + used + prefix, room - (size_t)prefix);
    }
    if (status == MURK_OK) {
        size[0] = found[0];
        size[1] = found[1];
    }
    murk_image_release(image);
    return status;
}
