/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures with closed forms: bare ground, Beer-Lambert, an emitting slab. */
#include "check.h"

static int channel_of(const murk_image *image, const char *name)
{
    for (int c = 0; c < murk_image_channels(image); c++)
        if (!strcmp(murk_image_channel_name(image, c), name))
            return c;
    fail_msg("no channel %s", name);
    return 0;
}

static double pixel(const murk_image *image, int x, int y, const char *name)
{
    size_t at = (size_t)y * (size_t)murk_image_width(image) + (size_t)x;
    return murk_image_pixels_const(
        image)[at * (size_t)murk_image_channels(image) + (size_t)channel_of(image, name)];
}

static murk_image *render(struct world *w, const murk_camera *camera, int samples)
{
    const murk_render_options options = {.samples = samples};
    murk_image *image = NULL;
    if (murk_render(w->context, &w->scene, w->solution, camera, &options, &image))
        fail_msg("%s", murk_context_message(w->context));
    assert_int_equal(murk_image_width(image), camera->size[0]);
    assert_int_equal(murk_image_height(image), camera->size[1]);
    return image;
}

/* No medium: the picture is the ground, with the radiance (E + rho (F cos + pi L)) / pi of each
   patch, and the sky. */
static void bare_ground(void **state)
{
    (void)state;
    static const float nothing[8];
    const murk_array array = {
        .size = {2, 2, 2}, .voxel_size = {0.5, 0.5, 0.5}, .kappa_t = nothing, .albedo_value = 0.9};
    static const float reflectance[4] = {0.1f, 0.3f, 0.5f, 0.9f}, emission[4] = {0, 1, 2, 3};
    const double flux = 5, sky = 0.7, cosine = 0.8;
    for (int up_y = 0; up_y < 2; up_y++)
        for (int horizon = 0; horizon < 2; horizon++) {
            murk_ground_options ground = MURK_GROUND_DEFAULT;
            ground.up = up_y ? MURK_UP_Y : MURK_UP_Z;
            ground.patches[0] = ground.patches[1] = 2;
            ground.reflectance_image = reflectance;
            ground.emission_image = emission;
            ground.horizon = horizon;
            struct world w;
            world_open(&w, 2, &array, &ground);
            w.scene.sun = (murk_sun){{0.6, up_y ? -cosine : 0, up_y ? 0 : -cosine}, flux};
            w.scene.sky_radiance = sky;
            world_solve(&w, NULL);
            assert_int_equal(murk_solution_report(w.solution)->zones, 0);
            /* From above, x to the right and image order from the top. */
            murk_camera camera = {.eye = {0.5, up_y ? 3 : 0.5, up_y ? 0.5 : 3},
                                  .target = {0.5, up_y ? 0 : 0.5, up_y ? 0.5 : 0},
                                  .up = {0, up_y ? 0 : 1, up_y ? -1 : 0},
                                  .fov = 2 * 180 / M_PI * atan(0.5 / 3),
                                  .size = {2, 2}};
            murk_image *image = render(&w, &camera, 3);
            for (int i = 0; i < 4; i++) {
                double lit = flux * cosine + M_PI * sky;
                double wanted = (emission[i] + reflectance[i] * lit) / M_PI;
                assert_within(pixel(image, i % 2, i / 2, "R"), wanted, 1e-6 * wanted);
                assert_within(pixel(image, i % 2, i / 2, "surface.G"), wanted, 1e-6 * wanted);
                assert_within(pixel(image, i % 2, i / 2, "path.B"), 0, 0);
                assert_within(pixel(image, i % 2, i / 2, "A"), 0, 0);
                assert_within(pixel(image, i % 2, i / 2, "transmittance.Y"), 1, 0);
                assert_true(isinf(pixel(image, i % 2, i / 2, "Z")));
            }
            murk_image_release(image);
            /* Far beside the extent: the mean over the patches, or, without horizon, the sky. */
            camera.eye[0] = camera.target[0] = 1000;
            image = render(&w, &camera, 1);
            double wanted = horizon ? (1.5 + 0.45 * (flux * cosine + M_PI * sky)) / M_PI : sky;
            assert_within(pixel(image, 0, 0, "R"), wanted, 1e-6 * wanted);
            murk_image_release(image);
            world_close(&w);
        }
}

