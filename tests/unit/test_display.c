/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures for looking at: exposure and the sRGB curve, in memory and through a file. */
#include "check.h"
#include "image.h"

#include <unistd.h>

/* IEC 61966-2-1. */
static double srgb(double light)
{
    light = fmin(fmax(light, 0), 1);
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
}

enum { WIDTH = 64 };

/* Linear values over twelve stops, and 0. */
static double value_of(int i, int c)
{
    return i == 0 ? 0 : exp2(0.19 * i - 10 + 0.06 * c);
}

static murk_image *create(murk_context *context)
{
    static const char *const NAMES[] = {"Z", "R", "G", "B", "A"};
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(context, WIDTH, 1, 5, NAMES, &image), MURK_OK);
    for (int i = 0; i < WIDTH; i++)
        for (int c = 0; c < 3; c++)
            murk_image_pixels(image)[5 * i + 1 + c] = (float)value_of(i, c);
    return image;
}

/* The byte that a linear value v shows as: 255 srgb(v 2^exposure), rounded. */
static int wanted(int i, int c, double exposure)
{
    return (int)floor(255 * srgb((float)value_of(i, c) * exp2(exposure)) + 0.5);
}

static void encoded(void **state)
{
    static const double EXPOSURES[] = {-3, 0, 0.5, 4};
    murk_image *image = create(*state);
    uint8_t bytes[3 * WIDTH];
    for (int e = 0; e < 4; e++) {
        murk_display_encode(image, EXPOSURES[e], bytes);
        for (int i = 0; i < 3 * WIDTH; i++)
            assert_int_equal(bytes[i], wanted(i / 3, i % 3, EXPOSURES[e]));
    }
    murk_image_pixels(image)[1] = NAN;
    murk_image_pixels(image)[2] = INFINITY;
    murk_image_pixels(image)[3] = -1;
    murk_display_encode(image, 0, bytes);
    assert_true(bytes[0] == 0 && bytes[1] == 0 && bytes[2] == 0);
    murk_image_release(image);
}

/* A .png has these bytes: reading it undoes the curve and nothing else. */
static void in_file(void **state)
{
    char folder[] = "/tmp/murk_display_XXXXXX", path[64];
    murk_image *image = create(*state), *read = NULL;
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.exposure = 1.5;
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.png", folder);
    if (murk_image_write(*state, image, path, &options) || murk_image_read(*state, path, &read))
        fail_msg("%s", murk_context_message(*state));
    unlink(path);
    rmdir(folder);
    assert_int_equal(murk_image_channels(read), 3);
    for (int i = 0; i < 3 * WIDTH; i++)
        assert_within(255 * srgb(murk_image_pixels(read)[i]), wanted(i / 3, i % 3, 1.5), 1e-3);
    murk_image_release(read);
    murk_image_release(image);
}

/* Without an exposure the 99th percentile of the luminance shows as 0.9. */
static void chosen(void **state)
{
    static const char *const NAMES[] = {"Y"};
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(*state, 1000, 1, 1, NAMES, &image), MURK_OK);
    for (int i = 0; i < 1000; i++)
        murk_image_pixels(image)[i] = i < 985 ? 0.001f * (float)i : i < 995 ? 7 : 1e6f;
    assert_within(srgb(7 * exp2(murk_display_exposure(image))), 0.9, 0.005);
    murk_image_release(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(encoded), cmocka_unit_test(in_file),
                                       cmocka_unit_test(chosen)};
    return cmocka_run_group_tests(tests, open_context, close_context);
}
