/* SPDX-License-Identifier: Apache-2.0 */
#include "march.h"

#include "beam.h"
#include "blocks.h"
#include "walk.h"

#include <math.h>

/* What is behind this much transmittance cannot be seen in a float picture of eight digits. */
static const double OPAQUE = 1e-7;

static bool remember(murk_trace *trace, double t, double depth)
{
    if (trace->count == trace->capacity) {
        size_t capacity = trace->capacity ? 2 * trace->capacity : 256;
        double(*grown)[2] = murk_alloc(capacity, sizeof *grown);
        if (!grown)
            return false;
        for (size_t i = 0; i < trace->count; i++) {
            grown[i][0] = trace->passed[i][0];
            grown[i][1] = trace->passed[i][1];
        }
        murk_free(trace->passed);
        trace->passed = grown;
        trace->capacity = capacity;
    }
    trace->passed[trace->count][0] = t;
    trace->passed[trace->count][1] = depth;
    trace->count++;
    return true;
}

/* Where half of the depth lies, linearly within its step. The trace holds two entries a step. */
static double find_half(const murk_trace *trace, double depth)
{
    double half = depth / 2;
    for (size_t i = 1; i < trace->count; i += 2) {
        const double *from = trace->passed[i - 1], *to = trace->passed[i];
        if (to[1] >= half)
            return from[0] + (to[0] - from[0]) * (half - from[1]) / fmax(to[1] - from[1], 1e-300);
    }
    return INFINITY;
}

/* Mean distance, as a fraction of a step of optical length x, at which the light of a constant
   source leaves for the viewer: one sample there is exact for a source that varies linearly. */
static double centre_of_light(double x)
{
    if (x < 0.05)
        return 0.5 - x / 12 + x * x * x / 720;
    double e = exp(-x);
    return 1 / x - e / (1 - e);
}

bool murk_march_ray(const murk_march *march, const double eye[3], const double direction[3],
                    double t_max, murk_trace *trace, murk_light *out)
{
    const murk_medium *medium = march->solution->medium;
    const murk_grid *grid = medium->grid;
    double origin[3], along[3], depth = 0, path = 0, tau = 1;
    murk_walk walk;
    murk_step step;
    murk_grid_from_world(grid, eye, origin);
    murk_grid_direction_from_world(grid, direction, along);
    murk_walk_start(&walk, grid, origin, along, 0, t_max);
    trace->count = 0;
    while (murk_walk_next(&walk, &step)) {
        size_t slot = (size_t)step.brick * MURK_BRICK_SLOTS + (size_t)step.slot;
        double kappa_t = medium->kappa_t[slot], length = step.t1 - step.t0;
        double x = kappa_t * length;
        if (!(x > 0))
            continue;
        if (!remember(trace, step.t0, depth) || !remember(trace, step.t1, depth + x))
            return false;
        depth += x;
        if (tau < OPAQUE)
            continue;
        double t = step.t0 + length * centre_of_light(x), point[3];
        for (int a = 0; a < 3; a++)
            point[a] = walk.origin[a] + walk.direction[a] * t -
                       (grid->brick[step.brick][a] * MURK_BRICK_EDGE - grid->lo[a]);
        double radiosity =
            murk_block_sample(march->blocks + (size_t)step.brick * MURK_BLOCK_SLOTS, point);
        path -= tau * expm1(-x) * radiosity / M_PI;
        tau = exp(-depth);
    }
    out->path = path;
    out->transmittance = exp(-depth);
    out->half_depth = depth > 0 ? find_half(trace, depth) : INFINITY;
    return true;
}

/* Interpolation weights between the centres of patches on one axis. */
static void between(const murk_ground *ground, int c, int column, double x, int out[2],
                    double *fraction)
{
    const double *edge = ground->edge[c];
    double centre = (edge[column] + edge[column + 1]) / 2;
    int other = x < centre ? column - 1 : column + 1;
    other = other < 0 ? 0 : other >= ground->count[c] ? ground->count[c] - 1 : other;
    double there = (edge[other] + edge[other + 1]) / 2;
    out[0] = column;
    out[1] = other;
    *fraction = other == column ? 0 : (x - centre) / (there - centre);
}

static double diffuse_at(const murk_solution *solution, size_t patch, double a, double b)
{
    const murk_ground *ground = solution->ground;
    int columns = ground->count[0], ia[2], ib[2];
    double fa, fb;
    between(ground, 0, (int)(patch % (size_t)columns), a, ia, &fa);
    between(ground, 1, (int)(patch / (size_t)columns), b, ib, &fb);
    const float *h = solution->patch_diffuse;
    double low = (1 - fa) * h[ib[0] * columns + ia[0]] + fa * h[ib[0] * columns + ia[1]];
    double high = (1 - fa) * h[ib[1] * columns + ia[0]] + fa * h[ib[1] * columns + ia[1]];
    return (1 - fb) * low + fb * high;
}

double murk_march_ground(const murk_march *march, double a, double b)
{
    const murk_solution *solution = march->solution;
    const murk_ground *ground = solution->ground;
    const murk_grid *grid = solution->medium->grid;
    int64_t patch = murk_ground_patch(ground, a, b);
    if (patch == MURK_GROUND_NOTHING)
        return 0;
    double sun = murk_beam_on_ground(ground, &solution->sun), travel[3];
    if (sun > 0 && murk_beam_direction(ground, &solution->sun, travel)) {
        double point[3], origin[3], towards[3], along[3];
        point[murk_ground_axis_a(ground)] = a;
        point[murk_ground_axis_b(ground)] = b;
        point[murk_ground_axis_up(ground)] = ground->height;
        for (int c = 0; c < 3; c++)
            towards[c] = -travel[c];
        murk_grid_from_world(grid, point, origin);
        murk_grid_direction_from_world(grid, towards, along);
        sun *= exp(-murk_walk_depth(grid, solution->medium->kappa_t, origin, along, 0, INFINITY));
    }
    if (patch == MURK_GROUND_HORIZON)
        return ground->mean_emission +
               ground->mean_reflectance * (sun + M_PI * solution->sky_radiance);
    return ground->emission[patch] +
           ground->reflectance[patch] * (sun + diffuse_at(solution, (size_t)patch, a, b));
}
