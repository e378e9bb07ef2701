/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures with a closed form: [BG91] eq. (11) where B is constant, linear or 0. Pixels are float:
   1e-6 of the largest value is 8 units in the last place. */
#include "camera.h"

static const double E = 2, KAPPA = 3;

/* A box of 6 x 5 x 4 cubes of 0.1 m. */
static const double LOW[3] = {0.2, -0.1, 0.3}, HIGH[3] = {0.8, 0.4, 0.7};

static murk_array box_array(double kappa_t, double albedo, double emission)
{
    return (murk_array){.size = {6, 5, 4},
                        .voxel_size = {0.1, 0.1, 0.1},
                        .origin = {LOW[0], LOW[1], LOW[2]},
                        .kappa_t_value = kappa_t,
                        .albedo_value = albedo,
                        .emission_value = emission};
}

/* Along x, askew, and from inside the medium. */
static const murk_camera CAMERAS[] = {
    {{-1, 0.13, 0.48}, {1, 0.13, 0.48}, {0, 0, 1}, 40, {33, 25}, 0},
    {{1.6, -1.3, 1.4}, {0.5, 0.1, 0.5}, {0.1, 0.2, 1}, 45, {31, 22}, 0},
    {{0.41, 0.07, 0.52}, {0.1, 0.3, 0.45}, {0, 1, 0}, 100, {21, 24}, 0},
};

enum { CAMERA_COUNT = sizeof CAMERAS / sizeof *CAMERAS };

static const murk_render_options ONE_SAMPLE = {.samples = 1};

/* ---- Medium ---- */

static void transmittance(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0.5, 0);
    struct world w;
    world_open(&w, 1, &array, NULL);
    w.scene.sky_radiance = 0.2;
    world_solve(&w, NULL);
    for (int c = 0; c < CAMERA_COUNT; c++) {
        murk_image *image = take(&w, &CAMERAS[c], &ONE_SAMPLE);
        for (int j = 0; j < CAMERAS[c].size[1]; j++)
            for (int i = 0; i < CAMERAS[c].size[0]; i++) {
                double along[3];
                look_through(&CAMERAS[c], i, j, along);
                double t = exp(-KAPPA * chord(LOW, HIGH, CAMERAS[c].eye, along));
                float got = pixel(image, "transmittance.Y", i, j);
                assert_within(got, t, 1e-6);
                assert_true(pixel(image, "A", i, j) == 1 - got);
                assert_true(pixel(image, "R", i, j) ==
                            pixel(image, "path.R", i, j) + pixel(image, "surface.R", i, j));
                assert_within(pixel(image, "surface.R", i, j), 0.2 * t, 1e-6);
                /* One band in all three. */
                assert_true(pixel(image, "R", i, j) == pixel(image, "B", i, j));
            }
        murk_image_release(image);
    }
    world_close(&w);
}

/* Parallel rays: from a point each, all along the line of sight. */
static void parallel(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0, E);
    murk_camera views[CAMERA_COUNT - 1];
    struct world w;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    for (int n = 0; n < CAMERA_COUNT - 1; n++) {
        views[n] = CAMERAS[n];
        views[n].height = 0.91; /* no ray along a face */
        views[n].fov = 0;
        double right[3], up[3], along[3], pitch = views[n].height / views[n].size[1];
        for (int c = 0; c < 3; c++)
            along[c] = views[n].target[c] - views[n].eye[c];
        scale_to(along, 1);
        cross_product(along, views[n].up, right);
        scale_to(right, 1);
        cross_product(right, along, up);
        murk_image *image = take(&w, &views[n], &ONE_SAMPLE);
        int hit = 0;
        for (int j = 0; j < views[n].size[1]; j++)
            for (int i = 0; i < views[n].size[0]; i++) {
                double x = (i + 0.5 - views[n].size[0] / 2.0) * pitch, from[3];
                double y = (views[n].size[1] / 2.0 - j - 0.5) * pitch;
                for (int c = 0; c < 3; c++)
                    from[c] = views[n].eye[c] + x * right[c] + y * up[c];
                double s = chord(LOW, HIGH, from, along);
                hit += s > 0;
                assert_within(pixel(image, "transmittance.Y", i, j), exp(-KAPPA * s), 1e-6);
                assert_within(pixel(image, "path.R", i, j), -expm1(-KAPPA * s) * E / M_PI, 1e-6);
            }
        assert_true(hit > 100 && hit < views[n].size[0] * views[n].size[1]);
        murk_image_release(image);
    }
    world_close(&w);
}

