/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures of bands, against closed forms: isothermal scenes, layers before walls, what a sensor's
   signal consists of. */
#include "camera.h"
#include "murk/bands.h"

static const murk_band LWIR = {{8e-6, 12e-6}}, MWIR = {{3e-6, 5e-6}}, RED = {{0.6e-6, 0.7e-6}};

static const murk_render_options ONE_SAMPLE = {.samples = 1};

/* A box over a ground, and a camera that looks down at it askew. */
static const double LOW[3] = {0.1, 0.2, 0.1}, HIGH[3] = {0.9, 0.8, 0.5};
static const murk_camera DOWN = {{0.3, -0.4, 2.1}, {0.5, 0.5, 0.3}, {0, 1, 0}, 45, {24, 18}, 0};

static murk_array box_array(double kappa_t, double albedo, double emission)
{
    return (murk_array){.size = {8, 6, 4},
                        .voxel_size = {0.1, 0.1, 0.1},
                        .origin = {LOW[0], LOW[1], LOW[2]},
                        .kappa_t_value = kappa_t,
                        .albedo_value = albedo,
                        .emission_value = emission};
}

/* A ground of temperature `kelvin` with patches of two reflectances. */
static murk_ground_options warm_ground(double kelvin, const murk_band *band, float *reflectance,
                                       float *emission)
{
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = ground.patches[1] = 8;
    for (int i = 0; i < 64; i++) {
        reflectance[i] = (i + i / 8) % 2 ? 0.5f : 0.1f;
        emission[i] = (float)((1 - reflectance[i]) * M_PI * murk_planck_radiance(band, kelvin));
    }
    ground.reflectance_image = reflectance;
    ground.emission_image = emission;
    return ground;
}

static murk_image *take_band(const struct world *w, const char *name, const murk_band *band,
                             double mass_extinction)
{
    const murk_band_view view = {name, *band, mass_extinction, &w->scene, w->solution};
    murk_image *image = NULL;
    if (murk_render_bands(w->context, &view, 1, &DOWN, &ONE_SAMPLE, &image))
        fail_msg("%s", murk_context_message(w->context));
    return image;
}

/* The channels of a picture can be told before it is taken. */
static void assert_foreseen(const struct world *w, const murk_image *image,
                            const murk_band_view *views, size_t count)
{
    static const int size[2] = {1, 1};
    murk_image *foreseen = NULL;
    assert_int_equal(murk_bands_picture(w->context, views, count, size, &foreseen), MURK_OK);
    assert_int_equal(murk_image_channels(foreseen), murk_image_channels(image));
    for (int c = 0; c < murk_image_channels(image); c++) {
        bool found = false;
        for (int d = 0; d < murk_image_channels(foreseen); d++)
            found |=
                !strcmp(murk_image_channel_name(foreseen, d), murk_image_channel_name(image, c));
        assert_true(found);
    }
    murk_image_release(foreseen);
}

/* What a box of one temperature over ground and under a sky of the same looks like: nothing. */
static void isothermal(void **state)
{
    (void)state;
    enum { COUNT = 8 * 6 * 4 };
    static const double kelvin[3] = {300, 280, 1500};
    const murk_band bands[3] = {LWIR, MWIR, RED};
    for (int rough = 0; rough < 2; rough++)
        for (int n = 0; n < 3; n++) {
            static float kappa_t[COUNT], albedo[COUNT];
            float reflectance[64], glow[64];
            uint64_t random = 7;
            double e = M_PI * murk_planck_radiance(&bands[n], kelvin[n]);
            murk_array array = box_array(3, n == 0 ? 0 : n == 1 ? 0.6 : 0.99, e);
            for (int i = 0; i < COUNT; i++) {
                kappa_t[i] = (float)pow(10, 3 * check_random(&random) - 1.5);
                albedo[i] = (float)check_random(&random);
            }
            if (rough) {
                array.kappa_t = kappa_t;
                array.albedo = albedo;
            }
            murk_ground_options ground = warm_ground(kelvin[n], &bands[n], reflectance, glow);
            struct world w;
            world_open(&w, 1, &array, &ground);
            w.scene.sky_radiance = e / M_PI;
            world_solve(&w, NULL);
            murk_image *image = take_band(&w, "X", &bands[n], 0);
            for (int j = 0; j < DOWN.size[1]; j++)
                for (int i = 0; i < DOWN.size[0]; i++)
                    assert_within(pixel(image, "X.temperature", i, j), kelvin[n], 1e-6 * kelvin[n]);
            murk_image_release(image);
            world_close(&w);
        }
}

/* An absorbing layer at T1 before a wall at T2: L = e^{-tau} L(T2) + (1 - e^{-tau}) L(T1). */
static void layer_before_wall(void **state)
{
    (void)state;
    const double layer = 285, wall = 330, kappa = 2.5;
    murk_array array = box_array(kappa, 0, M_PI * murk_planck_radiance(&LWIR, layer));
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.reflectance = 0;
    ground.emission = M_PI * murk_planck_radiance(&LWIR, wall);
    struct world w;
    world_open(&w, 1, &array, &ground);
    world_solve(&w, NULL);
    murk_image *image = take_band(&w, "LWIR", &LWIR, 0.25);
    for (int j = 0; j < DOWN.size[1]; j++)
        for (int i = 0; i < DOWN.size[0]; i++) {
            double along[3];
            look_through(&DOWN, i, j, along);
            double s = chord(LOW, HIGH, DOWN.eye, along), t = exp(-kappa * s);
            double behind = murk_planck_radiance(&LWIR, wall),
                   radiance = t * behind + (1 - t) * murk_planck_radiance(&LWIR, layer);
            assert_within(pixel(image, "LWIR.temperature", i, j),
                          murk_planck_temperature(&LWIR, radiance), 1e-3);
            assert_within(pixel(image, "LWIR.transmittance", i, j), t, 1e-6);
            assert_within(pixel(image, "LWIR.inherent", i, j) / behind, 1, 1e-6);
            /* Beer and Lambert: nothing is scattered into the line of sight. */
            assert_within(pixel(image, "LWIR.surface", i, j) / (t * behind), 1, 1e-5);
            assert_true(pixel(image, "LWIR.scattered", i, j) == 0);
            assert_within(pixel(image, "CL.Y", i, j), kappa * s / 0.25, 1e-5);
        }
    murk_image_release(image);
    world_close(&w);
}

