/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Solutions against an independent Monte Carlo of the same model (monte_carlo.h): means of B over
 * the medium, its layers and octants, the ground's mean radiosity and the energies.
 *
 * They have to agree within 4 standard errors (Student's t with 63 degrees of freedom exceeds 4
 * once in 6000 draws; the seeds are fixed) and what the solution says about its own quadrature.
 * With e the reported estimate, that is the relative error of B in the norm (sum kappa V
 * B^2)^(1/2), D = e (sum kappa V B^2)^(1/2) bounds by Cauchy and Schwarz
 *  - the kappa-weighted mean over a group g: D / (sum_g kappa V)^(1/2);
 *  - the energy absorbed, sum 4 kappa V (1 - albedo) G/4 with an error of B/albedo in G/4:
 *    4 D (sum kappa V ((1 - albedo)/albedo)^2)^(1/2);
 *  - what escapes, through the balance emitted + sun + diffuse = absorbed + escaped, where emission
 *    is exact and the diffuse light has the relative error e of the lines: the same and e x
 * diffuse;
 *  - the light H on the ground, which B and the factors V_kS_i enter with an error of e each:
 *    2 e mean(rho H).
 */
#include "check.h"

#include "monte_carlo.h"

enum { MOST = 1000, MOST_PATCHES = 200, MOST_GROUPS = 32, BATCHES = 64 };

struct scene {
    const char *name;
    int size[3];
    double voxel[3];
    int patches[2];
    double gap; /* between ground and medium [m] */
    double ground_low[2], ground_high[2];
    double sun[3], irradiance, sky;
    float kappa_t[MOST], albedo[MOST], emission[MOST]; /* as in mc_scene */
    float rho[MOST_PATCHES], glow[MOST_PATCHES];       /* in rows of ascending y */
};

/* What is compared; a group of zones has a weight sum_g kappa V > 0. */
struct quantity {
    char name[24];
    double weight, allowance;
    double mc, error, murk;
};

static size_t count_of(const int *size, int n)
{
    size_t count = 1;
    for (int i = 0; i < n; i++)
        count *= (size_t)size[i];
    return count;
}

static double volume(const struct scene *s)
{
    return s->voxel[0] * s->voxel[1] * s->voxel[2];
}

/* Whether zone i belongs to group g: all, the layers along z, the octants. */
static bool is_in(const struct scene *s, size_t i, int g)
{
    int k = (int)i % s->size[2], j = (int)i / s->size[2] % s->size[1],
        h = (int)i / s->size[2] / s->size[1];
    if (g <= s->size[2])
        return !g || k == g - 1;
    g -= s->size[2] + 1;
    return (2 * h >= s->size[0]) == (g >> 2) && (2 * j >= s->size[1]) == (g >> 1 & 1) &&
           (2 * k >= s->size[2]) == (g & 1);
}

static int group_count(const struct scene *s)
{
    return 1 + s->size[2] + 8;
}

static void measure_groups(const struct scene *s, const double *b, double *out)
{
    for (int g = 0; g < group_count(s); g++) {
        double sum = 0, weight = 0;
        for (size_t i = 0; i < count_of(s->size, 3); i++)
            if (is_in(s, i, g)) {
                sum += s->kappa_t[i] * b[i];
                weight += s->kappa_t[i];
            }
        out[g] = sum / weight;
    }
}

/* ---- Monte Carlo ---- */

struct reference {
    double b[MOST], b_variance[MOST];
    double value[MOST_GROUPS], error[MOST_GROUPS]; /* groups, ground, absorbed, escaped */
};

static void run_batch(const struct scene *s, const mc_scene *mc, uint64_t seed, long packets,
                      double *b, double *value)
{
    double zone[MOST] = {0}, patch[MOST_PATCHES] = {0}, absorbed = 0, ground = 0;
    mc_tally tally = {.zone = zone, .patch = patch};
    mc_run(mc, seed, packets, &tally);
    for (size_t i = 0; i < count_of(s->size, 3); i++) {
        double weight = 4 * s->kappa_t[i] * volume(s);
        b[i] =
            weight > 0 ? s->albedo[i] * zone[i] / weight + (1 - s->albedo[i]) * s->emission[i] : 0;
        absorbed += (1 - s->albedo[i]) * zone[i];
    }
    size_t patches = count_of(s->patches, 2);
    double area = patches ? (s->ground_high[0] - s->ground_low[0]) *
                                (s->ground_high[1] - s->ground_low[1]) / (double)patches
                          : 0;
    for (size_t i = 0; i < patches; i++)
        ground += (s->glow[i] + s->rho[i] * patch[i] / area) / (double)patches;
    measure_groups(s, b, value);
    value += group_count(s);
    value[0] = ground;
    value[1] = absorbed;
    value[2] = tally.escaped;
}