/* Without scattering B = E everywhere, so a path of the transmittance T sends (1 - T) E/pi. */
static void emission(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0, E);
    struct world w;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    for (int c = 0; c < CAMERA_COUNT; c++) {
        murk_image *image = take(&w, &CAMERAS[c], &ONE_SAMPLE);
        for (int j = 0; j < CAMERAS[c].size[1]; j++)
            for (int i = 0; i < CAMERAS[c].size[0]; i++) {
                double along[3];
                look_through(&CAMERAS[c], i, j, along);
                double s = chord(LOW, HIGH, CAMERAS[c].eye, along);
                assert_within(pixel(image, "path.R", i, j), -expm1(-KAPPA * s) * E / M_PI, 1e-6);
            }
        murk_image_release(image);
    }
    world_close(&w);
}

/*
 * B = E is linear in the position and kappa constant in an inner box; a shell of two zones around
 * it is so thin that it only continues B. A path that enters the inner box at the distance t with
 * B = b0, and B' along it, over the length s, sends
 *   (1/pi) (b0 (1 - e^{-kappa s}) + B' ((1 - e^{-kappa s}) / kappa - s e^{-kappa s})),
 * trilinear interpolation is exact for it, and so is each step.
 */
static void linear_source(void **state)
{
    (void)state;
    enum { NX = 13, NY = 11, NZ = 10 };
    static float kappa_t[NX * NY * NZ], glow[NX * NY * NZ];
    const double slope[3] = {0.8, -0.5, 0.6}, voxel[3] = {0.1, 0.1, 0.05};
    const double low[3] = {0.2, 0.2, 0.1}, high[3] = {1.1, 0.9, 0.4};
    murk_array array = {.size = {NX, NY, NZ},
                        .voxel_size = {voxel[0], voxel[1], voxel[2]},
                        .kappa_t = kappa_t,
                        .emission = glow};
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++)
            for (int k = 0; k < NZ; k++) {
                const double at[3] = {(i + 0.5) * voxel[0], (j + 0.5) * voxel[1],
                                      (k + 0.5) * voxel[2]};
                bool inner = i >= 2 && i < NX - 2 && j >= 2 && j < NY - 2 && k >= 2 && k < NZ - 2;
                kappa_t[check_at(&array, i, j, k)] = inner ? 4.0f : 1e-10f;
                glow[check_at(&array, i, j, k)] = (float)(1 + dot_product(slope, at));
            }
    struct world w;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    const murk_camera camera = {{2.1, -1.2, 1.3}, {0.6, 0.5, 0.25}, {0, 0, 1}, 32, {40, 30}, 0};
    murk_image *image = take(&w, &camera, &ONE_SAMPLE);
    for (int j = 0; j < 30; j++)
        for (int i = 0; i < 40; i++) {
            double along[3], entry[3], from, to, wanted = 0;
            look_through(&camera, i, j, along);
            meet_box(low, high, camera.eye, along, &from, &to);
            if (to > from) {
                double s = to - from, taken = -expm1(-4 * s);
                for (int c = 0; c < 3; c++)
                    entry[c] = camera.eye[c] + from * along[c];
                wanted = (1 + dot_product(slope, entry)) * taken +
                         dot_product(slope, along) * (taken / 4 - s * exp(-4 * s));
            }
            assert_within(pixel(image, "path.R", i, j), wanted / M_PI, 1e-6);
        }
    murk_image_release(image);
    world_close(&w);
}

/* In an enclosure of one temperature everything looks alike. */
static void enclosure(void **state)
{
    (void)state;
    static const double albedos[] = {1, 0.6, 0};
    const float rho[6] = {0.1f, 0.9f, 0.4f, 0.6f, 0, 1};
    float glow[6];
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = 3;
    ground.patches[1] = 2;
    ground.reflectance_image = rho;
    ground.emission_image = glow;
    for (int i = 0; i < 6; i++)
        glow[i] = (float)(E * (1 - rho[i]));
    for (size_t n = 0; n < sizeof albedos / sizeof *albedos; n++) {
        const murk_array array = box_array(KAPPA, albedos[n], E);
        struct world w;
        world_open(&w, 1, &array, &ground);
        w.scene.sky_radiance = E / M_PI;
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.tolerance = 1e-4;
        world_solve(&w, &options);
        for (int c = 0; c < CAMERA_COUNT; c++) {
            murk_image *image = take(&w, &CAMERAS[c], NULL);
            for (int j = 0; j < CAMERAS[c].size[1]; j++)
                for (int i = 0; i < CAMERAS[c].size[0]; i++)
                    assert_within(pixel(image, "R", i, j), E / M_PI, 1e-5);
            murk_image_release(image);
        }
        world_close(&w);
    }
}

