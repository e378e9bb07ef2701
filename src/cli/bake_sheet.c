/* SPDX-License-Identifier: Apache-2.0 */
#include "bake_sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHANNELS = 4, ALPHA = 3, GLOW = 6 };
static const char *const HALF[2] = {"positive", "negative"};

murk_status cli_bake_sheet_create(struct cli_job *job, const int cell[2], const int cells[2],
                                  struct cli_bake_sheet *out)
{
    static const char *const NAMES[CHANNELS] = {"R", "G", "B", "A"};
    *out = (struct cli_bake_sheet){.cell = {cell[0], cell[1]}, .columns = cells[0]};
    murk_status status = MURK_OK;
    for (int h = 0; h < 2 && status == MURK_OK; h++)
        status = murk_image_create(job->context, cell[0] * cells[0], cell[1] * cells[1], CHANNELS,
                                   NAMES, &out->half[h]);
    return cli_job_fail(job, status);
}

void cli_bake_sheet_clear(struct cli_bake_sheet *sheet)
{
    for (int h = 0; h < 2; h++)
        murk_image_release(sheet->half[h]);
    *sheet = (struct cli_bake_sheet){0};
}

static int channel_of(const murk_image *picture, const char *name)
{
    int c = 0;
    while (strcmp(murk_image_channel_name(picture, c), name))
        c++;
    return c;
}

void cli_bake_sheet_put(struct cli_bake_sheet *sheet, int at, int channel,
                        const murk_image *picture)
{
    const int light = channel_of(picture, "path.R"), opacity = channel_of(picture, "A");
    const int channels = murk_image_channels(picture), half = channel >= 3;
    const size_t width = (size_t)murk_image_width(sheet->half[0]);
    const float *from = murk_image_pixels_const(picture);
    float *positive = murk_image_pixels(sheet->half[0]), *to = murk_image_pixels(sheet->half[half]);
    for (int y = 0; y < sheet->cell[1]; y++)
        for (int x = 0; x < sheet->cell[0]; x++, from += channels) {
            size_t row = (size_t)(at / sheet->columns * sheet->cell[1] + y);
            size_t pixel = row * width + (size_t)(at % sheet->columns * sheet->cell[0] + x);
            to[CHANNELS * pixel + (size_t)(channel == GLOW ? ALPHA : channel % 3)] = from[light];
            positive[CHANNELS * pixel + ALPHA] = from[opacity];
        }
}

/* "smoke.png" to "smoke_positive.png", from malloc. */
static char *half_path(const char *path, int half)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
    int stem = dot ? (int)(dot - path) : (int)strlen(path);
    size_t size = strlen(path) + strlen(HALF[half]) + 2;
    char *name = malloc(size);
    if (name)
        snprintf(name, size, "%.*s_%s%s", stem, path, HALF[half], path + stem);
    return name;
}

murk_status cli_bake_sheet_check(struct cli_job *job, const char *path)
{
    if (!cli_has_extension(path, ".png") && !cli_has_extension(path, ".tga") &&
        !cli_has_extension(path, ".exr")) {
        cli_error(&job->terminal, "-o %s: the textures need four channels: .png, .tga or .exr",
                  path);
        return MURK_ERROR_INPUT;
    }
    return cli_job_fail(job, murk_output_check(job->context, path));
}

/* The glow is a mask: 1 where it is most. Where nothing glows it is 1 everywhere, for many a tool
   loses the colours under an alpha of 0. */
static void normalise_glow(float *pixels, size_t count)
{
    float most = 0;
    for (size_t p = 0; p < count; p++)
        most = fmaxf(most, pixels[CHANNELS * p + ALPHA]);
    for (size_t p = 0; p < count; p++) {
        float *glow = &pixels[CHANNELS * p + ALPHA];
        *glow = most > 0 ? *glow / most : 1;
    }
}

static void divide(float *pixels, const float *opacity, size_t count)
{
    for (size_t p = 0; p < count; p++)
        for (int c = 0; c < 3; c++)
            if (opacity[p] > 0)
                pixels[CHANNELS * p + c] /= opacity[p];
}

static void warn_clipped(struct cli_job *job, const float *pixels, size_t count, double exposure,
                         const char *path)
{
    size_t clipped = 0;
    float most = 0;
    for (size_t p = 0; p < count; p++)
        for (int c = 0; c < 3; c++) {
            float value = pixels[CHANNELS * p + c];
            clipped += value * exp2(exposure) > 1;
            most = fmaxf(most, value);
        }
    if (clipped && !cli_has_extension(path, ".exr"))
        cli_say(&job->terminal,
                "warning: %s: %.2g %% of the values are clipped, up to %.3g; --exposure %g keeps "
                "them",
                path, 100.0 * (double)clipped / (3.0 * (double)count), most,
                floor(-10 * log2(most)) / 10);
}

static murk_status write_half(struct cli_job *job, const murk_image *half, const char *path)
{
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = isnan(job->options->exposure) ? 0 : job->options->exposure;
    options.data = true;
    options.command = job->command_line;
    options.units = "radiance / (irradiance / pi)";
    warn_clipped(job, murk_image_pixels_const(half),
                 (size_t)murk_image_width(half) * (size_t)murk_image_height(half), options.exposure,
                 path);
    murk_status status = cli_job_fail(job, murk_image_write(job->context, half, path, &options));
    if (status == MURK_OK)
        cli_say(&job->terminal, "texture in %s", path);
    return status;
}

murk_status cli_bake_sheet_write(struct cli_job *job, struct cli_bake_sheet *sheet,
                                 const char *path)
{
    size_t count =
        (size_t)murk_image_width(sheet->half[0]) * (size_t)murk_image_height(sheet->half[0]);
    float *opacity = malloc(sizeof *opacity * count);
    murk_status status = opacity ? MURK_OK : MURK_ERROR_MEMORY;
    for (size_t p = 0; p < count && opacity; p++)
        opacity[p] = murk_image_pixels(sheet->half[0])[CHANNELS * p + ALPHA];
    for (int h = 0; h < 2 && status == MURK_OK; h++) {
        char *name = half_path(path, h);
        if (h)
            normalise_glow(murk_image_pixels(sheet->half[h]), count);
        if (job->options->straight)
            divide(murk_image_pixels(sheet->half[h]), opacity, count);
        status = name ? write_half(job, sheet->half[h], name) : MURK_ERROR_MEMORY;
        free(name);
    }
    free(opacity);
    if (status == MURK_ERROR_MEMORY)
        cli_error(&job->terminal, "out of memory");
    return status;
}
