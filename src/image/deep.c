/* SPDX-License-Identifier: Apache-2.0 */
#include "deep.h"

#include "context.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static size_t strips(const murk_deep *deep)
{
    return ((size_t)deep->height + (size_t)deep->strip_rows - 1) / (size_t)deep->strip_rows;
}

murk_status murk_deep_create(murk_context *context, int width, int height, int strip_rows,
                             murk_deep **out)
{
    murk_deep *deep = murk_alloc(1, sizeof *deep);
    if (deep) {
        const size_t pixels = (size_t)width * (size_t)height;
        deep->width = width;
        deep->height = height;
        deep->strip_rows = strip_rows;
        deep->strip = murk_alloc(strips(deep), sizeof *deep->strip);
        deep->first = murk_alloc(pixels, sizeof *deep->first);
        deep->count = murk_alloc(pixels, sizeof *deep->count);
    }
    if (!deep || !deep->strip || !deep->first || !deep->count) {
        murk_deep_release(deep);
        return murk_fail(context, MURK_ERROR_MEMORY,
                         "out of memory for a deep picture of %d x %d pixels", width, height);
    }
    *out = deep;
    return MURK_OK;
}

void murk_deep_release(murk_deep *deep)
{
    if (!deep)
        return;
    for (size_t n = 0; deep->strip && n < strips(deep); n++)
        murk_free(deep->strip[n].sample);
    murk_free(deep->strip);
    murk_free(deep->first);
    murk_free(deep->count);
    murk_free(deep);
}

bool murk_deep_append(murk_deep *deep, int i, int j, const murk_deep_sample *sample)
{
    murk_deep_strip *strip = &deep->strip[j / deep->strip_rows];
    const size_t pixel = (size_t)j * (size_t)deep->width + (size_t)i;
    if (strip->count == strip->capacity) {
        size_t capacity = 2 * strip->capacity + 1024;
        if (!murk_enlarge(&strip->sample, strip->count, capacity, sizeof *strip->sample))
            return false;
        strip->capacity = capacity;
    }
    if (deep->count[pixel]++ == 0)
        deep->first[pixel] = strip->count;
    strip->sample[strip->count++] = *sample;
    return true;
}

void murk_deep_size(const murk_deep *deep, int size[2])
{
    size[0] = deep->width;
    size[1] = deep->height;
}

size_t murk_deep_samples(const murk_deep *deep, int i, int j, const murk_deep_sample **samples)
{
    const size_t pixel = (size_t)j * (size_t)deep->width + (size_t)i;
    if (deep->count[pixel])
        *samples = deep->strip[j / deep->strip_rows].sample + deep->first[pixel];
    return deep->count[pixel];
}

murk_status murk_deep_write(murk_context *context, const murk_deep *deep, const char *path,
                            const murk_image_write_options *options)
{
    static const murk_image_write_options DEFAULTS = MURK_IMAGE_WRITE_DEFAULT;
    const size_t length = strlen(path);
    void *bytes = NULL;
    size_t size = 0;
    if (length < 5 || strcasecmp(path + length - 4, ".exr"))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: deep pictures are written as .exr alone",
                         path);
    murk_status status =
        murk_oiio_encode_deep(context, path, deep, options ? options : &DEFAULTS, &bytes, &size);
    if (status == MURK_OK)
        status = murk_file_write(context, path, bytes, size);
    free(bytes);
    return status;
}