/* ---- Depth ---- */

static void half_depth(void **state)
{
    (void)state;
    static float kappa_t[120];
    murk_array array = box_array(KAPPA, 0.5, 0);
    murk_camera camera = {{-1.5, 0.13, 0.48}, {1, 0.13, 0.48}, {0, 0, 1}, 40, {1, 1}, 0};
    /* 1.7 m to the box, 0.6 m within it; kappa = 1, then 3: 0.3 + 0.9 optical depths, of which 0.6
       are passed 0.3 / 3 behind the middle. */
    for (int varied = 0; varied < 2; varied++) {
        for (size_t i = 0; i < check_count(&array); i++)
            kappa_t[i] = i < 60 ? 1 : 3;
        array.kappa_t = varied ? kappa_t : NULL;
        struct world w;
        world_open(&w, 1, &array, NULL);
        world_solve(&w, NULL);
        murk_image *image = take(&w, &camera, &ONE_SAMPLE);
        assert_within(pixel(image, "Z", 0, 0), varied ? 1.7 + 0.3 + 0.1 : 1.7 + 0.3, 2e-6);
        murk_image_release(image);
        murk_camera away = camera;
        away.target[0] = -2;
        image = take(&w, &away, NULL);
        assert_true(isinf(pixel(image, "Z", 0, 0)) && pixel(image, "Z", 0, 0) > 0);
        assert_true(pixel(image, "A", 0, 0) == 0);
        murk_image_release(image);
        world_close(&w);
    }
}

/* ---- Pictures over other pictures ---- */

static void background(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0.8, E);
    struct world w;
    world_open(&w, 1, &array, NULL);
    w.scene.sky_radiance = 0.2;
    w.scene.sun = (murk_sun){{0.5, 0.2, -0.7}, 1};
    world_solve(&w, NULL);
    const char *const names[3] = {"R", "G", "B"};
    const float colour[3] = {0.7f, 0.4f, 0.1f};
    murk_image *plate = NULL;
    assert_int_equal(murk_image_create(w.context, 5, 4, 3, names, &plate), MURK_OK);
    for (int i = 0; i < 5 * 4 * 3; i++)
        murk_image_pixels(plate)[i] = colour[i % 3];
    const murk_camera *camera = &CAMERAS[1];
    murk_image *full = take(&w, camera, NULL);
    murk_image *bare = take(&w, camera, &(murk_render_options){.no_background = true});
    murk_image *over = take(&w, camera, &(murk_render_options){.background = plate});
    for (int j = 0; j < camera->size[1]; j++)
        for (int i = 0; i < camera->size[0]; i++) {
            float t = pixel(bare, "transmittance.Y", i, j);
            assert_true(pixel(bare, "A", i, j) == pixel(full, "A", i, j));
            assert_true(pixel(bare, "path.R", i, j) == pixel(full, "path.R", i, j));
            assert_true(pixel(bare, "surface.R", i, j) == 0);
            assert_true(pixel(bare, "R", i, j) == pixel(bare, "path.R", i, j));
            for (int c = 0; c < 3; c++)
                assert_within(pixel(over, names[c], i, j),
                              pixel(bare, names[c], i, j) + t * colour[c], 1e-6);
        }
    murk_image_release(full);
    murk_image_release(bare);
    murk_image_release(over);
    murk_image_release(plate);
    world_close(&w);
}

/*
 * A slab of optical thickness tau that fills the frame has the transmittance
 * f = e^{-tau s}, s = (1 + u^2 + v^2)^(1/2), at the picture point (u, v). |f_uu| and |f_vv| are at
 * most e^{-tau} (tau^2 w^2 + tau) for |u|, |v| <= w. The midpoint rule on squares of the edge h
 * misses the mean by at most h^2 / 24 of their sum; n samples an axis make that h/n.
 */
