/* SPDX-License-Identifier: Apache-2.0 */
/* Contrast of a target in pictures whose numbers are known. */
#include "check.h"
#include "murk/contrast.h"

enum { WIDTH = 8, HEIGHT = 6 };

static const murk_region TARGET = {2, 1, 3, 2, NULL}, BACKGROUND = {0, 0, WIDTH, 5, NULL};
static const murk_region BELOW = {0, 5, WIDTH, 1, NULL};

/* What a pixel of a region shows: L = tau L0 + scattered + emitted. */
struct light {
    double inherent, transmittance, scattered, emitted, cl;
};

static murk_image *create(murk_context *context, const char *bands)
{
    static const char *const NAMES[] = {"R",
                                        "B-1.radiance",
                                        "B-1.inherent",
                                        "B-1.surface",
                                        "B-1.transmittance",
                                        "B-1.scattered",
                                        "B-1.emitted",
                                        "CL.Y"};
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(context, WIDTH, HEIGHT, 8, NAMES, &image), MURK_OK);
    if (bands)
        assert_int_equal(murk_image_set_attribute(image, "murk:bands", bands), MURK_OK);
    return image;
}

static bool inside(const murk_region *r, int x, int y)
{
    return x >= r->x && x < r->x + r->width && y >= r->y && y < r->y + r->height;
}

/* Lights a rectangle; its columns differ by steps of `slope` times the light, with the mean that is
   asked for. */
static void fill(murk_image *image, const murk_region *region, struct light light, double slope)
{
    float *pixel = murk_image_pixels(image);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++, pixel += murk_image_channels(image)) {
            if (!inside(region, x, y))
                continue;
            double s = 1 + slope * (x - region->x - 0.5 * (region->width - 1));
            double surface = light.transmittance * light.inherent * s;
            pixel[1] = (float)(surface + light.scattered * s + light.emitted * s);
            pixel[2] = (float)(light.inherent * s);
            pixel[3] = (float)surface;
            pixel[4] = (float)light.transmittance;
            pixel[5] = (float)(light.scattered * s);
            pixel[6] = (float)(light.emitted * s);
            pixel[7] = (float)(light.cl * s);
        }
}

static murk_contrast measure(murk_context *context, const murk_image *image,
                             const murk_region *target, const murk_region *background,
                             const murk_sensor *sensor)
{
    murk_picture_band band;
    murk_contrast out = {0};
    size_t count;
    if (murk_picture_bands(context, image, 1, &band, &count) ||
        murk_contrast_measure(context, image, &band, target, background, sensor, &out))
        fail_msg("%s", murk_context_message(context));
    return out;
}

/* A target of 3 on a background of 2, half of it seen through, with 0.4 scattered and 0.1 emitted:
   L_t = 2, L_b = 1.5. */
static void by_hand(void **state)
{
    murk_image *image = create(*state, "B-1:0:0");
    fill(image, &BACKGROUND, (struct light){2, 0.5, 0.4, 0.1, 0.9}, 0);
    fill(image, &TARGET, (struct light){3, 0.5, 0.4, 0.1, 0.8}, 0.125);
    const murk_sensor sensor = {NAN, 30};
    murk_contrast c = measure(*state, image, &TARGET, &BACKGROUND, &sensor);
    assert_int_equal(c.target.pixels, 6);
    assert_int_equal(c.background.pixels, 5 * WIDTH - 6);
    assert_within(c.target.radiance, 2, 1e-7);
    assert_within(c.background.radiance, 1.5, 1e-7);
    assert_within(c.target.inherent, 3, 1e-7);
    assert_within(c.background.inherent, 2, 1e-7);
    assert_within(c.target.scattered, 0.4, 1e-7);
    assert_within(c.target.emitted, 0.1, 1e-7);
    assert_within(c.target.cl, 0.8, 1e-7);
    assert_within(c.background.cl, 0.9, 1e-7);
    assert_within(c.background.transmittance, 0.5, 1e-7);
    assert_within(c.background.optical_depth, M_LN2, 1e-7);
    assert_within(c.inherent, 0.5, 1e-7);
    assert_within(c.apparent, 1 / 3., 1e-7);
    assert_within(c.transmittance, 2 / 3., 1e-6);
    assert_within(c.cnr_radiance, 10, 1e-5);
    assert_true(isnan(c.cnr_thermal) && isnan(c.dt_apparent) && isnan(c.target.temperature));
    murk_image_release(image);
}

/* C / C0 = tau L_b0 / (tau L_b0 + L_p), for any light. */
static void closed_form(void **state)
{
    uint64_t seed = 7;
    for (int n = 0; n < 100; n++) {
        murk_image *image = create(*state, "B-1:0:0");
        struct light b = {check_random(&seed) + 0.1, 0.05 + check_random(&seed),
                          check_random(&seed), check_random(&seed), 0};
        struct light t = b;
        t.inherent *= n % 2 ? 0.3 : 2;
        fill(image, &BACKGROUND, b, 0);
        fill(image, &TARGET, t, 0);
        murk_contrast c = measure(*state, image, &TARGET, &BACKGROUND, NULL);
        double seen = b.transmittance * b.inherent, path = b.scattered + b.emitted;
        assert_within(c.inherent, n % 2 ? -0.7 : 1, 1e-6);
        assert_within(c.transmittance / (seen / (seen + path)), 1, 1e-5);
        assert_true(isnan(c.cnr_radiance) && isnan(c.cnr_thermal));
        murk_image_release(image);
    }
}

