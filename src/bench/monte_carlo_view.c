/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo_view.h"

#include "monte_carlo_line.h"
#include "monte_carlo_packet.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>

/* A path is worth its weight; below FAINT it lives on with the probability SURVIVAL. */
static const double FAINT = 0.1, SURVIVAL = 0.5;

/* What the even spread of a path's first coordinates is used for. */
enum { COLUMN, ROW, DISTANCE, TURN, PATH_SPREAD = TURN + 2 };
_Static_assert((int)PATH_SPREAD <= (int)SPREAD, "one coordinate for each use");

/* The pinhole in the world, and the ground beyond the patches. */
struct pinhole {
    const struct bench_mc_view *view;
    double forward[3], right[3], up[3], half[2];
    double beyond_reflectance, beyond_emission;
};

/* A path looks back along `along` from where it is. */
struct path {
    double at[3], along[3], weight;
    int zone, patch; /* that it has reached; zone NOWHERE: the patch, sky or plane */
};

double bench_mc_phase(double g, double cosine)
{
    double d = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * M_PI * d * sqrt(d));
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static void normalise(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int c = 0; c < 3; c++)
        v[c] /= length;
}

static void open_pinhole(const struct bench_mc_view *view, struct pinhole *out)
{
    const murk_camera *camera = &view->camera;
    const struct bench_mc_scene *s = view->scene;
    *out = (struct pinhole){.view = view};
    for (int c = 0; c < 3; c++)
        out->forward[c] = camera->target[c] - camera->eye[c];
    normalise(out->forward);
    cross(out->forward, camera->up, out->right);
    normalise(out->right);
    cross(out->right, out->forward, out->up);
    out->half[1] = tan(camera->fov / 2 * M_PI / 180);
    out->half[0] = out->half[1] * camera->size[0] / camera->size[1];
    size_t patches = view->horizon ? bench_mc_patches(s) : 0;
    for (size_t n = 0; n < patches; n++) {
        out->beyond_reflectance += s->ground_reflectance[n] / (double)patches;
        out->beyond_emission += s->ground_emission[n] / (double)patches;
    }
}

static void aim(const struct pinhole *pinhole, const double spread[SPREAD], struct path *p)
{
    const struct bench_mc_view *view = pinhole->view;
    const murk_camera *camera = &view->camera;
    double x = (view->left + view->width * spread[COLUMN]) / camera->size[0] * 2 - 1;
    double y = 1 - (view->top + view->height * spread[ROW]) / camera->size[1] * 2;
    for (int c = 0; c < 3; c++) {
        p->at[c] = camera->eye[c];
        p->along[c] = pinhole->forward[c] + x * pinhole->half[0] * pinhole->right[c] +
                      y * pinhole->half[1] * pinhole->up[c];
    }
    normalise(p->along);
}

/* Sunlight at a point on a plane across the beam. */
static double sunlight(const struct bench_mc_walk *walk, const double at[3])
{
    const struct bench_mc_scene *s = walk->scene;
    const double back[3] = {-s->sun[0], -s->sun[1], -s->sun[2]};
    if (!(s->irradiance > 0) || (s->patches[0] > 0 && back[2] <= 0))
        return 0;
    return s->irradiance * bench_mc_transmittance(walk, at, back);
}

/* Moves a path to where it has passed `depth`, or to the end of the medium; false there. */
static bool move(const struct bench_mc_walk *walk, double depth, struct path *p)
{
    const float *kappa_t = walk->scene->kappa_t;
    struct bench_mc_line line;
    double passed = 0, length;
    int zone;
    p->zone = BENCH_MC_NOWHERE;
    if (!bench_mc_line_begin(&line, walk->scene, p->at, p->along))
        return false;
    while (bench_mc_line_next(&line, &zone, &length)) {
        passed += kappa_t[zone] * length;
        if (!(passed > depth))
            continue;
        double t = line.t - (passed - depth) / kappa_t[zone];
        for (int c = 0; c < 3; c++)
            p->at[c] += t * p->along[c];
        p->zone = zone;
        return true;
    }
    return false;
}

/* Moves a path through the medium to what lies behind. */
static void leave(const struct bench_mc_walk *walk, struct path *p)
{
    p->zone = BENCH_MC_NOWHERE;
    p->patch = bench_mc_find_patch(walk, p->at, p->along, p->at);
}

static bool survive(struct bench_mc_walk *walk, struct path *p, double part)
{
    p->weight *= part;
    if (p->weight >= FAINT)
        return true;
    p->weight /= SURVIVAL;
    return p->weight > 0 && bench_mc_draw(walk) < SURVIVAL;
}