/* Means and standard errors from BATCHES independent batches. */
static void run_monte_carlo(const struct scene *s, long packets, struct reference *out)
{
    const mc_scene mc = {.size = {s->size[0], s->size[1], s->size[2]},
                         .voxel = {s->voxel[0], s->voxel[1], s->voxel[2]},
                         .kappa_t = s->kappa_t,
                         .albedo = s->albedo,
                         .emission = s->emission,
                         .patches = {s->patches[0], s->patches[1]},
                         .height = -s->gap,
                         .ground_low = {s->ground_low[0], s->ground_low[1]},
                         .ground_high = {s->ground_high[0], s->ground_high[1]},
                         .ground_reflectance = s->rho,
                         .ground_emission = s->glow,
                         .sun = {s->sun[0], s->sun[1], s->sun[2]},
                         .irradiance = s->irradiance,
                         .sky_radiance = s->sky};
    int values = group_count(s) + 3;
    assert_true(values <= MOST_GROUPS);
    memset(out, 0, sizeof *out);
    for (int n = 0; n < BATCHES; n++) {
        double b[MOST], value[MOST_GROUPS];
        run_batch(s, &mc, (uint64_t)n + 1, packets / BATCHES, b, value);
        for (size_t i = 0; i < count_of(s->size, 3); i++) {
            out->b[i] += b[i] / BATCHES;
            out->b_variance[i] += b[i] * b[i] / BATCHES;
        }
        for (int i = 0; i < values; i++) {
            out->value[i] += value[i] / BATCHES;
            out->error[i] += value[i] * value[i] / BATCHES;
        }
    }
    for (size_t i = 0; i < count_of(s->size, 3); i++)
        out->b_variance[i] = fmax(0, out->b_variance[i] - out->b[i] * out->b[i]) / (BATCHES - 1);
    for (int i = 0; i < values; i++)
        out->error[i] =
            sqrt(fmax(0, out->error[i] - out->value[i] * out->value[i]) / (BATCHES - 1));
}

/* ---- The library ---- */

static void open_scene(const struct scene *s, struct world *w)
{
    float rho[MOST_PATCHES], glow[MOST_PATCHES];
    murk_array array = {.kappa_t = s->kappa_t, .albedo = s->albedo, .emission = s->emission};
    for (int a = 0; a < 3; a++) {
        array.size[a] = s->size[a];
        array.voxel_size[a] = s->voxel[a];
    }
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.height = -s->gap;
    ground.horizon = false;
    ground.reflectance_image = rho;
    ground.emission_image = glow;
    int columns = s->patches[0], rows = s->patches[1];
    for (int c = 0; c < 2; c++) {
        ground.extent_min[c] = s->ground_low[c];
        ground.extent_max[c] = s->ground_high[c];
        ground.patches[c] = s->patches[c];
    }
    for (int i = 0; i < rows * columns; i++) {
        int image = (rows - 1 - i / columns) * columns + i % columns;
        rho[image] = s->rho[i];
        glow[image] = s->glow[i];
    }
    world_open(w, 1, &array, columns ? &ground : NULL);
    w->scene.sun = (murk_sun){{s->sun[0], s->sun[1], s->sun[2]}, s->irradiance};
    w->scene.sky_radiance = s->sky;
}

