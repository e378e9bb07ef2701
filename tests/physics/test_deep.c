/* SPDX-License-Identifier: Apache-2.0 */
/* Deep pictures: flattened they are the flat ones, and cut at any depth what lies before it. */
#include "camera.h"
#include "murk/deep.h"

#include <float.h>

enum { NX = 9, NY = 7, NZ = 8 };

static const double EDGE = 0.1, E = 2;

static const murk_camera CAMERA = {{1.9, -1.4, 1.5}, {0.45, 0.3, 0.5}, {0, 0, 1}, 38, {21, 17}, 0};

/* Voxels from empty to so thick that nothing is seen through one. */
static murk_array uneven(float kappa_t[NX * NY * NZ])
{
    uint64_t state = 77;
    for (int n = 0; n < NX * NY * NZ; n++) {
        double of = check_random(&state);
        kappa_t[n] = of < 0.3 ? 0 : of < 0.9 ? (float)(6 * check_random(&state)) : 200;
    }
    return (murk_array){.size = {NX, NY, NZ},
                        .voxel_size = {EDGE, EDGE, EDGE},
                        .origin = {0, 0, 0.1},
                        .kappa_t = kappa_t};
}

static const murk_ground_options GROUND = {.extent_min = {-2, -2},
                                           .extent_max = {3, 3},
                                           .patches = {5, 4},
                                           .reflectance = 0.4,
                                           .horizon = true};

static murk_deep *take_deep(const struct world *w, const murk_camera *camera,
                            const murk_render_options *options)
{
    const murk_band_view view = {.scene = &w->scene, .solution = w->solution};
    murk_deep *deep = NULL;
    if (murk_render_deep(w->context, &view, 1, camera, options, &deep))
        fail_msg("%s", murk_context_message(w->context));
    return deep;
}

/* Light and opacity before z, by the OpenEXR document on deep pixels. */
static void compose(const murk_deep_sample *sample, size_t count, double z, double out[4])
{
    memset(out, 0, 4 * sizeof *out);
    for (size_t n = 0; n < count && sample[n].z < z; n++) {
        const murk_deep_sample *s = &sample[n];
        double part = 1, opacity = s->a;
        if (z < s->z_back) {
            double way = (z - s->z) / (s->z_back - s->z);
            opacity = -expm1(way * log1p(-s->a));
            part = s->a > 0 ? opacity / s->a : way;
        }
        const double light[4] = {part * s->r, part * s->g, part * s->b, opacity};
        for (int c = 0; c < 3; c++)
            out[c] += (1 - out[3]) * light[c];
        out[3] += (1 - out[3]) * opacity;
    }
}

static void assert_tidy(const murk_deep_sample *sample, size_t count)
{
    for (size_t n = 0; n < count; n++) {
        const murk_deep_sample *s = &sample[n];
        assert_true(s->r >= 0 && s->g >= 0 && s->b >= 0 && s->a >= 0 && s->a <= 1);
        assert_true(s->r < FLT_MAX && s->g < FLT_MAX && s->b < FLT_MAX);
        assert_true(s->z >= 0 && s->z <= s->z_back && s->z_back <= 1e30f);
        assert_true(n == 0 || sample[n - 1].z_back <= s->z);
        if (s->z == s->z_back)
            assert_true(n + 1 == count && s->a == 0);
    }
}

static void assert_flattens(const murk_deep *deep, const murk_image *flat)
{
    static const char *const CHANNELS[] = {"R", "G", "B", "A"};
    int size[2];
    size_t most = 0;
    murk_deep_size(deep, size);
    assert_int_equal(size[0], murk_image_width(flat));
    assert_int_equal(size[1], murk_image_height(flat));
    for (int j = 0; j < size[1]; j++)
        for (int i = 0; i < size[0]; i++) {
            const murk_deep_sample *sample = NULL;
            size_t count = murk_deep_samples(deep, i, j, &sample);
            double all[4];
            assert_tidy(sample, count);
            compose(sample, count, INFINITY, all);
            for (int c = 0; c < 4; c++) {
                double wanted = pixel(flat, CHANNELS[c], i, j);
                assert_within(all[c], wanted, 1e-5 * wanted + 1e-7);
            }
            most = count > most ? count : most;
        }
    assert_true(most > 2); /* else there was nothing to see */
}

