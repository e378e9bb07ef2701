/* SPDX-License-Identifier: Apache-2.0 */
/* The choice of lamps, and the light gathered from them against closed forms. */
#include "check.h"

#include "box_escape.h"
#include "factor_offset.h"
#include "gather.h"
#include "sight.h"

enum { SIZE = 24, MIDDLE = 11 };

struct scene {
    murk_context *context;
    murk_medium *medium;
    murk_grid *to;
};

static struct scene make(const float *kappa_t, double kappa_value, const float *emission,
                         const double voxel[3])
{
    struct scene s = {.context = check_context(1, NULL)};
    const murk_array array = {.size = {SIZE, SIZE, SIZE},
                              .voxel_size = {voxel[0], voxel[1], voxel[2]},
                              .kappa_t = kappa_t,
                              .kappa_t_value = kappa_value,
                              .emission = emission};
    assert_int_equal(murk_medium_from_array(s.context, &array, &s.medium), MURK_OK);
    assert_int_equal(murk_grid_dilate(s.context, s.medium->input, 2, &s.to), MURK_OK);
    return s;
}

static void release(struct scene *s)
{
    murk_grid_release(s->to);
    murk_medium_release(s->medium);
    murk_context_release(s->context);
}

static murk_gathered gather(struct scene *s, double radiosity)
{
    murk_lamps lamps = {.count = 1, .zones = 1, .lamp = murk_alloc(1, sizeof *lamps.lamp)};
    murk_gathered out;
    assert_non_null(lamps.lamp);
    lamps.lamp[0] =
        (murk_lamp){.index = (size_t)murk_grid_slot(s->medium->grid, MIDDLE, MIDDLE, MIDDLE),
                    .radiosity = (float)radiosity};
    assert_int_equal(murk_gather(s->context, s->medium, NULL, s->to, &lamps, &out), MURK_OK);
    assert_int_equal(lamps.count, 1);
    murk_lamps_clear(&lamps);
    return out;
}

static double light_at(const struct scene *s, const murk_gathered *light, const int offset[3])
{
    int64_t slot =
        murk_grid_slot(s->to, MIDDLE + offset[0], MIDDLE + offset[1], MIDDLE + offset[2]);
    assert_true(slot >= 0);
    return light->zone[slot];
}

static const int NEAR_OFFSETS[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {1, 1, 1},
                                      {0, 2, 0}, {2, 1, 0}, {-1, 2, 2}};
static const int FAR_OFFSETS[][3] = {{4, 0, 0},  {0, 0, -4},  {3, 3, 0},    {2, 2, 3},
                                     {-8, 1, 4}, {-9, 0, 10}, {-11, 5, -11}};
enum { NEAR_COUNT = sizeof NEAR_OFFSETS / sizeof *NEAR_OFFSETS };
enum { FAR_COUNT = sizeof FAR_OFFSETS / sizeof *FAR_OFFSETS };

static void check_factors(double kappa, const double voxel[3])
{
    struct scene s = make(NULL, kappa, NULL, voxel);
    murk_gathered light = gather(&s, 2);
    double volume = voxel[0] * voxel[1] * voxel[2];
    for (int i = 0; i < NEAR_COUNT + FAR_COUNT; i++) {
        const int *offset = i < NEAR_COUNT ? NEAR_OFFSETS[i] : FAR_OFFSETS[i - NEAR_COUNT];
        double wanted = 2 * kappa * murk_factor_offset_zone(voxel, offset, kappa) / (4 * volume);
        assert_within(light_at(&s, &light, offset) / wanted, 1, i < NEAR_COUNT ? 0.01 : 0.005);
    }
    murk_gathered_clear(&light);
    release(&s);
}

/* G/4 = B V_mV_k / (4 kappa V), the factor being exact. */
static void uniform_media(void **state)
{
    (void)state;
    static const double cube[3] = {0.5, 0.5, 0.5}, flat[3] = {0.5, 0.5, 0.2};
    for (double tau = 0.001; tau < 0.5; tau *= 6) {
        check_factors(tau / 0.5, cube);
        check_factors(tau / 0.5, flat);
    }
}

/* A lamp of any depth in next to nothing: every line brings 1 - exp(-kappa chord), beyond the
   medium too. */
