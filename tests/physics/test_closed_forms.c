/* SPDX-License-Identifier: Apache-2.0 */
/* Cases with a solution in closed form, and the balance of energy. */
#include "check.h"

enum { MOST = 4096 };

/* Albedo 0: B is the emission, whatever light there is. */
static void no_scattering(void **state)
{
    (void)state;
    static float kappa_t[MOST], emission[MOST];
    uint64_t random = 19;
    for (int i = 0; i < MOST; i++) {
        kappa_t[i] = check_random(&random) < 0.5 ? 0 : (float)(10 * check_random(&random));
        emission[i] = (float)check_random(&random);
    }
    const murk_array array = {.size = {16, 16, 16},
                              .voxel_size = {0.1, 0.1, 0.1},
                              .kappa_t = kappa_t,
                              .emission = emission};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    struct world w;
    world_open(&w, 2, &array, &ground);
    w.scene.sun = (murk_sun){{0.3, 0.2, -0.9}, 5};
    w.scene.sky_radiance = 2;
    world_solve(&w, NULL);
    for (int32_t n = 0; n < MOST; n++)
        if (kappa_t[n] > 0)
            assert_within(world_b(&w, n / 256, n / 16 % 16, n % 16), emission[n], 1e-6);
    world_close(&w);
}

/* Mean of exp(-kappa s) along a beam over a layer that it crosses between depths s0 and s1 of its
   path: [BG91] eq. (6) averaged over the zone. */
static double layer_mean(double kappa, double s0, double s1)
{
    return (exp(-kappa * s0) - exp(-kappa * s1)) / (kappa * (s1 - s0));
}

/* Almost no scattering: B / albedo is the single-scattering source F <tau> / 4, exactly for zones
   whose light comes through the top alone. Multiple scattering adds an albedo-th of that. */
static void beer_lambert(void **state)
{
    (void)state;
    static const double directions[][3] = {
        {0, 0, -1}, {0.3, 0.1, -1}, {0, 0.4, 1}, {-0.2, 0, -0.6}};
    const double kappa = 1.7, albedo = 1e-7, dz = 0.05, flux = 3;
    const murk_array array = {.size = {24, 24, 12},
                              .voxel_size = {0.1, 0.1, dz},
                              .kappa_t_value = kappa,
                              .albedo_value = albedo};
    for (size_t n = 0; n < sizeof directions / sizeof *directions; n++) {
        const double *d = directions[n];
        double mu = fabs(d[2]) / sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        struct world w;
        world_open(&w, 2, &array, NULL);
        w.scene.sun = (murk_sun){{d[0], d[1], d[2]}, flux};
        world_solve(&w, NULL);
        for (int32_t k = 0; k < 12; k++) {
            /* The beam drifts by less than 0.4 m within the box: columns 10 ... 13 are 1 m inside.
             */
            int layer = d[2] < 0 ? 11 - k : k;
            double mean = layer_mean(kappa, layer * dz / mu, (layer + 1) * dz / mu);
            for (int32_t i = 10; i < 14; i++)
                assert_within(world_b(&w, i, 23 - i, k) / albedo, flux * mean / 4, 2e-6 * flux);
        }
        world_close(&w);
    }
}

/* The report's energies of a box under an overhead sun: what the beam loses, what the zones emit
   and absorb follow from the scene and from B. */
static void energies(void **state)
{
    (void)state;
    const double kappa = 2, albedo = 0.7, emission = 0.4, flux = 5;
    const double volume = 0.1 * 0.1 * 0.2;
    const murk_array array = {.size = {10, 8, 6},
                              .voxel_size = {0.1, 0.1, 0.2},
                              .kappa_t_value = kappa,
                              .albedo_value = albedo,
                              .emission_value = emission};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.height = -0.1;
    struct world w;
    world_open(&w, 2, &array, &ground);
    w.scene.sun = (murk_sun){{0, 0, -1}, flux};
    w.scene.sky_radiance = 0.3;
    world_solve(&w, NULL);
    const murk_report *report = murk_solution_report(w.solution);
    assert_within(report->energy_sun, flux * 1.0 * 0.8 * -expm1(-kappa * 1.2), 1e-4);
    double emitted = 480 * 4 * kappa * (1 - albedo) * emission * volume;
    assert_within(report->energy_emitted, emitted, 1e-5 * emitted);
    double absorbed = 0; /* kappa_a G V with G = 4 (B - (1 - albedo) E) / albedo */
    for (int32_t n = 0; n < 480; n++)
        absorbed += kappa * (1 - albedo) * volume * 4 *
                    (world_b(&w, n / 48, n / 6 % 8, n % 6) - (1 - albedo) * emission) / albedo;
    assert_within(report->energy_absorbed, absorbed, 1e-4 * absorbed);
    double sources = report->energy_emitted + report->energy_sun + report->energy_diffuse;
    assert_true(report->energy_diffuse > 0 && report->energy_escaped > 0);
    assert_within(report->energy_absorbed + report->energy_escaped, sources, 1e-4 * sources);
    assert_at_most(report->energy_balance, 1e-4);
    world_close(&w);
}

/* emitted + incident = absorbed + escaped, on many kinds of media and at any tolerance. */
static void balance(void **state)
{
    (void)state;
    static float kappa_t[MOST], albedo[MOST], emission[MOST];
    static const double depths[] = {1e-3, 0.1, 1, 20};
    for (int n = 0; n < 16; n++) {
        uint64_t random = 20 + (uint64_t)n;
        for (int i = 0; i < MOST; i++) {
            double x = check_random(&random);
            kappa_t[i] = n & 1 && x < 0.6 ? 0 : (float)(depths[n / 4] / 0.1 * x);
            albedo[i] = (float)(1 - 0.3 * x * x);
            emission[i] = n & 2 ? (float)(x > 0.99) : 0;
        }
        const murk_array array = {.size = {12, 13, 11},
                                  .voxel_size = {0.1, 0.1, 0.1},
                                  .kappa_t = kappa_t,
                                  .albedo = albedo,
                                  .emission = emission};
        murk_ground_options ground = MURK_GROUND_DEFAULT;
        ground.extent_max[0] = ground.extent_max[1] = 1.2;
        ground.patches[0] = ground.patches[1] = 12;
        ground.height = -0.05 * (n % 3);
        struct world w;
        world_open(&w, 2, &array, n & 1 ? &ground : NULL);
        w.scene.sun = (murk_sun){{0.5, 0.1, -1}, n & 2 ? 0 : 4};
        w.scene.sky_radiance = n % 3 ? 0.2 : 0;
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.tolerance = n % 8 == 3 ? 0.003 : 0.03;
        options.directions = 192; /* balanced, whether the tolerance is reached or not */
        world_solve(&w, &options);
        const murk_report *r = murk_solution_report(w.solution);
        double sources = r->energy_emitted + r->energy_sun + r->energy_diffuse;
        assert_true(sources > 0);
        assert_at_most(r->energy_balance, 1e-4);
        assert_within(r->energy_absorbed + r->energy_escaped, sources, 1.001e-4 * sources);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_scattering),
        cmocka_unit_test(beer_lambert),
        cmocka_unit_test(energies),
        cmocka_unit_test(balance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