static void flattened(void **state)
{
    static float kappa_t[NX * NY * NZ];
    murk_array array = uneven(kappa_t);
    struct world w;
    (void)state;
    array.albedo_value = 0.8;
    world_open(&w, 1, &array, &GROUND);
    w.scene.sun = (murk_sun){.direction = {0.3, 0.5, -0.8}, .irradiance = 3};
    w.scene.sky_radiance = 0.2;
    world_solve(&w, &(murk_solve_options){.tolerance = 0.1, .directions = 48});
    for (int samples = 1; samples <= 4; samples++)
        for (int alone = 0; alone < 2; alone++) {
            const murk_render_options options = {.samples = samples, .no_background = alone};
            murk_image *flat = take(&w, &CAMERA, &options);
            murk_deep *deep = take_deep(&w, &CAMERA, &options);
            assert_flattens(deep, flat);
            murk_deep_release(deep);
            murk_image_release(flat);
        }
    world_close(&w);
}

/* Sunlight from behind, so that much of it is scattered forward. */
static void flattened_forward(void **state)
{
    static float kappa_t[NX * NY * NZ];
    murk_array array = uneven(kappa_t);
    struct world w;
    (void)state;
    array.albedo_value = 0.95;
    array.asymmetry = 0.8;
    world_open(&w, 1, &array, &GROUND);
    w.scene.sun = (murk_sun){.direction = {0.8, -0.4, -0.5}, .irradiance = 3};
    w.scene.sky_radiance = 0.2;
    world_solve(&w, &(murk_solve_options){.tolerance = 0.1, .directions = 48});
    murk_image *flat = take(&w, &CAMERA, NULL);
    murk_deep *deep = take_deep(&w, &CAMERA, NULL);
    assert_flattens(deep, flat);
    murk_deep_release(deep);
    murk_image_release(flat);
    world_close(&w);
}

/* R, G and B through three extinctions, and another band that is not shown. */
static void flattened_bands(void **state)
{
    static const char *const NAMES[] = {"LWIR", "B", "R", "G"};
    static float kappa_t[4][NX * NY * NZ];
    struct world w[4];
    murk_band_view view[4];
    (void)state;
    for (int b = 0; b < 4; b++) {
        murk_array array = uneven(kappa_t[b]);
        for (int n = 0; n < NX * NY * NZ; n++)
            kappa_t[b][n] *= (float)(1 + b) / 3;
        array.emission_value = 1 + b;
        world_open(&w[b], 1, &array, NULL);
        w[b].scene.sky_radiance = 0.1 * b;
        world_solve(&w[b], NULL);
        view[b] =
            (murk_band_view){.name = NAMES[b], .scene = &w[b].scene, .solution = w[b].solution};
    }
    murk_image *flat = NULL;
    murk_deep *deep = NULL;
    assert_int_equal(murk_render_bands(w[0].context, view, 4, &CAMERA, NULL, &flat), MURK_OK);
    assert_int_equal(murk_render_deep(w[0].context, view, 4, &CAMERA, NULL, &deep), MURK_OK);
    assert_flattens(deep, flat);
    murk_deep_release(deep);
    murk_image_release(flat);
    for (int b = 0; b < 4; b++)
        world_close(&w[b]);
}

/* kappa and E are constant: a ray through the length s has e^{-kappa s}, and (1 - e^{-kappa s}) E
   / pi, at every depth; one sample says so. */
