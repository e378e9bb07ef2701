/* SPDX-License-Identifier: Apache-2.0 */
#include "setting.h"

int zone_count(const struct bench_mc_scene *s)
{
    return (int)bench_mc_zones(s);
}

int patch_count(const struct bench_mc_scene *s)
{
    return (int)bench_mc_patches(s);
}

double optical_volume(const struct bench_mc_scene *s, int zone)
{
    return s->kappa_t[zone] * s->voxel[0] * s->voxel[1] * s->voxel[2];
}

struct bench_mc_scene *setting_start(struct setting *s, int nx, int ny, int nz)
{
    memset(s, 0, sizeof *s);
    s->mc = (struct bench_mc_scene){.size = {nx, ny, nz},
                                    .voxel = {0.1, 0.1, 0.1},
                                    .kappa_t = s->kappa_t,
                                    .albedo = s->albedo,
                                    .emission = s->emission,
                                    .ground_reflectance = s->rho,
                                    .ground_emission = s->glow};
    assert_true(zone_count(&s->mc) <= MOST_ZONES);
    return &s->mc;
}

void setting_fill(struct setting *s, double kappa_t, double albedo)
{
    for (int n = 0; n < zone_count(&s->mc); n++) {
        s->kappa_t[n] = (float)kappa_t;
        s->albedo[n] = (float)albedo;
    }
}

void setting_lay_ground(struct bench_mc_scene *s, int beyond, double gap)
{
    s->height = -gap;
    for (int c = 0; c < 2; c++) {
        s->patches[c] = s->size[c] + 2 * beyond;
        s->ground_low[c] = -beyond * s->voxel[c];
        s->ground_high[c] = (s->size[c] + beyond) * s->voxel[c];
    }
    assert_true(patch_count(s) <= MOST_PATCHES);
}

void setting_sun(struct bench_mc_scene *s, double x, double y, double z)
{
    s->irradiance = 1;
    s->sun[0] = x;
    s->sun[1] = y;
    s->sun[2] = z;
}

/* ---- The library ---- */

/* Where a patch is in the library's image order. */
static int image_of(const struct bench_mc_scene *s, int patch)
{
    int columns = s->patches[0], rows = s->patches[1];
    return (rows - 1 - patch / columns) * columns + patch % columns;
}

void setting_open(const struct bench_mc_scene *s, int threads, struct world *w)
{
    float rho[MOST_PATCHES], glow[MOST_PATCHES];
    murk_array array = {.kappa_t = s->kappa_t,
                        .albedo = s->albedo,
                        .emission = s->emission,
                        .asymmetry = s->asymmetry};
    for (int a = 0; a < 3; a++) {
        array.size[a] = s->size[a];
        array.voxel_size[a] = s->voxel[a];
    }
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.height = s->height;
    ground.horizon = false;
    ground.reflectance_image = rho;
    ground.emission_image = glow;
    for (int c = 0; c < 2; c++) {
        ground.extent_min[c] = s->ground_low[c];
        ground.extent_max[c] = s->ground_high[c];
        ground.patches[c] = s->patches[c];
    }
    for (int n = 0; n < patch_count(s); n++) {
        rho[image_of(s, n)] = s->ground_reflectance[n];
        glow[image_of(s, n)] = s->ground_emission[n];
    }
    world_open(w, threads, &array, patch_count(s) ? &ground : NULL);
    w->scene.sun = (murk_sun){{s->sun[0], s->sun[1], s->sun[2]}, s->irradiance};
    w->scene.sky_radiance = s->sky_radiance;
}

void setting_solution(const struct bench_mc_scene *s, const struct world *w, double *b)
{
    float patch[MOST_PATCHES];
    int zones = zone_count(s), ny = s->size[1], nz = s->size[2];
    for (int n = 0; n < zones; n++)
        b[n] = s->kappa_t[n] > 0 ? world_b(w, n / nz / ny, n / nz % ny, n % nz) : 0;
    if (patch_count(s))
        assert_int_equal(murk_solution_ground(w->solution, patch), MURK_OK);
    for (int n = 0; n < patch_count(s); n++)
        b[zones + n] = patch[image_of(s, n)];
}

/* ---- Monte Carlo ---- */

static bool run_batch(const struct bench_mc_scene *s, bool exact, uint64_t seed, long packets,
                      batch_fn *derive, double *b, double *value)
{
    double power[MOST] = {0};
    struct bench_mc_tally tally = {.zone = power, .patch = power + zone_count(s)};
    if (!bench_mc_run(s, exact, seed, packets, &tally))
        return false;
    bench_mc_radiosity(s, &tally, b, b + zone_count(s));
    if (derive)
        derive(s, &tally, b, value);
    return true;
}

void batches_run(const struct bench_mc_scene *s, bool exact, long packets, batch_fn *derive,
                 struct batches *out)
{
    bool ran = true;
#pragma omp parallel for schedule(dynamic, 1) reduction(&& : ran)
    for (int n = 0; n < BATCHES; n++)
        ran = run_batch(s, exact, (uint64_t)n + 1, packets / BATCHES, derive, out->b[n],
                        out->value[n]) &&
              ran;
    assert_true(ran);
}

struct distance batches_distance(const struct batches *mc, int first, int count,
                                 const double *weight, const double *b)
{
    static double total[MOST];
    double squares = 0, trace = 0, norm2 = 0, sum2 = 0, pairs = BATCHES * (BATCHES - 1);
    memset(total, 0, sizeof total);
    for (int z = first; z < first + count; z++) {
        for (int n = 0; n < BATCHES; n++) {
            total[z] += b[z] - mc->b[n][z];
            squares += weight[z] * pow(b[z] - mc->b[n][z], 2);
        }
        sum2 += weight[z] * total[z] * total[z];
        norm2 += weight[z] * b[z] * b[z];
    }
    for (int n = 0; n < BATCHES; n += 2) {
        double product = 0;
        for (int z = first; z < first + count; z++)
            product += weight[z] * (b[z] - mc->b[n][z] - total[z] / BATCHES) *
                       (b[z] - mc->b[n + 1][z] - total[z] / BATCHES);
        trace += product * product / (BATCHES / 2);
    }
    trace /= norm2 * norm2;
    return (struct distance){(sum2 - squares) / pairs / norm2, sqrt(2 * trace / pairs),
                             sqrt(4 * sqrt(trace) / BATCHES)};
}

double distance_error(const struct distance *d, double a)
{
    return sqrt(pow(d->error_0, 2) + pow(d->error_1 * a, 2));
}
