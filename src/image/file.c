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

#define FORMAT_LIST                                                                                \
    ".exr keeps everything, .tif R, G, B and A, or .png, .jpg, .bmp, .tga or .ppm for looking at"

/* What goes into a file. */
typedef enum image_format {
    EVERYTHING,    /* all channels, as floats */
    COLOR_OPACITY, /* R, G, B and A as floats: programs take further channels of a TIFF for anything
                      or nothing. All channels where it is not a picture that has these */
    EIGHT_BIT      /* for looking at */
} image_format;

static const struct {
    const char *extension;
    image_format format;
} FORMATS[] = {{"exr", EVERYTHING}, {"tif", COLOR_OPACITY}, {"tiff", COLOR_OPACITY},
               {"png", EIGHT_BIT},  {"jpg", EIGHT_BIT},     {"jpeg", EIGHT_BIT},
               {"bmp", EIGHT_BIT},  {"tga", EIGHT_BIT},     {"ppm", EIGHT_BIT}};

/* The format that path names; fails where murk writes no such format. */
static murk_status find_format(murk_context *context, const char *path, image_format *out)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    if (!dot || dot == name)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: no file extension to tell the image format by: " FORMAT_LIST, path);
    for (size_t i = 0; i < sizeof FORMATS / sizeof *FORMATS; i++)
        if (!strcasecmp(dot + 1, FORMATS[i].extension)) {
            *out = FORMATS[i].format;
            return MURK_OK;
        }
    return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot write %s images: " FORMAT_LIST, path,
                     dot);
}

murk_status murk_output_check(murk_context *context, const char *path)
{
    size_t length = strlen(path);
    image_format format;
    bool vdb = length > 4 && !strcasecmp(path + length - 4, ".vdb");
    if (!strcmp(path, "-"))
        return MURK_OK;
    murk_status status = vdb ? MURK_OK : find_format(context, path, &format);
    return status == MURK_OK ? murk_beside_check(context, path) : status;
}

static murk_status check_readable(murk_context *context, const char *path)
{
    struct stat what;
    if (stat(path, &what) != 0 || access(path, R_OK) != 0)
        return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot read: %s", path, strerror(errno));
    if (S_ISDIR(what.st_mode))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: is a folder, not an image", path);
    return MURK_OK;
}

murk_status murk_image_read(murk_context *context, const char *path, murk_image **out)
{
    murk_status status = check_readable(context, path);
    return status == MURK_OK ? murk_oiio_read(context, path, out) : status;
}

murk_status murk_image_command(murk_context *context, const char *path, char *text, size_t size)
{
    murk_status status = check_readable(context, path);
    return status == MURK_OK ? murk_oiio_command(context, path, text, size) : status;
}

enum { COLOR_CHANNELS = 4 };
static const char *const COLOR_NAMES[COLOR_CHANNELS] = {"R", "G", "B", "A"};

/* A copy of these channels, to be freed; none where the image does not have them. False when memory
   runs out. */
static bool take_color(const murk_image *image, float **out)
{
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    int channel[COLOR_CHANNELS];
    for (int c = 0; c < COLOR_CHANNELS; c++)
        if ((channel[c] = murk_image_channel(image, COLOR_NAMES[c])) < 0)
            return true;
    float *color = murk_alloc(pixels * COLOR_CHANNELS, sizeof *color);
    for (size_t p = 0; color && p < pixels; p++)
        for (int c = 0; c < COLOR_CHANNELS; c++)
            color[p * COLOR_CHANNELS + (size_t)c] =
                image->pixels[p * (size_t)image->channels + (size_t)channel[c]];
    *out = color;
    return color;
}

/* The bytes of a file for looking at, from malloc. */
static murk_status encode_display(murk_context *context, const murk_image *image, const char *path,
                                  const murk_image_write_options *options, void **bytes,
                                  size_t *size)
{
    uint8_t *display = murk_alloc((size_t)image->width * image->height, COLOR_CHANNELS);
    if (!display)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    double exposure = isnan(options->exposure) ? murk_display_exposure(image) : options->exposure;
    const bool data = options->data && murk_display_data(image, exposure, display);
    if (!data)
        murk_display_encode(image, exposure, display);
    const murk_oiio_pixels pixels = {
        .width = image->width,
        .height = image->height,
        .channels = data ? COLOR_CHANNELS : 3,
        .data = data,
        .names = COLOR_NAMES,
        .bytes = display,
        .command = options->command,
        .units = options->units,
    };
    murk_status status = murk_oiio_encode(context, path, &pixels, bytes, size);
    murk_free(display);
    return status;
}

/* The file's bytes, from malloc. */
static murk_status image_encode(murk_context *context, const murk_image *image, const char *path,
                                image_format format, const murk_image_write_options *options,
                                void **bytes, size_t *size)
{
    if (format == EIGHT_BIT)
        return encode_display(context, image, path, options, bytes, size);
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
    float *color = NULL;
    if (format == COLOR_OPACITY && !take_color(image, &color))
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    if (color) {
        pixels.channels = COLOR_CHANNELS;
        pixels.names = COLOR_NAMES;
        pixels.floats = color;
    }
    murk_status status = murk_oiio_encode(context, path, &pixels, bytes, size);
    murk_free(color);
    return status;
}

murk_status murk_image_write(murk_context *context, const murk_image *image, const char *path,
                             const murk_image_write_options *options)
{
    static const murk_image_write_options DEFAULTS = MURK_IMAGE_WRITE_DEFAULT;
    image_format format;
    void *bytes = NULL;
    size_t size = 0;
    murk_status status = find_format(context, path, &format);
    if (status == MURK_OK)
        status = image_encode(context, image, path, format, options ? options : &DEFAULTS, &bytes,
                              &size);
    if (status == MURK_OK)
        status = murk_file_write(context, path, bytes, size);
    free(bytes);
    return status;
}
