/* SPDX-License-Identifier: Apache-2.0 */
/* Image files: which formats there are, and what goes into each. */
#include "beside.h"
#include "context.h"
#include "image.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#define EIGHT_BIT_LIST ".png, .jpg, .bmp, .tga or .ppm"

/* Whether path names an 8-bit format; fails where murk writes no such format. */
static murk_status image_format(murk_context *context, const char *path, bool *eight_bit)
{
    static const char *const EIGHT_BIT[] = {"png", "jpg", "jpeg", "bmp", "tga", "ppm"};
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    if (!dot || dot == name)
        return murk_fail(
            context, MURK_ERROR_INPUT,
            "%s: no file extension to tell the image format by: .exr keeps everything, "
            "or " EIGHT_BIT_LIST " for looking at",
            path);
    *eight_bit = false;
    if (!strcasecmp(dot + 1, "exr"))
        return MURK_OK;
    *eight_bit = true;
    for (size_t i = 0; i < sizeof EIGHT_BIT / sizeof *EIGHT_BIT; i++)
        if (!strcasecmp(dot + 1, EIGHT_BIT[i]))
            return MURK_OK;
    return murk_fail(context, MURK_ERROR_INPUT,
                     "%s: cannot write %s images: .exr keeps everything, or " EIGHT_BIT_LIST
                     " for looking at",
                     path, dot);
}

murk_status murk_output_check(murk_context *context, const char *path)
{
    size_t length = strlen(path);
    bool eight_bit, vdb = length > 4 && !strcasecmp(path + length - 4, ".vdb");
    if (!strcmp(path, "-"))
        return MURK_OK;
    murk_status status = vdb ? MURK_OK : image_format(context, path, &eight_bit);
    return status == MURK_OK ? murk_beside_check(context, path) : status;
}

murk_status murk_image_read(murk_context *context, const char *path, murk_image **out)
{
    struct stat what;
    if (stat(path, &what) != 0 || access(path, R_OK) != 0)
        return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot read: %s", path, strerror(errno));
    if (S_ISDIR(what.st_mode))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: is a folder, not an image", path);
    return murk_oiio_read(context, path, out);
}

/* The file's bytes, from malloc. */
static murk_status image_encode(murk_context *context, const murk_image *image, const char *path,
                                bool eight_bit, const murk_image_write_options *options,
                                void **bytes, size_t *size)
{
    murk_oiio_pixels pixels = {
        .width = image->width,
        .height = image->height,
        .channels = image->channels,
        .names = (const char *const *)image->names,
        .floats = image->pixels,
        .attributes = image->attributes,
        .command = options->command,
        .units = options->units,
    };
    if (!eight_bit)
        return murk_oiio_encode(context, path, &pixels, bytes, size);

    static const char *const RGBA[] = {"R", "G", "B", "A"};
    uint8_t *display = murk_alloc((size_t)image->width * image->height, 4);
    if (!display)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    double exposure = isnan(options->exposure) ? murk_display_exposure(image) : options->exposure;
    pixels.data = options->data && murk_display_data(image, exposure, display);
    if (!pixels.data)
        murk_display_encode(image, exposure, display);
    pixels.channels = pixels.data ? 4 : 3;
    pixels.names = RGBA;
    pixels.floats = NULL;
    pixels.attributes = NULL;
    pixels.bytes = display;
    murk_status status = murk_oiio_encode(context, path, &pixels, bytes, size);
    murk_free(display);
    return status;
}

murk_status murk_image_write(murk_context *context, const murk_image *image, const char *path,
                             const murk_image_write_options *options)
{
    static const murk_image_write_options DEFAULTS = MURK_IMAGE_WRITE_DEFAULT;
    bool eight_bit;
    void *bytes = NULL;
    size_t size = 0;
    murk_status status = image_format(context, path, &eight_bit);
    if (status == MURK_OK)
        status = image_encode(context, image, path, eight_bit, options ? options : &DEFAULTS,
                              &bytes, &size);
    if (status == MURK_OK)
        status = murk_file_write(context, path, bytes, size);
    free(bytes);
    return status;
}
