/* SPDX-License-Identifier: Apache-2.0 */
/* What is drawn where. */
#include "check.h"
#include "image.h"
#include "murk/plot.h"
#include "ticks.h"

enum { SIZE = 40 };

static const murk_color BLACK = {0, 0, 0}, RED = {1, 0, 0};

static murk_image *canvas(murk_context *context, int width, int height)
{
    murk_image *image = NULL;
    assert_int_equal(murk_canvas_create(context, width, height, &image), MURK_OK);
    return image;
}

/* How much of a white pixel is covered with black, by its displayed value. */
static double covered(const murk_image *image, int x, int y)
{
    return 1 - murk_display_value(
                   murk_image_pixels_const(image)[4 * (y * murk_image_width(image) + x)]);
}

static double all_covered(const murk_image *image)
{
    double sum = 0;
    for (int y = 0; y < murk_image_height(image); y++)
        for (int x = 0; x < murk_image_width(image); x++)
            sum += covered(image, x, y);
    return sum;
}

static void line(void **state)
{
    murk_image *image = canvas(*state, SIZE, SIZE);
    const double from[2] = {-5, 10}, to[2] = {SIZE + 5, 10};
    murk_line_draw(image, from, to, 2, BLACK);
    for (int x = 0; x < SIZE; x++) {
        assert_within(covered(image, x, 8), 0, 1e-6);
        assert_within(covered(image, x, 9), 1, 1e-6);
        assert_within(covered(image, x, 10), 1, 1e-6);
        assert_within(covered(image, x, 11), 0, 1e-6);
    }
    murk_image_release(image);

    /* At any angle it covers its length times its width, and a cap at each end. */
    for (int n = 0; n < 12; n++) {
        double angle = 0.3 * n;
        image = canvas(*state, SIZE, SIZE);
        const double a[2] = {20.3 - 15 * cos(angle), 19.8 - 15 * sin(angle)};
        const double b[2] = {20.3 + 15 * cos(angle), 19.8 + 15 * sin(angle)};
        murk_line_draw(image, a, b, 3, BLACK);
        assert_within(all_covered(image), 30 * 3 + M_PI * 1.5 * 1.5, 1);
        murk_image_release(image);
    }
}

static void rectangle(void **state)
{
    murk_image *image = canvas(*state, SIZE, SIZE);
    const murk_rectangle r = {3.25, 5, 2, 1.5};
    murk_rectangle_draw(image, &r, BLACK);
    static const double WIDE[] = {0.75, 1, 0.25}, HIGH[] = {1, 0.5};
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++)
            assert_within(covered(image, 3 + i, 5 + j), WIDE[i] * HIGH[j], 1e-6);
    assert_within(all_covered(image), 3, 1e-4);
    const murk_rectangle outside = {-100, -100, 50, 50}, all = {-1, -1, 1000, 1000};
    murk_rectangle_draw(image, &outside, BLACK);
    assert_within(all_covered(image), 3, 1e-4);
    murk_rectangle_draw(image, &all, BLACK);
    assert_within(all_covered(image), SIZE * SIZE, 1e-6);
    murk_image_release(image);
}

/* Only R, G, B and A change, and only where all of R, G and B are there. */
static void channels(void **state)
{
    static const char *const NAMES[] = {"Z", "B", "G", "R", "A"}, *const DEPTH[] = {"Z"};
    const murk_rectangle all = {0, 0, 2, 1};
    const murk_color color = {0.25f, 0.5f, 0.75f};
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(*state, 1, 1, 5, NAMES, &image), MURK_OK);
    murk_image_pixels(image)[0] = 7;
    murk_rectangle_draw(image, &all, color);
    static const float WANTED[] = {7, 0.75f, 0.5f, 0.25f, 1};
    assert_memory_equal(murk_image_pixels(image), WANTED, sizeof WANTED);
    murk_image_release(image);
    assert_int_equal(murk_image_create(*state, 1, 1, 1, DEPTH, &image), MURK_OK);
    murk_rectangle_draw(image, &all, color);
    assert_within(murk_image_pixels(image)[0], 0, 0);
    murk_image_release(image);
    murk_color grey = murk_color_srgb(0x80FF00);
    assert_within(grey.r, 0.2159, 1e-4);
    assert_true(grey.g == 1 && grey.b == 0);
}

