/* SPDX-License-Identifier: Apache-2.0 */
/* The Monte Carlo that scatters light where it was extinguished, against a reference solution
   (data/README.md) and itself: what it finds depends on the medium and not on its zones. */
#include "references.h"

#include "monte_carlo.h"

enum { BATCHES = 64, MOST = 1000, MOST_PATCHES = 64 };

struct answer {
    double zone[MOST], zone_error[MOST], patch[MOST_PATCHES], patch_error[MOST_PATCHES];
};

static void solve(const struct bench_mc_scene *s, bool exact, long packets, int threads,
                  struct answer *out)
{
    struct bench_mc_result result = {out->zone, out->zone_error, out->patch, out->patch_error};
    assert_true(bench_mc_zones(s) <= MOST && bench_mc_patches(s) <= MOST_PATCHES);
    assert_true(bench_mc_solve(s, exact, packets, BATCHES, threads, &result));
}

/* Emission and albedo as unit_cube.json has them. */
static void set_cube(struct bench_mc_scene *s, int edge, double kappa_t, double omega)
{
    static float values[3][MOST];
    for (int n = 0; n < edge * edge * edge; n++) {
        values[0][n] = (float)kappa_t;
        values[1][n] = (float)omega;
        values[2][n] = 1;
    }
    *s = (struct bench_mc_scene){.size = {edge, edge, edge},
                                 .voxel = {1.0 / edge, 1.0 / edge, 1.0 / edge},
                                 .kappa_t = values[0],
                                 .albedo = values[1],
                                 .emission = values[2]};
}

/* Relative L2 difference of one zone another. */
static double differ(const double *b, const double *wanted, int count)
{
    double difference = 0, size = 0;
    for (int n = 0; n < count; n++) {
        difference += pow(b[n] - wanted[n], 2);
        size += wanted[n] * wanted[n];
    }
    return sqrt(difference / size);
}

/* The mean square of differences in standard errors of both: 1 for the same expectation. */
static double compare(const double *b, const double *b_error, const double *c,
                      const double *c_error, int count)
{
    double sum = 0;
    for (int n = 0; n < count; n++)
        sum += pow(b[n] - c[n], 2) / (pow(b_error[n], 2) + (c_error ? pow(c_error[n], 2) : 0));
    return sum / count;
}

/* 10 optical depths across with albedo 0.9, in zones of 2: the exact Monte Carlo finds the
   reference, the zonal one is far off. */
static void cube(void **state)
{
    (void)state;
    enum { EDGE = 5, ZONES = EDGE * EDGE * EDGE };
    static struct answer answer;
    static double wanted[ZONES];
    struct bench_mc_scene scene;
    static const double albedos[] = {0.5, 0.9, 0.99};
    for (int n = 0; n < 3; n++) {
        double omega = albedos[n];
        reference_cube_means(&(struct reference_cube){0, 10, omega}, EDGE, wanted);
        set_cube(&scene, EDGE, 10, omega);
        for (int exact = 0; exact < 2; exact++) {
            solve(&scene, exact, 1000000, 0, &answer);
            double off = differ(answer.zone, wanted, ZONES), noise = 0, size = 0;
            for (int z = 0; z < ZONES; z++) {
                noise += pow(answer.zone_error[z], 2);
                size += wanted[z] * wanted[z];
            }
            noise = sqrt(noise / size);
            print_message("albedo %g, %s: off by %.3f %%, noise %.3f %%\n", omega,
                          exact ? "exact" : "zonal", 100 * off, 100 * noise);
            assert_at_most(noise, 0.005);
            if (exact)
                assert_at_most(off, 1.3 * noise);
            else
                assert_true(off > 3 * noise);
        }
    }
}

/* Everything radiates at one temperature: B = E, however thick the zones. */
static void enclosure(void **state)
{
    (void)state;
    static struct answer answer;
    static float kappa_t[210], albedo[210], emission[210];
    uint64_t random = 5;
    for (int n = 0; n < 210; n++) {
        kappa_t[n] = (float)(30 * check_random(&random));
        albedo[n] = (float)check_random(&random);
        emission[n] = 3;
    }
    const struct bench_mc_scene scene = {.size = {5, 6, 7},
                                         .voxel = {0.1, 0.2, 0.1},
                                         .kappa_t = kappa_t,
                                         .albedo = albedo,
                                         .emission = emission,
                                         .sky_radiance = 3 / M_PI};
    solve(&scene, true, 200000, 0, &answer);
    for (int n = 0; n < 210; n++)
        assert_within(answer.zone[n], 3, 5 * answer.zone_error[n]);
}

static const float HALF[MOST_PATCHES] = {0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f,
                                         0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};

/* A uniform ground in one patch or in 16 of the same reflectance, in slanting sun. */
static void ground(void **state)
{
    (void)state;
    static struct answer answer[2][2];
    static const float dark[MOST_PATCHES];
    struct bench_mc_scene scene;
    set_cube(&scene, 4, 3, 0.8);
    float emission[64] = {0};
    scene.emission = emission;
    scene.height = -0.2;
    scene.ground_low[0] = -1;
    scene.ground_high[0] = scene.ground_high[1] = 1;
    scene.ground_reflectance = HALF;
    scene.ground_emission = dark;
    scene.sun[0] = 0.6;
    scene.sun[2] = -0.8;
    scene.irradiance = 1;
    for (int exact = 0; exact < 2; exact++)
        for (int fine = 0; fine < 2; fine++) {
            scene.patches[0] = scene.patches[1] = fine ? 4 : 1;
            solve(&scene, exact, 400000, 0, &answer[exact][fine]);
        }
    double same[2];
    for (int exact = 0; exact < 2; exact++)
        same[exact] = compare(answer[exact][0].zone, answer[exact][0].zone_error,
                              answer[exact][1].zone, answer[exact][1].zone_error, 64);
    print_message("ground in parts: zonal %.1f, exact %.2f\n", same[0], same[1]);
    assert_at_most(same[1], 1.5);
    assert_true(same[0] > 10);
    double mean = 0;
    for (int n = 0; n < 16; n++)
        mean += answer[1][1].patch[n] / 16;
    assert_within(answer[1][0].patch[0], mean, 5 * answer[1][0].patch_error[0]);
}

/* Means and standard errors of the batches, whatever the threads. */
static void batches(void **state)
{
    (void)state;
    static struct answer one, two;
    static double b[BATCHES][8];
    struct bench_mc_scene scene;
    set_cube(&scene, 2, 5, 0.9);
    solve(&scene, true, 6400, 1, &one);
    solve(&scene, true, 6400, 2, &two);
    assert_memory_equal(&one, &two, sizeof one);
    double mean = 0, spread = 0;
    for (int n = 0; n < BATCHES; n++) {
        double zone[8] = {0};
        struct bench_mc_tally tally = {.zone = zone};
        assert_true(bench_mc_run(&scene, true, (uint64_t)n + 1, 100, &tally));
        bench_mc_radiosity(&scene, &tally, b[n], NULL);
        mean += b[n][3] / BATCHES;
    }
    for (int n = 0; n < BATCHES; n++)
        spread += pow(b[n][3] - mean, 2);
    assert_within(one.zone[3], mean, 1e-12);
    assert_within(one.zone_error[3], sqrt(spread / BATCHES / (BATCHES - 1)), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube),
        cmocka_unit_test(enclosure),
        cmocka_unit_test(ground),
        cmocka_unit_test(batches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