static void uniform_slab(void **state)
{
    const double kappa = 3, low[3] = {0, 0, 0}, high[3] = {0.6, 0.5, 0.4};
    const murk_array array = {.size = {6, 5, 4},
                              .voxel_size = {0.1, 0.1, 0.1},
                              .kappa_t_value = kappa,
                              .emission_value = E};
    const murk_camera camera = {{-1, 0.25, 0.2}, {1, 0.25, 0.2}, {0, 0, 1}, 15, {16, 12}, 0};
    uint64_t random = 5;
    struct world w;
    (void)state;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    murk_deep *deep = take_deep(&w, &camera, &(murk_render_options){.samples = 1});
    murk_image *flat = take(&w, &camera, &(murk_render_options){.samples = 1});
    for (int n = 0; n < 16 * 12; n++) {
        const murk_deep_sample *sample = NULL;
        double along[3], from, to, got[4], z = 1 + 0.6 * check_random(&random);
        assert_int_equal(murk_deep_samples(deep, n % 16, n / 16, &sample), 1);
        look_through(&camera, n % 16, n / 16, along);
        meet_box(low, high, camera.eye, along, &from, &to);
        compose(sample, 1, z, got);
        double opacity = -expm1(-kappa * (fmin(z / along[0], to) - from));
        assert_within(sample->z, 1, 1e-6); /* a plane across the viewing axis has one depth */
        assert_within(sample->z_back, to * along[0], 1e-6);
        assert_within(pixel(flat, "Z", n % 16, n / 16), (from + to) / 2 * along[0], 2e-6);
        assert_within(got[3], opacity, 2e-6);
        assert_within(got[0], opacity * E / M_PI, 2e-6);
    }
    murk_image_release(flat);
    murk_deep_release(deep);
    world_close(&w);
}

/* Transmittance from the eye to a depth, mean of n x n rays of a pixel. */
static double mean_transmittance(const murk_array *array, const murk_camera *camera, int i, int j,
                                 int n, double z)
{
    murk_camera fine = *camera;
    double forward[3], sum = 0;
    fine.size[0] *= n;
    fine.size[1] *= n;
    for (int c = 0; c < 3; c++)
        forward[c] = camera->target[c] - camera->eye[c];
    scale_to(forward, 1);
    for (int s = 0; s < n * n; s++) {
        double along[3], from, to, depth = 0;
        look_through(&fine, i * n + s % n, j * n + s / n, along);
        double end = z / dot_product(along, forward);
        for (int x = 0; x < NX; x++)
            for (int y = 0; y < NY; y++)
                for (int k = 0; k < NZ; k++) {
                    const double low[3] = {array->origin[0] + x * EDGE, array->origin[1] + y * EDGE,
                                           array->origin[2] + k * EDGE};
                    const double high[3] = {low[0] + EDGE, low[1] + EDGE, low[2] + EDGE};
                    meet_box(low, high, camera->eye, along, &from, &to);
                    depth +=
                        array->kappa_t[check_at(array, x, y, k)] * fmax(0, fmin(to, end) - from);
                }
        sum += exp(-depth) / (n * n);
    }
    return sum;
}

/* What murk.h promises: within 1 % of the pixel's opacity at any depth. With the same E everywhere
   the light is E/pi times the opacity. */
