/* SPDX-License-Identifier: Apache-2.0 */
#include "spatial.h"

#include <math.h>

/* Measured against solutions of media halved twice and thrice: sunlit and glowing, rough and
   smooth, albedo 0.5 ... 0.999, 0.1 ... 20 optical depths a zone. The flat one is right within a
   third up to 0.3 optical depths, the linear ones are bounds. */
static const double FLAT = 0.09, LEAPS = 1.5, RIMS = 0.2, BEAM = 3.5e-4;
/* Squares of slopes above this are those of an opaque zone. */
static const double STEEPEST = 30;

double murk_spatial_flat(double depth)
{
    double error = FLAT * depth * depth;
    return error / (1 + error);
}

static double slope_of(const murk_system *system, const murk_vector *x, size_t slot, int axis)
{
    int32_t place = system->bent->place[slot / MURK_BRICK_SLOTS];
    return place == MURK_NOT_BENT
               ? 0
               : x->slope[(size_t)place * MURK_BENT_SLOTS + (size_t)axis * MURK_BRICK_SLOTS +
                          (slot & (MURK_BRICK_SLOTS - 1))];
}

/* Squares of what leaps at a zone's faces, of what falls off where it has no neighbour, both in
   scattered light, and of the slopes of direct light relative to it. */
struct roughness {
    double leaps, rims, beam;
};

static struct roughness roughness_of(const murk_system *system, const murk_vector *x,
                                     const murk_vector *direct, size_t i)
{
    const murk_medium *medium = system->medium;
    double b = x->zone[i] - direct->zone[i];
    struct roughness sum = {0};
    for (int a = 0; a < 3; a++) {
        double beam = slope_of(system, direct, i, a), slope = slope_of(system, x, i, a) - beam;
        double part = -expm1(-medium->kappa_t[i] * medium->grid->voxel[a]);
        if (direct->zone[i] > 0)
            sum.beam += pow(beam / direct->zone[i], 2);
        for (int side = -1; side < 2; side += 2) {
            int64_t n = murk_grid_beside(medium->grid, i, a, side);
            if (n < 0 || !(medium->kappa_t[n] > 0)) {
                sum.rims += part * slope * slope;
                continue;
            }
            double other =
                slope_of(system, x, (size_t)n, a) - slope_of(system, direct, (size_t)n, a);
            double leap = b + side * slope / 2 - (x->zone[n] - direct->zone[n]) + side * other / 2;
            sum.leaps += part * leap * leap;
        }
    }
    return sum;
}

double murk_spatial_linear(const murk_system *system, const murk_vector *x,
                           const murk_vector *direct)
{
    const murk_medium *medium = system->medium;
    double leaps = 0, rims = 0, beam = 0, size = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)                    \
    reduction(+ : leaps, rims, beam, size)
    for (size_t i = 0; i < system->slots; i++) {
        double kappa_t = medium->kappa_t[i], b = x->zone[i];
        if (!(kappa_t > 0))
            continue;
        size += kappa_t * b * b;
        if (system->bent->place[i / MURK_BRICK_SLOTS] == MURK_NOT_BENT)
            continue;
        struct roughness here = roughness_of(system, x, direct, i);
        double albedo = murk_value(&medium->albedo, i);
        leaps += kappa_t * here.leaps;
        rims += kappa_t * here.rims;
        beam += kappa_t * pow(b * albedo * fmin(here.beam, STEEPEST), 2);
    }
    return size > 0 ? (LEAPS * leaps + RIMS * rims + BEAM * beam) / size : 0;
}