/* A uniform box that glows and scatters radiates (1 - albedo) E / pi (1 - e^{-tau}) by itself; the
   rest of the path's light is scattered. */
static void parts(void **state)
{
    (void)state;
    const double kappa = 4, albedo = 0.7, e = 3;
    const murk_band none = {{0, 0}};
    murk_array array = box_array(kappa, albedo, e);
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    struct world w;
    world_open(&w, 1, &array, &ground);
    w.scene.sun = (murk_sun){{0.3, 0.2, -1}, 5};
    w.scene.sky_radiance = 0.3;
    world_solve(&w, NULL);
    murk_image *image = take_band(&w, "G", &none, 0), *plain = take(&w, &DOWN, &ONE_SAMPLE);
    for (int j = 0; j < DOWN.size[1]; j++)
        for (int i = 0; i < DOWN.size[0]; i++) {
            double along[3];
            look_through(&DOWN, i, j, along);
            double s = chord(LOW, HIGH, DOWN.eye, along);
            float radiance = pixel(image, "G.radiance", i, j);
            float emitted = pixel(image, "G.emitted", i, j);
            assert_within(emitted, (1 - albedo) * e / M_PI * -expm1(-kappa * s), 1e-6);
            assert_within(pixel(image, "G.surface", i, j) + pixel(image, "G.scattered", i, j) +
                              emitted,
                          radiance, 1e-6 * radiance);
            assert_true(radiance == pixel(plain, "R", i, j));
            assert_true(pixel(image, "R", i, j) == radiance);
            assert_true(pixel(image, "path.B", i, j) == pixel(plain, "path.B", i, j));
            assert_true(pixel(image, "A", i, j) == pixel(plain, "A", i, j));
            assert_true(pixel(image, "Z", i, j) == pixel(plain, "Z", i, j));
        }
    for (int c = 0; c < murk_image_channels(image); c++)
        assert_null(strstr(murk_image_channel_name(image, c), "temperature"));
    murk_image_release(image);
    murk_image_release(plain);
    world_close(&w);
}

/* Three bands of the colours' names give the colours of the picture, in any order. */
static void colors(void **state)
{
    (void)state;
    static const char *const names[4] = {"LWIR", "B", "R", "G"};
    static const double glow[4] = {9, 1, 2, 3};
    struct world w[4];
    murk_band_view view[4];
    for (int n = 0; n < 4; n++) {
        murk_array array = box_array(1 + n, 0, glow[n]);
        world_open(&w[n], 1, &array, NULL);
        world_solve(&w[n], NULL);
        view[n] = (murk_band_view){names[n], LWIR, 0, &w[n].scene, w[n].solution};
    }
    murk_image *image = NULL;
    assert_int_equal(murk_render_bands(w[0].context, view, 4, &DOWN, NULL, &image), MURK_OK);
    assert_foreseen(&w[0], image, view, 4);
    murk_image *plain = NULL;
    assert_int_equal(murk_render(w[0].context, &w[0].scene, w[0].solution, &DOWN, NULL, &plain),
                     MURK_OK);
    assert_foreseen(&w[0], plain, NULL, 0);
    murk_image_release(plain);
    double a = 0;
    for (int n = 1; n < 4; n++) {
        char from[32], to[32];
        snprintf(from, sizeof from, "%s.radiance", names[n]);
        snprintf(to, sizeof to, "path.%s", names[n]);
        assert_true(pixel(image, names[n], 12, 9) == pixel(image, from, 12, 9));
        assert_true(pixel(image, to, 12, 9) == pixel(image, from, 12, 9));
        snprintf(from, sizeof from, "%s.transmittance", names[n]);
        a += pixel(image, from, 12, 9) / 3;
    }
    assert_within(pixel(image, "A", 12, 9), 1 - a, 1e-6);
    assert_true(pixel(image, "LWIR.radiance", 12, 9) > pixel(image, "G", 12, 9));
    assert_string_equal(murk_image_attribute(image, "murk:bands"),
                        "LWIR:8e-06:1.2e-05,B:8e-06:1.2e-05,R:8e-06:1.2e-05,G:8e-06:1.2e-05");
    murk_image_release(image);
    image = NULL;
    view[3].name = "R";
    assert_int_equal(murk_render_bands(w[0].context, view, 4, &DOWN, NULL, &image),
                     MURK_ERROR_INPUT);
    view[3].name = "near.infrared";
    assert_int_equal(murk_render_bands(w[0].context, view, 4, &DOWN, NULL, &image),
                     MURK_ERROR_INPUT);
    assert_null(image);
    for (int n = 0; n < 4; n++)
        world_close(&w[n]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isothermal),
        cmocka_unit_test(layer_before_wall),
        cmocka_unit_test(parts),
        cmocka_unit_test(colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
