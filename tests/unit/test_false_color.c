/* SPDX-License-Identifier: Apache-2.0 */
/* False colour: what is more is lighter, and the scale bar says by how much. */
#include "check.h"
#include "image.h"
#include "murk/false_color.h"
#include "percentile.h"

static const char *const NAMES[] = {"Z", "LWIR.temperature"};

/* L of OKLab, from linear sRGB: cube roots of what the three kinds of cones take, mixed. */
static double lightness(const float *rgb)
{
    double l = 0.4122214708 * rgb[0] + 0.5363325363 * rgb[1] + 0.0514459929 * rgb[2];
    double m = 0.2119034982 * rgb[0] + 0.6806995451 * rgb[1] + 0.1073969566 * rgb[2];
    double s = 0.0883024619 * rgb[0] + 0.2817188376 * rgb[1] + 0.6299787005 * rgb[2];
    return 0.2104542553 * cbrt(l) + 0.7936177850 * cbrt(m) - 0.0040720468 * cbrt(s);
}

static double luminance(const float *rgb)
{
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

static void color_at(double part, float rgb[3])
{
    murk_color color = murk_false_color_at(part);
    rgb[0] = color.r;
    rgb[1] = color.g;
    rgb[2] = color.b;
}

/* OKLab's lightness is proportional to the value, so no colour was cut to fit into sRGB; luminance
   rises with it, also as bytes on a display. */
static void map(void **state)
{
    enum { STEPS = 2000 };
    float before[3], rgb[3];
    (void)state;
    color_at(0, before);
    for (int i = 1; i <= STEPS; i++) {
        double part = (double)i / STEPS;
        color_at(part, rgb);
        assert_within(lightness(rgb), 0.16 + part * 0.81, 2e-5);
        assert_true(luminance(rgb) > luminance(before));
        memcpy(before, rgb, sizeof before);
    }
    for (int i = 0; i <= 64; i++) { /* rounded to bytes and displayed */
        color_at(i / 64.0, rgb);
        for (int c = 0; c < 3; c++)
            rgb[c] = (float)murk_display_linear(round(255 * murk_display_value(rgb[c])) / 255);
        assert_true(i == 0 || luminance(rgb) > luminance(before));
        memcpy(before, rgb, sizeof before);
    }
    color_at(-3, rgb);
    color_at(0, before);
    assert_memory_equal(rgb, before, sizeof rgb);
    color_at(INFINITY, rgb);
    color_at(1, before);
    assert_memory_equal(rgb, before, sizeof rgb);
}

static murk_image *ramp(murk_context *context, int width, int height, float low, float high)
{
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(context, width, height, 2, NAMES, &image), MURK_OK);
    for (int i = 0; i < width * height; i++) {
        float part = width > 1 ? (float)(i % width) / (float)(width - 1) : 0;
        murk_image_pixels(image)[2 * i] = -1;
        murk_image_pixels(image)[2 * i + 1] = low + part * (high - low);
    }
    return image;
}

static murk_image *create(murk_context *context, const murk_image *image, double low, double high)
{
    const murk_false_color options = {
        .channel = NAMES[1], .low = low, .high = high, .label = "LWIR apparent temperature [K]"};
    murk_image *out = NULL;
    if (murk_false_color_create(context, image, &options, &out))
        fail_msg("%s", murk_context_message(context));
    return out;
}

static const float *pixel(const murk_image *image, int x, int y)
{
    return murk_image_pixels_const(image) + 4 * (y * murk_image_width(image) + x);
}

static void assert_color(const float *rgb, double part)
{
    float wanted[3];
    color_at(part, wanted);
    assert_memory_equal(rgb, wanted, sizeof wanted);
}

/* Where the scale bar is: the first column to the right of the picture that is not white, from top
   to bottom. */
static void find_bar(const murk_image *out, int from, int *x, int *top, int *bottom)
{
    const int height = murk_image_height(out);
    for (*x = from; luminance(pixel(out, *x, height / 2)) > 0.99; ++*x)
        assert_true(*x + 1 < murk_image_width(out));
    for (*top = height / 2; luminance(pixel(out, *x, *top - 1)) < 0.99; --*top)
        ;
    for (*bottom = height / 2; luminance(pixel(out, *x, *bottom + 1)) < 0.99; ++*bottom)
        ;
}

/* Pixels take their colours from the channel asked for; what is beyond the range takes its ends',
   what is no number is grey. The bar goes from one end of the range to the other. */
static void picture(void **state)
{
    murk_image *image = ramp(*state, 201, 150, 280, 320);
    float *values = murk_image_pixels(image);
    values[1] = NAN;
    values[3] = INFINITY;
    murk_image *out = create(*state, image, 290, 310);
    assert_int_equal(murk_image_height(out), 150);
    for (int c = 0; c < 3; c++) {
        assert_within(pixel(out, 0, 0)[c], 0.216, 1e-3);
        assert_within(pixel(out, 1, 0)[c], 0.216, 1e-3);
    }
    assert_color(pixel(out, 0, 149), 0);
    assert_color(pixel(out, 50, 149), 0);
    assert_color(pixel(out, 100, 7), 0.5);
    assert_color(pixel(out, 150, 7), 1);
    assert_color(pixel(out, 200, 7), 1);
    for (int x = 51; x <= 150; x++)
        assert_true(lightness(pixel(out, x, 80)) > lightness(pixel(out, x - 1, 80)));
    int x, top, bottom;
    find_bar(out, 201, &x, &top, &bottom);
    assert_color(pixel(out, x, top), 1);
    assert_color(pixel(out, x, bottom), 0);
    for (int y = top + 1; y <= bottom; y++)
        assert_true(lightness(pixel(out, x, y)) < lightness(pixel(out, x, y - 1)));
    for (int i = 0; i < murk_image_width(out) * murk_image_height(out); i++)
        assert_within(murk_image_pixels_const(out)[4 * i + 3], 1, 0);
    murk_image_release(out);
    murk_image_release(image);
}