static void check_solution(const struct scene *s, const struct reference *mc, struct world *w,
                           const murk_solve_options *options, double least)
{
    static double b[MOST];
    double value[MOST_GROUPS], allowance[MOST_GROUPS], norm2 = 0, share2 = 0, rho_h = 0, ground = 0;
    size_t zones = count_of(s->size, 3), patches = count_of(s->patches, 2);
    world_solve(w, options);
    const murk_report *report = murk_solution_report(w->solution);
    double e = fmax(report->estimate, least), off2 = 0, noise2 = 0, noise4 = 0;
    for (size_t i = 0; i < zones; i++) {
        int n = (int)i, nz = s->size[2], ny = s->size[1];
        double weight = s->kappa_t[i] * volume(s), a = s->albedo[i];
        b[i] = weight > 0 ? world_b(w, n / nz / ny, n / nz % ny, n % nz) : 0;
        norm2 += weight * b[i] * b[i];
        share2 += weight > 0 ? weight * pow((1 - a) / a, 2) : 0;
        off2 += weight * pow(b[i] - mc->b[i], 2);
        noise2 += weight * mc->b_variance[i];
        noise4 += pow(weight * mc->b_variance[i], 2);
    }
    float patch[MOST_PATCHES];
    if (patches)
        assert_int_equal(murk_solution_ground(w->solution, patch), MURK_OK);
    for (size_t i = 0; i < patches; i++)
        ground += patch[i] / (double)patches;
    for (size_t i = 0; i < patches; i++)
        rho_h +=
            (patch[i] - s->glow[(patches - 1 - i) / (size_t)s->patches[0] * (size_t)s->patches[0] +
                                i % (size_t)s->patches[0]]) /
            (double)patches;

    int groups = group_count(s);
    measure_groups(s, b, value);
    for (int g = 0; g < groups; g++) {
        double weight = 0;
        for (size_t i = 0; i < zones; i++)
            weight += is_in(s, i, g) ? s->kappa_t[i] * volume(s) : 0;
        allowance[g] = e * sqrt(norm2 / weight);
    }
    value[groups] = ground;
    allowance[groups] = 2 * e * rho_h;
    value[groups + 1] = report->energy_absorbed;
    allowance[groups + 1] = 4 * e * sqrt(norm2 * share2);
    value[groups + 2] = report->energy_escaped;
    allowance[groups + 2] = allowance[groups + 1] + e * report->energy_diffuse;
    printf("%s %s: estimate %.4f%%, L2 off %.4f%% (debiased %.4f%%) noise %.4f%%  sun %g diffuse "
           "%g emitted %g\n",
           s->name, report->method, 100 * report->estimate, 100 * sqrt(off2 / norm2),
           100 * sqrt(fmax(0, off2 - noise2) / norm2), 100 * sqrt(noise2 / norm2),
           report->energy_sun, report->energy_diffuse, report->energy_emitted);
    for (int i = 0; i < groups + 3; i++)
        printf("  %2d murk %.6g mc %.6g  off %+.4f%%  se %.4f%%  allow %.4f%% %s\n", i, value[i],
               mc->value[i], 100 * (value[i] / mc->value[i] - 1), 100 * mc->error[i] / mc->value[i],
               100 * allowance[i] / mc->value[i],
               fabs(value[i] - mc->value[i]) <= 4 * mc->error[i] + allowance[i] ? "" : "FAIL");
}

static void check_scene(const struct scene *s, long packets)
{
    static struct reference mc;
    struct world w;
    run_monte_carlo(s, packets, &mc);
    open_scene(s, &w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    options.directions = 1536;
    options.rays = 2;
    check_solution(s, &mc, &w, &options, 0);
    options.method = MURK_PAIRWISE;
    options.directions = options.rays = 0;
    options.tolerance = 1e-4;
    check_solution(s, &mc, &w, &options, 0.001);
    world_close(&w);
}

/* A uniform box on ground, oblique sun and sky. */
static void box_on_ground(void **state)
{
    (void)state;
    static struct scene s = {.name = "box on ground",
                             .size = {6, 5, 4},
                             .voxel = {0.1, 0.1, 0.1},
                             .patches = {8, 7},
                             .ground_low = {-0.1, -0.1},
                             .ground_high = {0.7, 0.6},
                             .sun = {0.48, -0.36, -0.8},
                             .irradiance = 1,
                             .sky = 0.1};
    for (size_t i = 0; i < count_of(s.size, 3); i++) {
        s.kappa_t[i] = 4;
        s.albedo[i] = 0.9f;
    }
    for (size_t i = 0; i < count_of(s.patches, 2); i++)
        s.rho[i] = (i + i / 8) % 3 ? 0.3f : 0.8f;
    check_scene(&s, 2000000);
}

static void varied(void **state)
{
    (void)state;
    static struct scene s = {.name = "varied",
                             .size = {10, 9, 8},
                             .voxel = {0.1, 0.1, 0.1},
                             .sun = {0.64, 0.48, -0.6},
                             .irradiance = 1};
    uint64_t random = 33;
    for (size_t i = 0; i < count_of(s.size, 3); i++) {
        double x = check_random(&random), y = check_random(&random);
        s.kappa_t[i] = x < 0.3 ? 0 : (float)(0.2 * pow(100, y));
        s.albedo[i] = (float)(0.2 + 0.79 * check_random(&random));
        s.emission[i] = i / 72 < 3 && i / 8 % 9 < 3 && i % 8 < 3 ? 5 : 0;
    }
    check_scene(&s, 1000000);
}

static void box_over_ground(void **state)
{
    (void)state;
    static struct scene s = {.name = "box over ground",
                             .size = {8, 8, 5},
                             .voxel = {0.1, 0.1, 0.1},
                             .patches = {10, 10},
                             .gap = 0.3,
                             .ground_low = {-0.1, -0.1},
                             .ground_high = {0.9, 0.9},
                             .sky = 0.05};
    for (size_t i = 0; i < count_of(s.size, 3); i++) {
        s.kappa_t[i] = 3;
        s.albedo[i] = 0.8f;
    }
    for (size_t i = 0; i < count_of(s.patches, 2); i++) {
        bool bright = i % 10 >= 2 && i % 10 < 5 && i / 10 >= 5 && i / 10 < 8;
        s.rho[i] = 0.2f;
        s.glow[i] = bright ? 2 : 0.1f;
    }
    check_scene(&s, 1000000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_on_ground),
        cmocka_unit_test(varied),
        cmocka_unit_test(box_over_ground),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