/* Unit vectors to the middles of pixels of a camera that looks down, its up along y. */
static void down_ray(const murk_camera *camera, int x, int y, double out[3])
{
    double half = tan(camera->fov * M_PI / 360);
    out[0] = half * ((2 * x + 1.0) / camera->size[0] - 1) * camera->size[0] / camera->size[1];
    out[1] = half * (1 - (2 * y + 1.0) / camera->size[1]);
    out[2] = -1;
    double length = sqrt(out[0] * out[0] + out[1] * out[1] + 1);
    for (int a = 0; a < 3; a++)
        out[a] /= length;
}

/* Layers of different kappa_t with no scattering and one emission: transmittance exp(-tau),
   radiance of the medium (1 - exp(-tau)) E / pi, half of tau at a distance that follows from the
   layers. */
static void layers(void **state)
{
    (void)state;
    enum { N = 20 };
    static float kappa_t[N * N * N];
    const double dz = 0.05, emission = 2, sky = 0.25;
    for (int i = 0; i < N * N * N; i++)
        kappa_t[i] = (float)(0.3 * (1 + i % N % 5)); /* by z: five values, four times */
    const murk_array array = {.size = {N, N, N},
                              .voxel_size = {0.1, 0.1, dz},
                              .origin = {-1, -1, 0},
                              .kappa_t = kappa_t,
                              .emission_value = emission};
    struct world w;
    world_open(&w, 2, &array, NULL);
    w.scene.sky_radiance = sky;
    world_solve(&w, NULL);
    const murk_camera camera = {
        .eye = {0, 0, 4}, .target = {0, 0, 0}, .up = {0, 1, 0}, .fov = 20, .size = {7, 5}};
    murk_image *image = render(&w, &camera, 1);
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 7; x++) {
            double ray[3], vertical = 4 * dz * 0.3 * (1 + 2 + 3 + 4 + 5);
            down_ray(&camera, x, y, ray);
            double tau = vertical / -ray[2], opacity = -expm1(-tau);
            assert_within(pixel(image, x, y, "transmittance.Y"), exp(-tau), 1e-6);
            assert_within(pixel(image, x, y, "A"), opacity, 1e-6);
            assert_within(pixel(image, x, y, "surface.R"), exp(-tau) * sky, 1e-6);
            assert_within(pixel(image, x, y, "R"),
                          pixel(image, x, y, "path.R") + pixel(image, x, y, "surface.R"), 1e-6);
            /* Half of the vertical depth is passed in the middle of the four equal stacks. */
            assert_within(pixel(image, x, y, "Z"), (4 - 0.5) / -ray[2], 1e-5);
            assert_within(pixel(image, x, y, "path.R"), opacity * emission / M_PI, 1e-6);
        }
    murk_image_release(image);
    world_close(&w);
}

/* Pixel values are means over the pixel: with n x n samples the middles of n x n parts. */
static void pixel_means(void **state)
{
    (void)state;
    static const float nothing[1];
    const murk_array array = {.size = {1, 1, 1}, .voxel_size = {1, 1, 1}, .kappa_t = nothing};
    static const float emission[4] = {1, 0, 0, 0}; /* top left as an image */
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = ground.patches[1] = 2;
    ground.emission_image = emission;
    ground.horizon = false;
    struct world w;
    world_open(&w, 1, &array, &ground);
    world_solve(&w, NULL);
    const murk_camera camera = {.eye = {0.5, 0.5, 1},
                                .target = {0.5, 0.5, 0},
                                .up = {0, 1, 0},
                                .fov = 2 * 180 / M_PI * atan(0.5),
                                .size = {1, 1}};
    murk_image *image = render(&w, &camera, 4);
    assert_within(pixel(image, 0, 0, "R"), 0.25 / M_PI, 1e-7);
    murk_image_release(image);
    world_close(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bare_ground),
        cmocka_unit_test(layers),
        cmocka_unit_test(pixel_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