static void samples(void **state)
{
    (void)state;
    const murk_array array = {.size = {16, 16, 2},
                              .voxel_size = {0.5, 0.5, 0.25},
                              .origin = {-4, -4, 0},
                              .kappa_t_value = 2,
                              .albedo_value = 0.5};
    struct world w;
    world_open(&w, 1, &array, NULL);
    world_solve(&w, NULL);
    const double tau = 1, half = 1, h = 2 * half / 8;
    const murk_camera camera = {{0.03, 0.01, 2}, {0.03, 0.01, 0}, {0, 1, 0}, 90, {8, 8}, 0};
    murk_image *coarse = take(&w, &camera, &ONE_SAMPLE);
    murk_image *fine = take(&w, &camera, &(murk_render_options){.samples = 4});
    murk_image *two = take(&w, &camera, &(murk_render_options){.samples = 2});
    murk_image *usual = take(&w, &camera, NULL);
    double bound = h * h / 24 * (1 + 1 / 16.) * 2 * exp(-tau) * (tau * tau * half * half + tau);
    double difference = mean_pixel(coarse, "transmittance.Y") - mean_pixel(fine, "transmittance.Y");
    assert_within(difference, 0, bound);
    assert_true(difference != 0);
    assert_memory_equal(murk_image_pixels(two), murk_image_pixels(usual),
                        64 * (size_t)murk_image_channels(two) * sizeof(float));
    murk_image_release(coarse);
    murk_image_release(fine);
    murk_image_release(two);
    murk_image_release(usual);
    world_close(&w);
}

/* One solution, rendered by one thread and by two: the same bits. */
static void threads(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0.9, 0.1);
    const murk_ground_options ground = MURK_GROUND_DEFAULT;
    struct world w;
    world_open(&w, 1, &array, &ground);
    w.scene.sun = (murk_sun){{0.5, 0.2, -0.7}, 1};
    w.scene.sky_radiance = 0.1;
    world_solve(&w, NULL);
    murk_image *one = take(&w, &CAMERAS[1], NULL), *two = NULL;
    murk_context *pair = check_context(2, NULL);
    assert_int_equal(murk_render(pair, &w.scene, w.solution, &CAMERAS[1], NULL, &two), MURK_OK);
    assert_memory_equal(murk_image_pixels(one), murk_image_pixels(two),
                        31 * 22 * (size_t)murk_image_channels(one) * sizeof(float));
    murk_image_release(one);
    murk_image_release(two);
    world_close(&w);
    murk_context_release(pair);
}

/* ---- Errors ---- */

static void refuse(struct world *w, const murk_camera *camera)
{
    murk_image *mark = (murk_image *)w, *image = mark;
    assert_int_equal(murk_render(w->context, &w->scene, w->solution, camera, NULL, &image),
                     MURK_ERROR_INPUT);
    assert_ptr_equal(image, mark);
    assert_true(strlen(murk_context_message(w->context)) > 0);
    assert_null(strchr(murk_context_message(w->context), '\n'));
    assert_int_equal(murk_camera_check(w->context, &w->scene, camera), MURK_ERROR_INPUT);
    assert_true(strlen(murk_context_message(w->context)) > 0);
}

static void errors(void **state)
{
    (void)state;
    const murk_array array = box_array(KAPPA, 0.5, 0);
    const murk_ground_options ground = MURK_GROUND_DEFAULT;
    struct world w;
    world_open(&w, 1, &array, &ground);
    world_solve(&w, NULL);
    const double bad_fov[] = {0, -40, 180, 400, NAN};
    for (int n = 0; n < 5; n++) {
        murk_camera camera = CAMERAS[0];
        camera.fov = bad_fov[n];
        refuse(&w, &camera);
    }
    murk_camera bad[7];
    for (int n = 0; n < 7; n++)
        bad[n] = CAMERAS[0];
    bad[0].size[0] = 0;
    bad[1].size[1] = -3;
    memcpy(bad[2].target, bad[2].eye, sizeof bad[2].eye);
    bad[3].eye[2] = -0.1;
    bad[4].eye[2] = 0; /* on the ground itself */
    bad[5].up[0] = 1;  /* along the line of sight */
    bad[5].up[2] = 0;
    bad[6].target[1] = INFINITY;
    for (int n = 0; n < 7; n++)
        refuse(&w, &bad[n]);
    assert_int_equal(murk_camera_check(w.context, &w.scene, &CAMERAS[0]), MURK_OK);
    world_close(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transmittance), cmocka_unit_test(parallel),  cmocka_unit_test(emission),
        cmocka_unit_test(linear_source), cmocka_unit_test(enclosure), cmocka_unit_test(half_depth),
        cmocka_unit_test(background),    cmocka_unit_test(samples),   cmocka_unit_test(threads),
        cmocka_unit_test(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