/* Text stands where it is aligned to, and turned text is the same text. */
static void text(void **state)
{
    if (!murk_text_possible())
        skip();
    murk_image *flat = canvas(*state, 100, 100), *upward = canvas(*state, 100, 100);
    murk_text line = {"14 m^2", {50, 50}, {0.5, 1}, 20, false, BLACK};
    assert_int_equal(murk_text_draw(*state, flat, &line), MURK_OK);
    line.upward = true;
    assert_int_equal(murk_text_draw(*state, upward, &line), MURK_OK);
    double left = 0, right = 0;
    for (int y = 1; y < 100; y++)
        for (int x = 1; x < 100; x++) {
            assert_within(covered(flat, x, y), covered(upward, y, 100 - x), 0);
            *(x < 50 ? &left : &right) += covered(flat, x, y);
            if (y >= 50 || y < 25)
                assert_within(covered(flat, x, y), 0, 1e-9);
        }
    assert_true(left > 20 && right > 20);
    double width = murk_text_width("14 m^2", 20), raised = width - murk_text_width("14 m", 20);
    assert_true(width > 30 && width < 80);
    assert_true(raised > 3 && raised < murk_text_width("2", 20));
    murk_image_release(flat);
    murk_image_release(upward);
}

/* The labels of an axis, with spaces between them. */
static const char *labels(bool log, double low, double high, int most)
{
    static char all[512];
    static murk_tick ticks[MURK_TICKS_MOST];
    const double range[2] = {low, high};
    int count = murk_axis_ticks(log, range, most, ticks);
    all[0] = '\0';
    for (int i = 0; i < count; i++) {
        assert_true(ticks[i].value >= low * (1 - 1e-6) - 1e-9 && ticks[i].value <= high * 1.000001);
        if (*ticks[i].label)
            sprintf(all + strlen(all), "%s%s", *all ? " " : "", ticks[i].label);
    }
    return all;
}

static void ticks(void **state)
{
    (void)state;
    assert_string_equal(labels(false, 0, 10, 6), "0 2 4 6 8 10");
    assert_string_equal(labels(false, -0.8, 1, 5), "-0.5 0 0.5 1");
    assert_string_equal(labels(false, 0, 0.35, 4), "0 0.1 0.2 0.3");
    assert_string_equal(labels(false, 0, 1e6, 5), "0 200000 400000 600000 800000 1000000");
    assert_string_equal(labels(true, 8e3, 1.2e6, 7), "10^4 10^5 10^6");
    assert_string_equal(labels(true, 0.5, 20, 9), "0.5 1 2 5 10 20");
    assert_string_equal(labels(true, 0.001, 100, 9), "0.001 0.01 0.1 1 10 100");
    assert_string_equal(labels(true, 1e-9, 1e9, 7), "10^-9 10^-6 10^-3 1 10^3 10^6 10^9");
    assert_string_equal(labels(true, 95, 165, 5), "100 120 140 160");
}

