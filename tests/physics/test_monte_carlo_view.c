/* SPDX-License-Identifier: Apache-2.0 */
/* The Monte Carlo that looks back from pixels, against closed forms and van de Hulst's tables. */
#include "check.h"

#include "monte_carlo_packet.h"
#include "monte_carlo_view.h"

/* So narrow that all rays of a picture are one. */
static const double NARROW = 1e-4;

static struct bench_mc_radiance look(const struct bench_mc_scene *scene, const double eye[3],
                                     const double target[3], const double up[3], long paths,
                                     bool horizon)
{
    struct bench_mc_radiance out;
    struct bench_mc_view view = {.scene = scene, .width = 3, .height = 2, .horizon = horizon};
    view.camera = (murk_camera){.fov = NARROW, .size = {3, 2}};
    for (int c = 0; c < 3; c++) {
        view.camera.eye[c] = eye[c];
        view.camera.target[c] = target[c];
        view.camera.up[c] = up[c];
    }
    assert_true(bench_mc_view_radiance(&view, paths, 32, 0, &out));
    return out;
}

static const double DOWN[3] = {0, 0, -1}, NORTH[3] = {0, 1, 0}, UP[3] = {0, 0, 1};

/* Turns have the cosines of the phase function: its mean is g, its integral 1. */
static void phase(void **state)
{
    (void)state;
    static const double asymmetries[] = {-0.6, 0, 0.3, 0.85};
    struct bench_mc_scene scene = {.size = {1, 1, 1}};
    struct bench_mc_walk walk;
    bench_mc_walk_begin(&walk, &scene, 1);
    for (int n = 0; n < 4; n++) {
        enum { BINS = 10, TURNS = 1000000, STEPS = 1000 };
        double g = asymmetries[n], mean = 0, all = 0;
        long count[BINS] = {0};
        for (int t = 0; t < TURNS; t++) {
            double from[3], along[3];
            bench_mc_turn_isotropic(bench_mc_draw(&walk), bench_mc_draw(&walk), from);
            memcpy(along, from, sizeof along);
            bench_mc_turn_scattered(g, bench_mc_draw(&walk), bench_mc_draw(&walk), along);
            double z = along[0] * from[0] + along[1] * from[1] + along[2] * from[2];
            mean += z / TURNS;
            count[(int)fmin((z + 1) / 2 * BINS, BINS - 1)]++;
        }
        assert_within(mean, g, 3e-3);
        for (int bin = 0; bin < BINS; bin++) {
            double wanted = 0;
            for (int i = 0; i < STEPS; i++) {
                double z = -1 + 2 * (bin + (i + 0.5) / STEPS) / BINS;
                wanted += bench_mc_phase(g, z) * 4 * M_PI / BINS / STEPS;
            }
            all += wanted;
            assert_within((double)count[bin] / TURNS, wanted, 5 * sqrt(wanted / TURNS));
        }
        assert_within(all, 1, 1e-5);
    }
}

/* A glowing slab that does not scatter over a patch: both parts, without any noise. */
static void absorbing(void **state)
{
    (void)state;
    const float kappa_t[] = {1, 5, 2, 4}, albedo[4] = {0}, emission[4] = {3, 3, 3, 3};
    const float reflectance = 0.4f, glow = 0.7f;
    const struct bench_mc_scene scene = {.size = {1, 1, 4},
                                         .voxel = {10, 10, 0.05},
                                         .kappa_t = kappa_t,
                                         .albedo = albedo,
                                         .emission = emission,
                                         .asymmetry = 0.5,
                                         .patches = {1, 1},
                                         .height = -0.5,
                                         .ground_high = {10, 10},
                                         .ground_reflectance = &reflectance,
                                         .ground_emission = &glow,
                                         .sun = {0, 0.6, -0.8},
                                         .irradiance = 2};
    const double eye[3] = {4, 5, 3}, target[3] = {5.5, 5, 0}; /* cosine 2 / sqrt 5 */
    double depth = 12 * 0.05, tau = exp(-depth * sqrt(1.25)), sun = 2 * 0.8 * exp(-depth / 0.8);
    double surface = tau * (0.7 + 0.4 * sun) / M_PI;
    struct bench_mc_radiance got = look(&scene, eye, target, NORTH, 320, false);
    assert_true(got.surface.value > surface); /* the slab's own light is reflected, too */
    assert_within(got.path.value, (1 - tau) * 3 / M_PI, 1e-6);
    assert_within(got.path.error, 0, 1e-6);
    const float dark[4] = {0};
    struct bench_mc_scene cold = scene;
    cold.emission = dark;
    got = look(&cold, eye, target, NORTH, 320, false);
    assert_within(got.surface.value, surface, 1e-6);
    assert_within(got.total.value, surface, 1e-6);
    assert_within(got.path.value, 0, 0);
    /* Beyond the patch, undisturbed: black, or its means. */
    const double outside[3] = {-400, 5, 0};
    cold.irradiance = 0;
    double away[3] = {-399, 5, 3};
    assert_within(look(&cold, away, outside, NORTH, 32, false).total.value, 0, 0);
    assert_within(look(&cold, away, outside, NORTH, 32, true).total.value, 0.7 / M_PI, 1e-6);
}

