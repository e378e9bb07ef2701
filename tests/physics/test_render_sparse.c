/* SPDX-License-Identifier: Apache-2.0 */
/* What rendering leaps over or leaves out must not show: empty space, bricks out of sight, ground
   outside the shadow, media behind an opaque one. Black media that glow alike, B = E: a path sends
   (1 - tau) E / pi. */
#include "camera.h"

enum { NX = 21, NY = 19, NZ = 26 };

static const double E = 2, F = 1.5, VOXEL = 0.1;
static const double ORIGIN[3] = {-0.93, -1.07, 0.13};
static float kappa_t[NX * NY * NZ];

/* Clumps of zones with holes and empty bricks between them. */
static murk_array clumps(double most)
{
    uint64_t random = 11;
    murk_array array = {.size = {NX, NY, NZ},
                        .voxel_size = {VOXEL, VOXEL, VOXEL},
                        .origin = {ORIGIN[0], ORIGIN[1], ORIGIN[2]},
                        .kappa_t = kappa_t,
                        .emission_value = E};
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++)
            for (int k = 0; k < NZ; k++) {
                bool clump = sin(0.7 * i) + sin(0.9 * j + 1) + sin(0.6 * k) > 0.9;
                double value = check_random(&random);
                kappa_t[check_at(&array, i, j, k)] =
                    (float)(clump && value > 0.2 ? most * value : 0);
            }
    return array;
}

/* Optical depth along a ray up to t, from the chord through every voxel. */
static double depth_along(const double at[3], const double along[3], double t)
{
    double depth = 0;
    for (int n = 0; n < NX * NY * NZ; n++) {
        const int voxel[3] = {n / NZ / NY, n / NZ % NY, n % NZ};
        double low[3], high[3], from, to;
        if (!(kappa_t[n] > 0))
            continue;
        for (int a = 0; a < 3; a++) {
            low[a] = ORIGIN[a] + VOXEL * voxel[a];
            high[a] = ORIGIN[a] + VOXEL * (voxel[a] + 1);
        }
        meet_box(low, high, at, along, &from, &to);
        depth += (double)kappa_t[n] * fmax(0, fmin(to, t) - from);
    }
    return depth;
}

/* From outside, far away, from inside with a wide angle, along an axis, and away from it. */
static const murk_camera CAMERAS[] = {
    {{3.1, -3.3, 2.9}, {0.1, -0.1, 1.4}, {0, 0, 1}, 45, {31, 23}, 0},
    {{400, 300, 500}, {0.1, -0.1, 1.4}, {0, 0, 1}, 0.3, {29, 27}, 0},
    {{0.11, -0.13, 1.43}, {-1, 0.2, 1.1}, {0, 0, 1}, 150, {37, 21}, 0},
    {{0.12, -4, 1.42}, {0.12, 0, 1.42}, {0, 0, 1}, 40, {15, 17}, 0},
    {{1.6, 1.2, 1.4}, {4, 2, 1.5}, {0, 0, 1}, 120, {17, 15}, 0},
};

enum { CAMERA_COUNT = sizeof CAMERAS / sizeof *CAMERAS };

static const murk_render_options ONE_SAMPLE = {.samples = 1};

static void sparse(void **state)
{
    (void)state;
    const double most[] = {0.8, 40}; /* 0.08 and 4 optical depths a voxel */
    for (int n = 0; n < 2; n++) {
        const murk_array array = clumps(most[n]);
        struct world w;
        world_open(&w, 1, &array, NULL);
        world_solve(&w, NULL);
        int through = 0;
        for (int c = 0; c < CAMERA_COUNT; c++) {
            const murk_camera *camera = &CAMERAS[c];
            murk_image *image = take(&w, camera, &ONE_SAMPLE);
            for (int j = 0; j < camera->size[1]; j++)
                for (int i = 0; i < camera->size[0]; i++) {
                    double along[3];
                    look_through(camera, i, j, along);
                    double depth = depth_along(camera->eye, along, INFINITY);
                    through += depth > 0;
                    assert_within(pixel(image, "transmittance.Y", i, j), exp(-depth), 2e-6);
                    assert_within(pixel(image, "path.R", i, j), -expm1(-depth) * E / M_PI, 2e-6);
                }
            murk_image_release(image);
        }
        assert_true(through > 1000);
        world_close(&w);
    }
}