static void ranges(void **state)
{
    (void)state;
    double range[2];
    murk_axis axis = {.log = true};
    assert_true(murk_axis_range(&axis, 1e4, 1e6, range));
    assert_true(range[0] < 1e4 && range[0] > 5e3 && range[1] > 1e6 && range[1] < 2e6);
    assert_within(murk_axis_place(true, range, 1e5), 0.5, 1e-9);
    assert_true(isnan(murk_axis_place(true, range, 0)));
    assert_true(murk_axis_range(&axis, 3, 3, range));
    assert_within(murk_axis_place(true, range, 3), 0.5, 1e-9);
    axis.max = 10;
    assert_false(murk_axis_range(&axis, 1, 2, range)); /* from 0 */
    axis.log = false;
    assert_true(murk_axis_range(&axis, 1, 2, range));
    assert_within(murk_axis_place(false, range, 2.5), 0.25, 1e-12);
    axis.max = 0;
    assert_true(murk_axis_range(&axis, 0, 0, range));
    assert_within(murk_axis_place(false, range, 0), 0.5, 1e-12);
    assert_true(murk_axis_range(&axis, -0.93, 0.98, range));
    assert_within(range[0], -1, 1e-12);
    assert_within(range[1], 1, 1e-12);
}

/* The middle of all red pixels of a plot with one point: its marker, or its label alone. */
static void find_red(murk_context *context, double x, double y, const char *label, double out[2])
{
    murk_image *image = canvas(context, 300, 200);
    const murk_rectangle all = {0, 0, 300, 200};
    const murk_curve curve = {.count = 1,
                              .x = &x,
                              .y = &y,
                              .color = RED,
                              .marker = label ? 0 : 6,
                              .label = label ? &label : NULL};
    const murk_plot plot = {.title = "point",
                            .x = {.label = "x", .min = 0, .max = 10},
                            .y = {.label = "y", .log = true, .min = 1, .max = 100},
                            .curve = &curve,
                            .curve_count = 1};
    double sum = 0;
    out[0] = out[1] = 0;
    assert_int_equal(murk_plot_draw(context, image, &all, &plot), MURK_OK);
    for (int j = 0; j < 200; j++)
        for (int i = 0; i < 300; i++) {
            const float *pixel = murk_image_pixels_const(image) + 4 * (300 * j + i);
            double red = fmax(0, pixel[0] - pixel[1]);
            sum += red;
            out[0] += red * (i + 0.5);
            out[1] += red * (j + 0.5);
        }
    for (int a = 0; a < 2; a++)
        out[a] = sum > 0 ? out[a] / sum : NAN;
    murk_image_release(image);
}

/* Points stand where the axes say: linear across, logarithmic upwards; none outside the frame. */
static void plot(void **state)
{
    double at[6][2];
    find_red(*state, 2, 2, NULL, at[0]);
    find_red(*state, 6, 20, NULL, at[1]);
    find_red(*state, 8, 63.2455532, NULL, at[2]);
    find_red(*state, 11, 10, NULL, at[3]);
    find_red(*state, 6, 20, "12", at[4]);
    find_red(*state, 11, 10, "12", at[5]);
    assert_within((at[2][0] - at[1][0]) / (at[1][0] - at[0][0]), 0.5, 0.01);
    assert_within((at[2][1] - at[1][1]) / (at[1][1] - at[0][1]), 0.5, 0.01);
    assert_true(at[1][0] > at[0][0] + 50 && at[1][1] < at[0][1] - 30);
    assert_true(isnan(at[3][0]) && isnan(at[5][0]));
    if (murk_text_possible())
        assert_true(at[4][0] > at[1][0] + 3 && at[4][0] < at[1][0] + 20 &&
                    at[4][1] < at[1][1] - 3 && at[4][1] > at[1][1] - 20);

    const murk_plot bad = {.x = {.log = true, .min = -1, .max = 1}};
    const murk_rectangle all = {0, 0, 300, 200};
    murk_image *image = canvas(*state, 300, 200);
    assert_int_equal(murk_plot_draw(*state, image, &all, &bad), MURK_ERROR_INPUT);
    assert_string_equal(murk_context_message(*state),
                        "plot: the x axis from -1 to 1, logarithmic: it has to begin below its end "
                        "and above 0");
    murk_image_release(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(line), cmocka_unit_test(rectangle), cmocka_unit_test(channels),
        cmocka_unit_test(text), cmocka_unit_test(ticks),     cmocka_unit_test(ranges),
        cmocka_unit_test(plot),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
