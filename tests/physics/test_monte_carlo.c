/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solutions against an independent Monte Carlo of the same model (monte_carlo.h): the means of B
 * over the medium, its layers and octants, the ground's mean radiosity, the energies, and the L2
 * error over all zones.
 *
 * They have to agree within 4 standard errors from 64 batches (Student's t with 63 degrees of
 * freedom exceeds 4 once in 6000 draws; the seeds are fixed) and what the error e of B, relative in
 * the norm (sum kappa V B^2)^(1/2), allows. With D = e (sum kappa V B^2)^(1/2), Cauchy and Schwarz
 * bound
 *  - the kappa-weighted mean over a group g: D / (sum_g kappa V)^(1/2);
 *  - the energy absorbed, sum 4 kappa V (1 - albedo) G/4, where an error of B is one of B/albedo in
 *    G/4: 4 D (sum kappa V ((1 - albedo)/albedo)^2)^(1/2);
 *  - what escapes, by the balance emitted + sun + diffuse = absorbed + escaped with exact emission:
 *    the same and e (sun + diffuse);
 *  - the light H on the ground, which B and the factors V_kS_i enter with an error of e each:
 *    2 e mean(rho H).
 */
#include "varied.h"

/* ---- What is compared: groups of zones, then the four below ---- */

enum { GROUND, ABSORBED, ESCAPED, SUN, ENERGIES };

/* All zones, the layers along z, the octants. */
static int group_count(const struct bench_mc_scene *s)
{
    return 1 + s->size[2] + 8;
}

static bool is_in(const struct bench_mc_scene *s, int zone, int group)
{
    int k = zone % s->size[2], j = zone / s->size[2] % s->size[1],
        i = zone / s->size[2] / s->size[1];
    if (group <= s->size[2])
        return !group || k == group - 1;
    int octant = group - s->size[2] - 1;
    return (2 * i >= s->size[0]) == octant >> 2 && (2 * j >= s->size[1]) == (octant >> 1 & 1) &&
           (2 * k >= s->size[2]) == (octant & 1);
}

static double group_weight(const struct bench_mc_scene *s, int group)
{
    double weight = 0;
    for (int n = 0; n < zone_count(s); n++)
        weight += is_in(s, n, group) ? optical_volume(s, n) : 0;
    assert_true(weight > 0);
    return weight;
}

static void group_means(const struct bench_mc_scene *s, const double *b, double *out)
{
    for (int g = 0; g < group_count(s); g++) {
        double sum = 0;
        for (int n = 0; n < zone_count(s); n++)
            sum += is_in(s, n, g) ? optical_volume(s, n) * b[n] : 0;
        out[g] = sum / group_weight(s, g);
    }
}

/* The means of the groups, and the four. */
static void derive(const struct bench_mc_scene *s, const struct bench_mc_tally *tally,
                   const double *b, double *value)
{
    group_means(s, b, value);
    value += group_count(s);
    value[GROUND] = value[ABSORBED] = 0;
    for (int n = 0; n < zone_count(s); n++)
        value[ABSORBED] += (1 - s->albedo[n]) * tally->zone[n];
    for (int n = 0; n < patch_count(s); n++)
        value[GROUND] += b[zone_count(s) + n] / patch_count(s);
    value[ESCAPED] = tally->escaped;
    value[SUN] = tally->sun;
}

static void run_monte_carlo(const struct bench_mc_scene *s, long packets, struct batches *out)
{
    assert_true(group_count(s) + ENERGIES <= MOST_VALUES);
    batches_run(s, false, packets, derive, out);
}

/* ---- What they have to agree in ---- */

/* Within 4 standard errors and an allowance. */
static void check_value(const struct batches *mc, int which, double value, double allowance)
{
    double mean = 0, spread = 0;
    for (int n = 0; n < BATCHES; n++)
        mean += mc->value[n][which] / BATCHES;
    for (int n = 0; n < BATCHES; n++)
        spread += pow(mc->value[n][which] - mean, 2);
    double error = sqrt(spread / BATCHES / (BATCHES - 1));
    if (!(fabs(value - mean) <= 4 * error + allowance))
        fail_msg("value %d is %.6g; Monte Carlo says %.6g +- %.2g, allowance %.2g (off by %.3f %%)",
                 which, value, mean, error, allowance, 100 * (value / mean - 1));
}

static void check_l2(const struct batches *mc, int first, int count, const double *weight,
                     const double *b, double allowance)
{
    struct distance d = batches_distance(mc, first, count, weight, b);
    double error = distance_error(&d, allowance);
    print_message("%s: L2 error %.3f %% (+- %.3f %%), allowed %.3f %%\n",
                  first ? "ground" : "zones", 100 * sqrt(fmax(0, d.squared)), 100 * sqrt(error),
                  100 * allowance);
    if (!(d.squared <= allowance * allowance + 4 * error))
        fail_msg("L2 error %.3f %%, above %.3f %%", 100 * sqrt(d.squared),
                 100 * sqrt(allowance * allowance + 4 * error));
}

