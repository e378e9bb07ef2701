/* SPDX-License-Identifier: Apache-2.0 */
/* What is left of a target behind smoke, in each band of a picture, and the picture of its
 * transmittance: 08_contrast PICTURE.exr OUT.png, the target in the middle. */
#include <murk/contrast.h>
#include <murk/false_color.h>

#include <stdio.h>

enum { BANDS = 8 };

/* The middle ninth of the picture against all the rest of it. */
static murk_status measure(murk_context *context, const murk_image *picture)
{
    murk_picture_band band[BANDS];
    size_t count;
    int width = murk_image_width(picture), height = murk_image_height(picture);
    const murk_region target = {width / 3, height / 3, width / 3, height / 3, NULL};
    const murk_region background = {0, 0, width, height, NULL};
    murk_status status = murk_picture_bands(context, picture, BANDS, band, &count);
    for (size_t i = 0; !status && i < count && i < BANDS; i++) {
        murk_contrast contrast;
        status = murk_contrast_measure(context, picture, &band[i], &target, &background, NULL,
                                       &contrast);
        if (!status)
            printf("%-5s contrast %.3f, without the smoke %.3f; %.3g %% of the light passes\n",
                   band[i].name, contrast.apparent, contrast.inherent,
                   100 * contrast.target.transmittance);
    }
    return status;
}

static murk_status draw(murk_context *context, const murk_image *picture, const char *path)
{
    const murk_false_color options = {.channel = "transmittance.Y", .low = 0, .high = 1};
    const murk_image_write_options plain = {.exposure = 0};
    murk_image *image;
    murk_status status = murk_false_color_create(context, picture, &options, &image);
    if (status)
        return status;
    status = murk_image_write(context, image, path, &plain);
    murk_image_release(image);
    return status;
}

int main(int argc, char **argv)
{
    murk_context *context;
    murk_image *picture;
    if (argc != 3 || murk_context_create(NULL, &context)) {
        fprintf(stderr, "usage: %s PICTURE.exr OUT.png\n", argv[0]);
        return 1;
    }
    murk_status status = murk_image_read(context, argv[1], &picture);
    if (!status) {
        status = measure(context, picture);
        if (!status)
            status = draw(context, picture, argv[2]);
        murk_image_release(picture);
    }
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_context_release(context);
    return status != MURK_OK;
}