/* From the 1st to the 99th percentile, rounded outwards; one end may be given. */
static void chosen_range(void **state)
{
    murk_image *image = ramp(*state, 1001, 3, 300, 310);
    murk_image_pixels(image)[1] = 1e6f; /* alone, it does not count */
    murk_image *chosen = create(*state, image, NAN, NAN), *given = create(*state, image, 300, 310);
    murk_image *half = create(*state, image, 300, NAN);
    size_t size =
        sizeof(float) * 4 * (size_t)murk_image_width(given) * (size_t)murk_image_height(given);
    assert_int_equal(murk_image_width(chosen), murk_image_width(given));
    assert_memory_equal(murk_image_pixels(chosen), murk_image_pixels(given), size);
    assert_memory_equal(murk_image_pixels(half), murk_image_pixels(given), size);
    murk_image_release(chosen);
    murk_image_release(given);
    murk_image_release(half);
    murk_image_release(image);
}

/* One pixel of one value is in the middle of its range; no value at all is grey beside a bar. */
static void smallest(void **state)
{
    murk_image *image = ramp(*state, 1, 1, 300, 300), *out = create(*state, image, NAN, NAN);
    assert_color(pixel(out, 0, 0), 0.5);
    murk_image_release(out);
    murk_image_pixels(image)[1] = NAN;
    out = create(*state, image, NAN, NAN);
    int x, top, bottom;
    find_bar(out, 1, &x, &top, &bottom);
    assert_true(bottom - top > 80);
    assert_color(pixel(out, x, top), 1);
    assert_within(pixel(out, 0, 0)[1], 0.216, 1e-3);
    murk_image_release(out);
    murk_image_release(image);
}

/* The bar grows with the picture, and its numbers do not change the size of a sequence. */
static void sizes(void **state)
{
    static const int HEIGHTS[] = {128, 512, 1080, 4096};
    int before = 0;
    for (int i = 0; i < 4; i++) {
        murk_image *image = ramp(*state, 8, HEIGHTS[i], 280, 320);
        murk_image *a = create(*state, image, 280, 320), *b = create(*state, image, 0.25, 1);
        int x, top, bottom;
        find_bar(a, 8, &x, &top, &bottom);
        assert_int_equal(murk_image_height(a), HEIGHTS[i]);
        assert_true(bottom - top > 0.8 * HEIGHTS[i]);
        assert_int_equal(murk_image_width(a), murk_image_width(b));
        assert_true(murk_image_width(a) - 8 >= before);
        before = murk_image_width(a) - 8;
        if (murk_text_possible()) { /* numbers and label are on the image, not cut by its edge */
            double ink = 0;
            for (int y = 0; y < HEIGHTS[i]; y++) {
                assert_true(luminance(pixel(a, murk_image_width(a) - 1, y)) > 0.99);
                for (int k = 8 + (before * 2) / 3; k < 8 + before; k++)
                    ink += 1 - luminance(pixel(a, k, y));
            }
            assert_true(ink > 20);
        }
        murk_image_release(a);
        murk_image_release(b);
        murk_image_release(image);
    }
}

static void errors(void **state)
{
    murk_image *image = ramp(*state, 2, 2, 280, 320), *out = NULL;
    murk_false_color options = {.channel = "Y", .low = NAN, .high = NAN};
    assert_int_equal(murk_false_color_create(*state, image, &options, &out), MURK_ERROR_INPUT);
    assert_string_equal(murk_context_message(*state), "the image has no channel Y");
    options = (murk_false_color){.channel = "Z", .low = 3, .high = 3};
    assert_int_equal(murk_false_color_create(*state, image, &options, &out), MURK_ERROR_INPUT);
    assert_string_equal(
        murk_context_message(*state),
        "Z in false colour: from 3 to 3 is no range: it has to begin below its end");
    assert_null(out);
    murk_image_release(image);
}

/* Against a sorted list, for values of both signs and all sizes. */
static void percentiles(void **state)
{
    float values[2 * 200];
    uint64_t random = 1;
    (void)state;
    for (int i = 0; i < 200; i++) { /* 1 ... 100, twice, shuffled; every other is not counted */
        values[2 * i] = (float)(i * 37 % 100 + 1);
        values[2 * i + 1] = (float)check_random(&random);
    }
    assert_within(murk_percentile(values, 200, 2, 0.01), 1, 0);
    assert_within(murk_percentile(values, 200, 2, 0.5), 50, 0);
    assert_within(murk_percentile(values, 200, 2, 0.99), 99, 0);
    assert_within(murk_percentile(values, 200, 2, 1), 100, 0);
    const float odd[] = {NAN, -1e-30f, 1e30f, -INFINITY, 0, -5, INFINITY};
    assert_within(murk_percentile(odd, 7, 1, 0), -5, 0);
    assert_within(murk_percentile(odd, 7, 1, 0.5), -1e-30f, 0);
    assert_within(murk_percentile(odd, 7, 1, 0.75), 0, 0);
    assert_within(murk_percentile(odd, 7, 1, 1), 1e30f, 0);
    assert_true(isnan(murk_percentile(odd, 1, 1, 0.5)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(map),         cmocka_unit_test(picture), cmocka_unit_test(chosen_range),
        cmocka_unit_test(smallest),    cmocka_unit_test(sizes),   cmocka_unit_test(errors),
        cmocka_unit_test(percentiles),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