/* e is the error of B, e_energy that of the quadrature behind the energies. */
static void check_solution(const struct bench_mc_scene *s, const struct batches *mc,
                           const struct world *w, double e, double e_energy, double l2)
{
    double b[MOST], weights[MOST], mean[MOST_VALUES], norm2 = 0, share2 = 0, ground = 0, glow = 0;
    const murk_report *report = murk_solution_report(w->solution);
    setting_solution(s, w, b);
    for (int n = 0; n < zone_count(s); n++) {
        double weight = weights[n] = optical_volume(s, n), a = s->albedo[n];
        norm2 += weight * b[n] * b[n];
        share2 += weight > 0 ? weight * pow((1 - a) / a, 2) : 0;
    }
    for (int n = 0; n < patch_count(s); n++) {
        weights[zone_count(s) + n] = 1;
        ground += b[zone_count(s) + n] / patch_count(s);
        glow += s->ground_emission[n] / patch_count(s);
    }
    print_message("%s: estimate %.3f %%\n", report->method, 100 * report->estimate);
    check_l2(mc, 0, zone_count(s), weights, b, l2);
    if (patch_count(s))
        check_l2(mc, zone_count(s), patch_count(s), weights, b, l2);
    group_means(s, b, mean);
    int groups = group_count(s);
    for (int g = 0; g < groups; g++)
        check_value(mc, g, mean[g], e * sqrt(norm2 / group_weight(s, g)));
    check_value(mc, groups + GROUND, ground, 2 * e * (ground - glow));
    double absorbed = 4 * e_energy * sqrt(norm2 * share2);
    double brought = report->energy_sun + report->energy_diffuse;
    check_value(mc, groups + ABSORBED, report->energy_absorbed, absorbed);
    check_value(mc, groups + ESCAPED, report->energy_escaped, absorbed + e_energy * brought);
    check_value(mc, groups + SUN, report->energy_sun, e * report->energy_sun);
}

/* Lines within their own estimate, and no further off than the tolerance where that is larger.
   Factors of pairwise are within 0.1 % (test_paper.c); its energies come from 384 directions, with
   twice the error of 1536: it falls like directions^-1/2. */
static void check_scene(const struct bench_mc_scene *s, long packets)
{
    static struct batches mc;
    struct world w;
    run_monte_carlo(s, packets, &mc);
    setting_open(s, 1, &w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    options.directions = 1536;
    options.rays = 2;
    world_solve(&w, &options);
    double e = murk_solution_report(w.solution)->estimate;
    check_solution(s, &mc, &w, e, e, fmax(e, options.tolerance));
    options = (murk_solve_options)MURK_SOLVE_DEFAULT;
    options.method = MURK_PAIRWISE;
    options.tolerance = 1e-4;
    world_solve(&w, &options);
    check_solution(s, &mc, &w, 0.001, 2 * e, 0.003);
    world_close(&w);
}

static void scenes(void **state)
{
    (void)state;
    static struct setting s;
    for (int n = 0; n < VARIED_SCENES; n++) {
        print_message("%s\n", VARIED[n].name);
        VARIED[n].make(&s);
        check_scene(&s.mc, VARIED[n].packets);
    }
}

/* ---- The Monte Carlo by itself ---- */

/* Everything radiates at one temperature: B = E (test_isothermal.c). */
static void reference_enclosure(void **state)
{
    (void)state;
    static struct setting s;
    static struct batches result;
    struct bench_mc_scene *mc = setting_start(&s, 6, 7, 5);
    setting_fill_at_random(&s, 0.2, 0.99);
    for (int n = 0; n < zone_count(mc); n++)
        s.emission[n] = 3;
    mc->sky_radiance = 3 / M_PI;
    run_monte_carlo(mc, 500000, &result);
    for (int g = 0; g < group_count(mc); g++)
        check_value(&result, g, 3, 0);
}

/* Overhead sun on black voxels: a layer of depth d takes e^{-d n} - e^{-d (n + 1)} of it, and the
   ground the rest, without any noise. The same seed gives the same tally. */
static void reference_beam(void **state)
{
    (void)state;
    static struct setting s;
    struct bench_mc_scene *mc = setting_start(&s, 4, 4, 6);
    setting_fill(&s, 5, 0);
    setting_lay_ground(mc, 0, 0.2);
    setting_sun(mc, 0, 0, -1);
    double zone[2][MOST] = {{0}}, patch[2][MOST_PATCHES] = {{0}}, layer[6] = {0}, ground = 0;
    for (int run = 0; run < 2; run++)
        assert_true(bench_mc_run(mc, false, 7, 1000,
                                 &(struct bench_mc_tally){.zone = zone[run], .patch = patch[run]}));
    assert_memory_equal(zone[0], zone[1], sizeof zone[0]);
    for (int n = 0; n < zone_count(mc); n++)
        layer[5 - n % 6] += zone[0][n];
    for (int n = 0; n < patch_count(mc); n++)
        ground += patch[0][n];
    for (int n = 0; n < 6; n++)
        assert_within(layer[n], 0.16 * (exp(-0.5 * n) - exp(-0.5 * (n + 1))), 1e-12);
    assert_within(ground, 0.16 * exp(-3), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reference_enclosure),
        cmocka_unit_test(reference_beam),
        cmocka_unit_test(scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