/* 310 K before 300 K, seen from 8 to 12 um through an absorbing medium of 290 K that lets a quarter
   through. Radiances by Simpson's rule on Planck's law, temperatures from them by bisection. */
static void temperatures(void **state)
{
    static const double b290 = 32.516859924, b300 = 38.500423934, b310 = 45.114890689;
    murk_image *image = create(*state, "B-1:8e-06:1.2e-05");
    fill(image, &BACKGROUND, (struct light){b300, 0.25, 0, 0.75 * b290, 0}, 0);
    fill(image, &TARGET, (struct light){b310, 0.25, 0, 0.75 * b290, 0}, 0);
    const murk_sensor sensor = {0.1, 100};
    murk_contrast c = measure(*state, image, &TARGET, &BACKGROUND, &sensor);
    assert_within(c.target.temperature_inherent, 310, 1e-4);
    assert_within(c.background.temperature_inherent, 300, 1e-4);
    assert_within(c.target.temperature, 295.393344, 1e-4);
    assert_within(c.background.temperature, 292.600273, 1e-4);
    assert_within(c.dt_inherent, 10, 2e-4);
    assert_within(c.dt_apparent, 2.793070, 2e-4);
    assert_within(c.cnr_thermal, 10 * 2.793070, 2e-3);
    assert_within(c.inherent, 0.17180244, 1e-6);
    assert_within(c.apparent, 0.04861755, 1e-6);
    assert_within(c.cnr_radiance, 100 * 0.04861755, 1e-4);
    murk_image_release(image);
}

/* The rectangle's pixels as a mask; its other channels do not matter. */
static murk_image *mask_of(murk_context *context, const murk_region *region)
{
    static const char *const NAMES[] = {"R", "G"};
    murk_image *mask = NULL;
    assert_int_equal(murk_image_create(context, WIDTH, HEIGHT, 2, NAMES, &mask), MURK_OK);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            float *pixel = murk_image_pixels(mask) + 2 * (y * WIDTH + x);
            pixel[0] = inside(region, x, y) ? 0.75f : 0.5f;
            pixel[1] = 1;
        }
    return mask;
}

static void masks(void **state)
{
    murk_image *image = create(*state, "B-1:8e-06:1.2e-05");
    fill(image, &BACKGROUND, (struct light){2, 0.5, 0.4, 0.1, 0.9}, 0.01);
    fill(image, &TARGET, (struct light){3, 0.6, 0.3, 0.2, 0.8}, 0.125);
    const murk_region target = {.mask = mask_of(*state, &TARGET)};
    const murk_region background = {.mask = mask_of(*state, &BACKGROUND)};
    const murk_sensor sensor = {0.05, 30};
    murk_contrast a = measure(*state, image, &TARGET, &BACKGROUND, &sensor);
    murk_contrast b = measure(*state, image, &target, &background, &sensor);
    assert_memory_equal(&a, &b, sizeof a);
    murk_image_release((murk_image *)target.mask);
    murk_image_release((murk_image *)background.mask);
    murk_image_release(image);
}

/* What cannot be known is NaN: a black background, a target like its background, no CL.Y. */
static void unknown(void **state)
{
    murk_image *image = create(*state, "B-1:8e-06:1.2e-05");
    fill(image, &TARGET, (struct light){1, 0.5, 0, 0, 0}, 0);
    murk_contrast c = measure(*state, image, &TARGET, &BELOW, NULL);
    assert_true(isnan(c.inherent) && isnan(c.apparent) && isnan(c.transmittance));
    assert_true(c.background.temperature == 0);
    fill(image, &BELOW, (struct light){1, 0.5, 0.5, 0, 0}, 0);
    c = measure(*state, image, &TARGET, &BELOW, NULL);
    assert_true(c.inherent == 0 && isnan(c.transmittance));
    assert_within(c.apparent, -0.5, 1e-6);
    murk_image_release(image);

    static const char *const NAMES[] = {"R.radiance", "R.inherent", "R.transmittance",
                                        "R.scattered", "R.emitted"};
    assert_int_equal(murk_image_create(*state, 2, 1, 5, NAMES, &image), MURK_OK);
    assert_int_equal(murk_image_set_attribute(image, "murk:bands", "R:0:0"), MURK_OK);
    const murk_region left = {0, 0, 1, 1, NULL}, right = {1, 0, 1, 1, NULL};
    c = measure(*state, image, &left, &right, NULL);
    assert_true(isnan(c.target.cl) && c.target.pixels == 1);
    murk_image_release(image);
}