/* What a zone sends by itself and of the sun; the path goes on in a direction from u, v. */
static double meet_zone(struct bench_mc_walk *walk, double u, double v, struct path *p,
                        double *part)
{
    const struct bench_mc_scene *s = walk->scene;
    double albedo = s->albedo[p->zone];
    double sent = (1 - albedo) * s->emission[p->zone] / M_PI;
    if (albedo > 0)
        sent +=
            albedo * bench_mc_phase(s->asymmetry, -dot(s->sun, p->along)) * sunlight(walk, p->at);
    bench_mc_turn_scattered(s->asymmetry, u, v, p->along);
    *part = albedo;
    return sent;
}

static double meet_ground(const struct pinhole *pinhole, struct bench_mc_walk *walk, double u,
                          double v, struct path *p, double *part)
{
    const struct bench_mc_scene *s = walk->scene;
    bool on = p->patch >= 0;
    double emission = on ? s->ground_emission[p->patch] : pinhole->beyond_emission;
    *part = on ? s->ground_reflectance[p->patch] : pinhole->beyond_reflectance;
    double sun = *part > 0 ? -s->sun[2] * sunlight(walk, p->at) : 0;
    bench_mc_turn_lambertian(u, v, 2, 1, p->along);
    return (emission + *part * sun) / M_PI;
}

/* The radiance that leaves the place a path has reached; u, v: for the first turn. */
static double follow(const struct pinhole *pinhole, struct bench_mc_walk *walk, double u, double v,
                     struct path *p)
{
    double sum = 0, part;
    for (p->weight = 1;; u = bench_mc_draw(walk), v = bench_mc_draw(walk)) {
        if (p->zone < 0 && p->patch == BENCH_MC_NOWHERE)
            return sum + p->weight * walk->scene->sky_radiance;
        double weight = p->weight;
        sum += weight * (p->zone >= 0 ? meet_zone(walk, u, v, p, &part)
                                      : meet_ground(pinhole, walk, u, v, p, &part));
        if (!survive(walk, p, part))
            return sum;
        if (!move(walk, -log(bench_mc_draw(walk)), p))
            leave(walk, p);
    }
}

/* One path to the medium and one through it, each with the part of the ray that it stands for. */
static void sample(const struct pinhole *pinhole, struct bench_mc_walk *walk, double *surface,
                   double *path)
{
    const double *spread = walk->spread;
    bench_mc_spread_next(walk);
    struct path straight, scattered;
    aim(pinhole, spread, &straight);
    scattered = straight;
    double tau = bench_mc_transmittance(walk, straight.at, straight.along);
    leave(walk, &straight);
    *surface = tau * follow(pinhole, walk, bench_mc_draw(walk), bench_mc_draw(walk), &straight);
    *path = 0;
    if (move(walk, -log(1 - spread[DISTANCE] * (1 - tau)), &scattered))
        *path = (1 - tau) * follow(pinhole, walk, spread[TURN], spread[TURN + 1], &scattered);
}

static void run(const struct pinhole *pinhole, uint64_t seed, long paths, double *surface,
                double *path)
{
    struct bench_mc_walk walk;
    bench_mc_walk_begin(&walk, pinhole->view->scene, seed);
    bench_mc_spread_begin(&walk);
    *surface = *path = 0;
    for (long n = 0; n < paths; n++) {
        double one, other;
        sample(pinhole, &walk, &one, &other);
        *surface += one / (double)paths;
        *path += other / (double)paths;
    }
}

static struct bench_mc_mean mean_of(const double *value, int count)
{
    double sum = 0, squares = 0;
    for (int n = 0; n < count; n++)
        sum += value[n] / count;
    for (int n = 0; n < count; n++)
        squares += pow(value[n] - sum, 2);
    return (struct bench_mc_mean){sum, sqrt(squares / ((double)count * (count - 1)))};
}

bool bench_mc_view_radiance(const struct bench_mc_view *view, long paths, int batches, int threads,
                            struct bench_mc_radiance *out)
{
    struct pinhole pinhole;
    double *surface = malloc(3 * (size_t)batches * sizeof *surface);
    if (!surface)
        return false;
    double *path = surface + batches, *total = path + batches;
    open_pinhole(view, &pinhole);
#pragma omp parallel for schedule(dynamic, 1)                                                      \
    num_threads(threads > 0 ? threads : omp_get_max_threads())
    for (int n = 0; n < batches; n++) {
        run(&pinhole, (uint64_t)n + 1, paths / batches, &surface[n], &path[n]);
        total[n] = surface[n] + path[n];
    }
    *out = (struct bench_mc_radiance){mean_of(surface, batches), mean_of(path, batches),
                                      mean_of(total, batches)};
    free(surface);
    return true;
}