/* Everything radiates at one temperature: the same radiance wherever one looks. */
static void enclosure(void **state)
{
    (void)state;
    static float kappa_t[210], albedo[210], emission[210], reflectance[6], glow[6];
    uint64_t random = 5;
    for (int n = 0; n < 210; n++) {
        kappa_t[n] = (float)(30 * check_random(&random));
        albedo[n] = (float)check_random(&random);
        emission[n] = 3;
    }
    for (int n = 0; n < 6; n++) {
        reflectance[n] = (float)check_random(&random);
        glow[n] = 3 * (1 - reflectance[n]);
    }
    struct bench_mc_scene scene = {.size = {5, 6, 7},
                                   .voxel = {0.1, 0.2, 0.1},
                                   .kappa_t = kappa_t,
                                   .albedo = albedo,
                                   .emission = emission,
                                   .height = -0.1,
                                   .ground_low = {-1e4, -1e4},
                                   .ground_high = {1e4, 1e4},
                                   .ground_reflectance = reflectance,
                                   .ground_emission = glow,
                                   .sky_radiance = 3 / M_PI};
    const double eye[3] = {1, -1, 1.5}, inside[3] = {0.23, 0.51, 0.34}, target[3] = {0.2, 0.5, 0.1};
    for (int n = 0; n < 4; n++) {
        scene.asymmetry = n % 2 ? 0.8 : -0.3;
        scene.patches[0] = n < 2 ? 0 : 3;
        scene.patches[1] = n < 2 ? 0 : 2;
        for (int from = 0; from < 2; from++) {
            struct bench_mc_radiance got =
                look(&scene, from ? inside : eye, target, UP, 20000, false);
            assert_within(got.total.value, 3 / M_PI, 4 * got.total.error);
            assert_at_most(got.total.error, 0.005);
        }
    }
}

/* So thin that light is scattered once: kappa_s L p F. */
static void once(void **state)
{
    (void)state;
    const float kappa_t = 1e-4f, albedo = 0.8f, emission = 0;
    static const double asymmetries[] = {-0.5, 0, 0.6, 0.85};
    const double eye[3] = {0.5, 0.5, 9}, target[3] = {0.5, 0.5, 0};
    for (int n = 0; n < 4; n++)
        for (int turn = 0; turn < 5; turn++) {
            double angle = (turn + 0.2) * M_PI / 5;
            const struct bench_mc_scene scene = {.size = {1, 1, 1},
                                                 .voxel = {1, 1, 1},
                                                 .kappa_t = &kappa_t,
                                                 .albedo = &albedo,
                                                 .emission = &emission,
                                                 .asymmetry = asymmetries[n],
                                                 .sun = {sin(angle), 0, cos(angle)},
                                                 .irradiance = 1.5};
            double g = scene.asymmetry, c = cos(angle); /* light goes up to the camera */
            double p = (1 - g * g) / (4 * M_PI) / pow(1 + g * g - 2 * g * c, 1.5);
            double wanted = 1e-4 * 0.8 * p * 1.5;
            struct bench_mc_radiance got = look(&scene, eye, target, NORTH, 3200, false);
            assert_within(got.path.value, wanted, 1e-3 * wanted);
            assert_within(got.surface.value, 0, 0);
        }
}

/*
 * A slab of 2 optical depths, albedo 0.9 and g = 0.75 reflects 0.09739 of a beam that falls on it
 * vertically and lets 0.66096 through (van de Hulst 1980, table 35; Wang, Jacques, Zheng 1995). By
 * reciprocity that is what a camera above it sees of a bright sky, and of a bright ground.
 */
static void slab(void **state)
{
    (void)state;
    const float kappa_t = 100, albedo = 0.9f, emission = 0, black = 0, bright = (float)M_PI;
    struct bench_mc_scene scene = {.size = {1, 1, 1},
                                   .voxel = {200, 200, 0.02},
                                   .kappa_t = &kappa_t,
                                   .albedo = &albedo,
                                   .emission = &emission,
                                   .asymmetry = 0.75,
                                   .patches = {1, 1},
                                   .height = -1e-6,
                                   .ground_high = {200, 200},
                                   .ground_reflectance = &black,
                                   .ground_emission = &black,
                                   .sky_radiance = 1};
    const double eye[3] = {100, 100, 1}, target[3] = {100, 100, 0};
    struct bench_mc_radiance got = look(&scene, eye, target, NORTH, 400000, false);
    print_message("reflects %.5f +- %.5f\n", got.total.value, got.total.error);
    assert_at_most(got.total.error, 0.0005);
    assert_within(got.total.value, 0.09739, 3 * got.total.error);
    scene.sky_radiance = 0;
    scene.ground_emission = &bright;
    got = look(&scene, eye, target, NORTH, 400000, false);
    print_message("lets through %.5f +- %.5f\n", got.total.value, got.total.error);
    assert_at_most(got.total.error, 0.0007);
    assert_within(got.total.value, 0.66096, 3 * got.total.error);
    assert_within(got.surface.value, exp(-2), 1e-6);

    /* The packets that run forward scatter by the same law. */
    double zone = 0, patch = 0;
    struct bench_mc_tally tally = {.zone = &zone, .patch = &patch};
    scene.ground_emission = &black;
    scene.irradiance = 1;
    for (int c = 0; c < 3; c++)
        scene.sun[c] = DOWN[c];
    assert_true(bench_mc_run(&scene, true, 1, 400000, &tally));
    assert_within(patch / (200 * 200), 0.66096, 3 * 0.00075); /* binomial */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(phase), cmocka_unit_test(absorbing), cmocka_unit_test(enclosure),
        cmocka_unit_test(once),  cmocka_unit_test(slab),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