static void lists(void **state)
{
    murk_picture_band band[2];
    size_t count = 0;
    murk_image *image = create(*state, "R:6e-07:7e-07,LWIR_2-b:8e-06:1.2e-05,N:0:0");
    assert_int_equal(murk_picture_bands(*state, image, 2, band, &count), MURK_OK);
    assert_int_equal(count, 3);
    assert_string_equal(band[0].name, "R");
    assert_string_equal(band[1].name, "LWIR_2-b");
    assert_true(band[0].band.wavelength[0] == 6e-7 && band[0].band.wavelength[1] == 7e-7);
    assert_true(band[1].band.wavelength[0] == 8e-6 && band[1].band.wavelength[1] == 1.2e-5);
    static const char *const WRONG[] = {"",           "R",           "R:1e-6",       "R:1e-6:",
                                        ":1e-6:2e-6", "R:2e-6:1e-6", "R:0:1e-6",     "R:1e-6:2e-6,",
                                        "R 1:0:0",    "R:0:0;G:0:0", "R:-1e-6:1e-6", "R:1e-6:inf"};
    for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; i++) {
        assert_int_equal(murk_image_set_attribute(image, "murk:bands", WRONG[i]), MURK_OK);
        count = 77;
        if (murk_picture_bands(*state, image, 2, band, &count) != MURK_ERROR_INPUT || count != 77)
            fail_msg("%s passes", WRONG[i]);
        assert_non_null(strstr(murk_context_message(*state), "murk:bands"));
    }
    murk_image_release(image);
    image = create(*state, NULL);
    assert_int_equal(murk_picture_bands(*state, image, 2, band, &count), MURK_ERROR_INPUT);
    assert_string_equal(murk_context_message(*state),
                        "the picture has no bands; render a scene with \"bands\" to an .exr file");
    murk_image_release(image);
}

static void assert_fails(murk_context *context, const murk_image *image, const char *band_name,
                         const murk_region *target, const murk_region *background,
                         const char *message)
{
    murk_picture_band band = {.band = {{0, 0}}};
    murk_contrast out = {.apparent = 77};
    strcpy(band.name, band_name);
    assert_int_equal(murk_contrast_measure(context, image, &band, target, background, NULL, &out),
                     MURK_ERROR_INPUT);
    assert_true(out.apparent == 77);
    assert_string_equal(murk_context_message(context), message);
}

static void errors(void **state)
{
    static const char *const NAMES[] = {"Y"};
    static const murk_region OUTSIDE[] = {{-1, 0, 2, 2, NULL}, {0, -1, 2, 2, NULL},
                                          {7, 0, 2, 2, NULL},  {0, 5, 2, 2, NULL},
                                          {8, 0, 1, 1, NULL},  {1, 0, INT32_MAX, 1, NULL}};
    char message[200];
    murk_image *image = create(*state, "B-1:0:0"), *small = NULL, *black = NULL;
    assert_int_equal(murk_image_create(*state, 4, 3, 1, NAMES, &small), MURK_OK);
    assert_int_equal(murk_image_create(*state, WIDTH, HEIGHT, 1, NAMES, &black), MURK_OK);
    const murk_region no_pixel = {.mask = black}, other_size = {.mask = small};
    const murk_region no_width = {1, 1, 0, 4, NULL};
    assert_fails(
        *state, image, "LWIR", &TARGET, &BELOW,
        "the picture has no channel LWIR.radiance; render it again, and keep all channels");
    for (size_t i = 0; i < sizeof OUTSIDE / sizeof *OUTSIDE; i++) {
        snprintf(message, sizeof message,
                 "the background, %d x %d pixels from %d,%d, reaches outside of the picture's "
                 "8 x 6 pixels",
                 OUTSIDE[i].width, OUTSIDE[i].height, OUTSIDE[i].x, OUTSIDE[i].y);
        assert_fails(*state, image, "B-1", &TARGET, &OUTSIDE[i], message);
    }
    assert_fails(*state, image, "B-1", &no_width, &BELOW,
                 "the target is 0 x 4 pixels; it takes at least one");
    assert_fails(*state, image, "B-1", &other_size, &BELOW,
                 "the mask of the target has 4 x 3 pixels; it takes the 8 x 6 of the picture");
    assert_fails(*state, image, "B-1", &no_pixel, &BELOW,
                 "the target has no pixel; its mask is to be above 0.5 somewhere");
    assert_fails(
        *state, image, "B-1", &TARGET, &TARGET,
        "the background has no pixel outside of the target; name a region beside or around "
        "it");
    assert_fails(
        *state, image, "B-1", &TARGET, &no_pixel,
        "the background has no pixel outside of the target; name a region beside or around "
        "it");
    murk_image_release(image);
    murk_image_release(small);
    murk_image_release(black);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_hand), cmocka_unit_test(closed_form), cmocka_unit_test(temperatures),
        cmocka_unit_test(masks),   cmocka_unit_test(unknown),     cmocka_unit_test(lists),
        cmocka_unit_test(errors),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