/* The ground ends rays and is lit through the medium, by a steep, a vertical and a low sun. */
static void shadow(void **state)
{
    (void)state;
    const double suns[][3] = {{0.6, 0.3, -0.7}, {0, 0, -1}, {-0.9, 0.4, -0.2}};
    for (int n = 0; n < 3; n++) {
        murk_array array = clumps(0.8);
        array.emission_value = 0;
        murk_ground_options ground = MURK_GROUND_DEFAULT;
        ground.height = 0.1;
        ground.reflectance = 0.6;
        struct world w;
        world_open(&w, 1, &array, &ground);
        w.scene.sun = (murk_sun){{suns[n][0], suns[n][1], suns[n][2]}, F};
        world_solve(&w, NULL);
        double back[3] = {-suns[n][0], -suns[n][1], -suns[n][2]};
        scale_to(back, 1);
        const murk_camera camera = {{4.1, -5.3, 2.9}, {0.3, 0.2, 0.6}, {0, 0, 1}, 60, {41, 33}, 0};
        murk_image *image = take(&w, &camera, &ONE_SAMPLE);
        int shaded = 0;
        for (int j = 0; j < 33; j++)
            for (int i = 0; i < 41; i++) {
                double along[3], at[3];
                look_through(&camera, i, j, along);
                if (!(along[2] < 0))
                    continue;
                double t = (0.1 - camera.eye[2]) / along[2];
                for (int c = 0; c < 3; c++)
                    at[c] = camera.eye[c] + t * along[c];
                double sun = exp(-depth_along(at, back, INFINITY));
                double tau = exp(-depth_along(camera.eye, along, t));
                shaded += sun < 0.9 && tau > 0.5;
                assert_within(pixel(image, "surface.R", i, j), tau * 0.6 * F * back[2] * sun / M_PI,
                              1e-6);
            }
        assert_true(shaded > 10);
        murk_image_release(image);
        world_close(&w);
    }
}

/* The same medium, alone and in a box twice as long on each axis that is empty but for the far
   corner, out of sight: no pixel changes by more than the rounding of other coordinates. */
static void empty_space(void **state)
{
    (void)state;
    static float larger[8 * NX * NY * NZ];
    const murk_array array = clumps(0.8);
    murk_array around = array;
    around.kappa_t = larger;
    for (int a = 0; a < 3; a++)
        around.size[a] = 2 * array.size[a];
    for (int n = 0; n < NX * NY * NZ; n++)
        larger[check_at(&around, n / NZ / NY, n / NZ % NY, n % NZ)] = kappa_t[n];
    larger[8 * NX * NY * NZ - 1] = 1;
    struct world alone, within;
    world_open(&alone, 1, &array, NULL);
    world_open(&within, 1, &around, NULL);
    world_solve(&alone, NULL);
    world_solve(&within, NULL);
    murk_image *one = take(&alone, &CAMERAS[0], NULL), *two = take(&within, &CAMERAS[0], NULL);
    for (int j = 0; j < CAMERAS[0].size[1]; j++)
        for (int i = 0; i < CAMERAS[0].size[0]; i++) {
            assert_within(pixel(two, "path.R", i, j), pixel(one, "path.R", i, j), 1e-6);
            assert_within(pixel(two, "transmittance.Y", i, j), pixel(one, "transmittance.Y", i, j),
                          1e-6);
        }
    murk_image_release(one);
    murk_image_release(two);
    world_close(&alone);
    world_close(&within);
}

