/* SPDX-License-Identifier: Apache-2.0 */
/* What holds exactly where light is scattered forward, and what errors are told of. */
#include "camera.h"

static const double E = 2, KAPPA = 6;
static const double LOW[3] = {0.2, -0.1, 0.3}, HIGH[3] = {0.8, 0.4, 0.7};
static const murk_camera CAMERA = {
    {1.6, -1.3, 1.4}, {0.5, 0.1, 0.4}, {0.1, 0.2, 1}, 45, {31, 22}, 0};
static const double ASYMMETRIES[] = {-0.5, 0.3, 0.85, 0.97};

enum { ASYMMETRY_COUNT = sizeof ASYMMETRIES / sizeof *ASYMMETRIES };

static const murk_render_options ONE_SAMPLE = {.samples = 1};

static murk_array box(double albedo, double emission, double asymmetry)
{
    return (murk_array){.size = {6, 5, 4},
                        .voxel_size = {0.1, 0.1, 0.1},
                        .origin = {LOW[0], LOW[1], LOW[2]},
                        .kappa_t_value = KAPPA,
                        .albedo_value = albedo,
                        .emission_value = emission,
                        .asymmetry = asymmetry};
}

/* In an enclosure of one temperature B = E in all zones and everything looks alike; surfaces are
   seen through exp(-kappa s), whatever is scattered forward. */
static void enclosure(void **state)
{
    (void)state;
    static const double albedos[] = {1, 0.9, 0.3, 0};
    const float rho[6] = {0.1f, 0.9f, 0.4f, 0.6f, 0, 1};
    float glow[6];
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = 3;
    ground.patches[1] = 2;
    ground.reflectance_image = rho;
    ground.emission_image = glow;
    for (int i = 0; i < 6; i++)
        glow[i] = (float)(E * (1 - rho[i]));
    for (int n = 0; n < 4 * ASYMMETRY_COUNT; n++) {
        const murk_array array = box(albedos[n % 4], E, ASYMMETRIES[n / 4]);
        struct world w;
        world_open(&w, 1, &array, n % 2 ? &ground : NULL);
        w.scene.sky_radiance = E / M_PI;
        world_solve(&w, NULL);
        for (int z = 0; z < 120; z++)
            assert_within(world_b(&w, z / 20, z / 4 % 5, z % 4), E, 1e-5 * E);
        assert_at_most(murk_solution_report(w.solution)->energy_balance, 1e-5);
        murk_image *image = take(&w, &CAMERA, &ONE_SAMPLE);
        for (int p = 0; p < 31 * 22; p++) {
            double along[3];
            look_through(&CAMERA, p % 31, p / 31, along);
            double t = exp(-KAPPA * chord(LOW, HIGH, CAMERA.eye, along));
            assert_within(pixel(image, "R", p % 31, p / 31), E / M_PI, 2e-5 * E / M_PI);
            assert_within(pixel(image, "surface.R", p % 31, p / 31), t * E / M_PI, 2e-5);
            assert_within(pixel(image, "transmittance.Y", p % 31, p / 31), t, 1e-6);
            assert_true(pixel(image, "A", p % 31, p / 31) ==
                        1 - pixel(image, "transmittance.Y", p % 31, p / 31));
        }
        murk_image_release(image);
        world_close(&w);
    }
}

/* A scene with everything in it that forward scattering touches. */
static void open_scene(double asymmetry, struct world *w)
{
    static float albedo[120], rho[24];
    uint64_t random = 7;
    for (int n = 0; n < 120; n++)
        albedo[n] = (float)(0.5 + 0.5 * check_random(&random));
    for (int n = 0; n < 24; n++)
        rho[n] = (float)check_random(&random);
    murk_array array = box(0, 0.3, asymmetry);
    array.albedo = albedo;
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = 6;
    ground.patches[1] = 4;
    ground.reflectance_image = rho;
    world_open(w, 1, &array, &ground);
    w->scene.sun = (murk_sun){{0.3, 0.2, -0.8}, 1};
    w->scene.sky_radiance = 0.1;
}

static void compare(const murk_image *a, const murk_image *b, double tolerance)
{
    static const char *const channels[] = {"R", "path.R", "surface.R", "transmittance.Y"};
    for (int c = 0; c < 4; c++)
        for (int p = 0; p < 31 * 22; p++)
            assert_within(pixel(a, channels[c], p % 31, p / 31),
                          pixel(b, channels[c], p % 31, p / 31), tolerance);
}

/* An asymmetry that is almost none makes almost no difference. */
static void continuous(void **state)
{
    (void)state;
    murk_image *image[2];
    for (int n = 0; n < 2; n++) {
        struct world w;
        open_scene(n ? 1e-5 : 0, &w);
        world_solve(&w, NULL);
        image[n] = take(&w, &CAMERA, &ONE_SAMPLE);
        world_close(&w);
    }
    compare(image[0], image[1], 3e-5);
    murk_image_release(image[0]);
    murk_image_release(image[1]);
}

/* Solutions begin from one another, and come back from files with the same light on the ground. */
static void stored(void **state)
{
    (void)state;
    static const char path[] = MURK_ODD_DIR "/forward.vdb";
    struct world w;
    open_scene(0.85, &w);
    world_solve(&w, NULL);
    murk_image *first = take(&w, &CAMERA, &ONE_SAMPLE);
    assert_int_equal(murk_solution_write(w.solution, path, NULL), MURK_OK);

    murk_solution *before = w.solution, *again = NULL;
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.start = before;
    w.solution = NULL;
    world_solve(&w, &options);
    for (int z = 0; z < 120; z++) {
        const int32_t at[3] = {z / 20, z / 4 % 5, z % 4};
        double b = murk_solution_radiosity(before, at);
        assert_within(world_b(&w, at[0], at[1], at[2]), b, 0.02 * b);
    }

    murk_volume *volume = NULL;
    assert_int_equal(murk_volume_read(w.context, path, &volume), MURK_OK);
    assert_int_equal(murk_solution_from_volume(w.context, &w.scene, volume, &again), MURK_OK);
    murk_solution_release(w.solution);
    w.solution = again;
    murk_image *second = take(&w, &CAMERA, &ONE_SAMPLE);
    compare(first, second, 0.01 * pixel(first, "R", 15, 11));
    murk_image_release(first);
    murk_image_release(second);
    murk_volume_release(volume);
    murk_solution_release(before);
    remove(path);
    world_close(&w);
}

static void refused(void **state)
{
    (void)state;
    static const double bad[] = {1, -1, 1.5, NAN};
    murk_context *context = check_context(1, NULL);
    for (int n = 0; n < 4; n++) {
        murk_medium *medium = NULL;
        const murk_array array = box(0.5, 0, bad[n]);
        assert_int_equal(murk_medium_from_array(context, &array, &medium), MURK_ERROR_INPUT);
        assert_true(!medium && strstr(murk_context_message(context), "asymmetry"));
    }
    murk_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(enclosure),
        cmocka_unit_test(continuous),
        cmocka_unit_test(stored),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