static void lamp_of_any_depth(void **state)
{
    (void)state;
    static const double voxel[3] = {1, 1, 1};
    static float kappa[SIZE * SIZE * SIZE];
    for (double tau = 0.01; tau < 30; tau *= 3) {
        for (int i = 0; i < SIZE * SIZE * SIZE; i++)
            kappa[i] = 1e-5f;
        kappa[(MIDDLE * SIZE + MIDDLE) * SIZE + MIDDLE] = (float)tau;
        struct scene s = make(kappa, 0, NULL, voxel);
        murk_gathered light = gather(&s, 1);
        /* On the axis lines that meet the back of the cube have its whole edge as their chord, and
           those that meet its front alone any part of it. */
        double front = 1 / pow(12 - 0.5, 2), back = 1 / pow(12 + 0.5, 2);
        double along =
            (back * -expm1(-tau) + (front - back) * (1 - murk_chord_escape(tau))) / (4 * M_PI);
        assert_within(light_at(&s, &light, (const int[3]){12, 0, 0}) / along, 1, 0.005);
        double direction[3] = {1 / sqrt(3), 1 / sqrt(3), 1 / sqrt(3)};
        double diagonal = tau * murk_box_escape(voxel, direction, tau) / (4 * M_PI * 3 * 100);
        assert_within(light_at(&s, &light, (const int[3]){10, 10, 10}) / diagonal, 1, 0.01);
        assert_true(light_at(&s, &light, (const int[3]){14, 0, 0}) > 0); /* in the margin */
        assert_true(light.kept < 0.9 * light.sent || tau > 5);
        murk_gathered_clear(&light);
        release(&s);
    }
}

/* Where nothing leaves, all the light that is sent is kept; elsewhere no more than that. */
static void power(void **state)
{
    (void)state;
    static const double voxel[3] = {1, 1, 1};
    static float kappa[SIZE * SIZE * SIZE];
    uint64_t random = 5;
    for (double tau = 0.1; tau < 30; tau *= 2) {
        for (int i = 0; i < SIZE * SIZE * SIZE; i++)
            kappa[i] = (float)(tau * (0.5 + check_random(&random)));
        struct scene s = make(kappa, 0, NULL, voxel);
        murk_gathered light = gather(&s, 3);
        assert_true(light.kept <= light.sent * (1 + 1e-6));
        if (tau > 1.5)
            assert_within(light.kept / light.sent, 1, tau > 6 ? 1e-6 : 2e-3);
        murk_gathered_clear(&light);
        release(&s);
    }
}

/* Escape from an opaque box is its cross-section over kappa V, from a thin one 1. */
static void boxes(void **state)
{
    (void)state;
    static const double size[3] = {1, 2, 3};
    uint64_t random = 9;
    for (int n = 0; n < 100; n++) {
        double d[3], section = 0, kappa = 1e4;
        check_direction(&random, d);
        for (int a = 0; a < 3; a++)
            section += fabs(d[a]) * 6 / size[a];
        assert_within(murk_box_escape(size, d, kappa) * kappa * 6 / section, 1, 0.05);
        assert_within(murk_box_escape(size, d, 1e-9), 1, 1e-8);
        /* Either branch at its end. */
        double chord = 1 / fmax(fabs(d[0]), fmax(fabs(d[1]) / 2, fabs(d[2]) / 3));
        assert_within(murk_box_escape(size, d, 1.99999 / chord) /
                          murk_box_escape(size, d, 2.00001 / chord),
                      1, 2e-5);
    }
    assert_within(murk_box_escape(size, (const double[3]){0, 1, 0}, 1), murk_chord_escape(2), 1e-8);
}

static size_t lamps_of(const float *emission, double sky)
{
    static const double voxel[3] = {1, 1, 1};
    struct scene s = make(NULL, 4. / SIZE, emission, voxel);
    const murk_lit lit = {.medium = s.medium, .sky = sky};
    murk_lamps lamps;
    assert_int_equal(murk_lamps_choose(s.context, &lit, 0.01, &lamps), MURK_OK);
    size_t count = lamps.count;
    murk_lamps_clear(&lamps);
    release(&s);
    return count;
}

/* What is bright everywhere is left to the lines, as is what other light outshines. */
static void choice(void **state)
{
    (void)state;
    static float emission[SIZE * SIZE * SIZE];
    uint64_t random = 3;
    for (int i = 0; i < SIZE * SIZE * SIZE; i++)
        emission[i] = 1;
    assert_int_equal(lamps_of(emission, 0), 0);
    for (int i = 0; i < SIZE * SIZE * SIZE; i++)
        emission[i] = (float)check_random(&random);
    assert_int_equal(lamps_of(emission, 0), 0);
    memset(emission, 0, sizeof emission);
    assert_int_equal(lamps_of(emission, 0), 0);
    for (int n = 0; n < 8; n++)
        emission[((MIDDLE + (n & 1)) * SIZE + MIDDLE + (n >> 1 & 1)) * SIZE + MIDDLE + (n >> 2)] =
            1;
    assert_int_equal(lamps_of(emission, 0), 8);
    assert_int_equal(lamps_of(emission, 10), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(boxes), cmocka_unit_test(uniform_media),
                                       cmocka_unit_test(lamp_of_any_depth), cmocka_unit_test(power),
                                       cmocka_unit_test(choice)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