/* Behind a transmittance of 1e-7 no light is looked up: 1e-7 of E and of the sky is what that can
   change. Depths go on, to transmittances that a float can hold and to the middle of the depth. */
static void opaque(void **state)
{
    (void)state;
    const murk_array array = {
        .size = {40, 1, 1}, .voxel_size = {0.1, 1, 1}, .kappa_t_value = 15, .emission_value = E};
    struct world w;
    world_open(&w, 1, &array, NULL);
    w.scene.sky_radiance = 0.3;
    world_solve(&w, NULL);
    const murk_camera camera = {{-1, 0.5, 0.5}, {1, 0.5, 0.5}, {0, 0, 1}, 1, {1, 1}, 0};
    murk_image *image = take(&w, &camera, &ONE_SAMPLE);
    assert_within(pixel(image, "path.R", 0, 0), E / M_PI, 1e-7 * E + 1e-6);
    assert_within(pixel(image, "surface.R", 0, 0), 0, 1e-7);
    assert_within(pixel(image, "transmittance.Y", 0, 0) / exp(-60), 1, 1e-4);
    assert_within(pixel(image, "Z", 0, 0), 1 + 2, 3e-6);
    murk_image_release(image);
    world_close(&w);
}

/* n x n samples a pixel are the same rays as one a pixel of a picture n times as large. */
static void samples(void **state)
{
    (void)state;
    const murk_array array = clumps(0.8);
    struct world w;
    world_open(&w, 1, &array, NULL);
    w.scene.sky_radiance = 0.3;
    world_solve(&w, NULL);
    for (int n = 1; n <= 9; n++) {
        murk_camera camera = CAMERAS[0];
        camera.size[0] = 13;
        camera.size[1] = 11;
        murk_image *small = take(&w, &camera, &(murk_render_options){.samples = n});
        camera.size[0] *= n;
        camera.size[1] *= n;
        murk_image *large = take(&w, &camera, &ONE_SAMPLE);
        for (int j = 0; j < 11; j++)
            for (int i = 0; i < 13; i++) {
                double colour = 0, depth = 0;
                int deep = 0;
                for (int s = 0; s < n * n; s++) {
                    double z = pixel(large, "Z", i * n + s % n, j * n + s / n);
                    colour += pixel(large, "R", i * n + s % n, j * n + s / n);
                    deep += isfinite(z);
                    depth += isfinite(z) ? z : 0;
                }
                assert_within(pixel(small, "R", i, j), colour / (n * n), 1e-6);
                if (deep)
                    assert_within(pixel(small, "Z", i, j), depth / deep, 1e-5);
                else
                    assert_true(isinf(pixel(small, "Z", i, j)));
            }
        murk_image_release(small);
        murk_image_release(large);
    }
    world_close(&w);
}

/* Every instruction set that this processor has draws the same picture to rounding. */
static void kernels(void **state)
{
    (void)state;
    const double most[] = {0.8, 40};
    for (int n = 0; n < 2; n++) {
        const murk_array array = clumps(most[n]);
        struct world w;
        world_open(&w, 1, &array, NULL);
        world_solve(&w, NULL);
        murk_context *portable = check_context(1, "portable");
        murk_image *one = take(&w, &CAMERAS[0], NULL), *two = NULL;
        assert_int_equal(murk_render(portable, &w.scene, w.solution, &CAMERAS[0], NULL, &two),
                         MURK_OK);
        for (int j = 0; j < CAMERAS[0].size[1]; j++)
            for (int i = 0; i < CAMERAS[0].size[0]; i++) {
                assert_within(pixel(two, "R", i, j), pixel(one, "R", i, j), 1e-6);
                assert_within(pixel(two, "A", i, j), pixel(one, "A", i, j), 1e-6);
            }
        murk_image_release(one);
        murk_image_release(two);
        murk_context_release(portable);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sparse), cmocka_unit_test(shadow),  cmocka_unit_test(empty_space),
        cmocka_unit_test(opaque), cmocka_unit_test(samples), cmocka_unit_test(kernels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