static void cut_anywhere(void **state)
{
    static float kappa_t[NX * NY * NZ];
    const murk_array of = uneven(kappa_t);
    murk_array array = of;
    uint64_t random = 9;
    struct world w;
    double worst = 0, most = 0;
    (void)state;
    array.emission_value = E;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    for (int n = 1; n <= 3; n += 2) {
        murk_deep *deep = take_deep(&w, &CAMERA, &(murk_render_options){.samples = n});
        for (int p = 0; p < 60; p++) {
            int i = (int)(21 * check_random(&random)), j = (int)(17 * check_random(&random));
            const murk_deep_sample *sample = NULL;
            size_t count = murk_deep_samples(deep, i, j, &sample);
            double all = 1 - mean_transmittance(&of, &CAMERA, i, j, n, 9);
            for (int cut = 0; cut < 12 && all > 0; cut++) {
                double z = 1.2 + 2 * check_random(&random), got[4];
                double wanted = 1 - mean_transmittance(&of, &CAMERA, i, j, n, z);
                compose(sample, count, z, got);
                worst = fmax(worst, fabs(got[3] - wanted) / all);
                worst = fmax(worst, fabs(got[0] - wanted * E / M_PI) / (all * E / M_PI));
            }
            most = fmax(most, (double)count);
        }
        murk_deep_release(deep);
    }
    print_message("worst cut: %.2g of the pixel, %g samples at most\n", worst, most);
    assert_at_most(worst, 0.01);
    world_close(&w);
}

/* Nothing, the sky and the ground behind no medium. */
static void without_medium(void **state)
{
    const murk_array array = {.size = {1, 1, 1}, .voxel_size = {0.1, 0.1, 0.1}, .kappa_t_value = 1};
    const murk_camera camera = {{0, 0, 1}, {4, 0, 0.9}, {0, 0, 1}, 40, {3, 9}, 0};
    const murk_deep_sample *sample = NULL;
    struct world w;
    (void)state;
    world_open(&w, 1, &array, &GROUND);
    w.scene.sky_radiance = 0.5;
    world_solve(&w, NULL);
    murk_deep *deep = take_deep(&w, &camera, NULL);
    assert_int_equal(murk_deep_samples(deep, 1, 0, &sample), 1);
    assert_true(sample->z == 1e30f && sample->z_back == 1e30f && sample->a == 0);
    assert_within(sample->r, 0.5, 1e-7);
    /* The ground is hit at one depth all along a row, the farthest of its rays being the upper. */
    assert_int_equal(murk_deep_samples(deep, 1, 8, &sample), 1);
    double half = tan(20 * M_PI / 180), v = (8.25 / 9 * 2 - 1) * half, slope = 0.1 / 4;
    assert_within(sample->z, 1 * sqrt(1 + slope * slope) / (slope + v), 1e-5);
    assert_true(sample->z_back == sample->z && sample->a == 0);
    murk_deep_release(deep);
    deep = take_deep(&w, &camera, &(murk_render_options){.no_background = true});
    for (int p = 0; p < 27; p++)
        assert_int_equal(murk_deep_samples(deep, p % 3, p / 3, &sample), 0);
    murk_deep_release(deep);
    world_close(&w);
}

static void same_on_all_threads(void **state)
{
    static float kappa_t[NX * NY * NZ];
    murk_array array = uneven(kappa_t);
    murk_deep *deep[2];
    struct world w[2];
    (void)state;
    array.emission_value = E;
    for (int n = 0; n < 2; n++) {
        world_open(&w[n], n ? 3 : 1, &array, NULL);
        world_solve(&w[n], NULL);
        deep[n] = take_deep(&w[n], &CAMERA, NULL);
    }
    for (int p = 0; p < 21 * 17; p++) {
        const murk_deep_sample *sample[2] = {NULL, NULL};
        size_t count = murk_deep_samples(deep[0], p % 21, p / 21, &sample[0]);
        assert_int_equal(murk_deep_samples(deep[1], p % 21, p / 21, &sample[1]), count);
        if (count)
            assert_memory_equal(sample[0], sample[1], count * sizeof **sample);
    }
    for (int n = 0; n < 2; n++) {
        murk_deep_release(deep[n]);
        world_close(&w[n]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flattened),           cmocka_unit_test(flattened_forward),
        cmocka_unit_test(flattened_bands),     cmocka_unit_test(uniform_slab),
        cmocka_unit_test(cut_anywhere),        cmocka_unit_test(without_medium),
        cmocka_unit_test(same_on_all_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
