/* SPDX-License-Identifier: Apache-2.0 */
#include "forward.h"

#include "beam.h"
#include "finish.h"
#include "similarity.h"

#include <math.h>
#include <string.h>

enum {
    TERMS = MURK_FORWARD_TERMS,
    BEAM_RAYS = 8, /* lines per voxel face and axis, as the solution's beam */
    ORDERS = 48,   /* of V at the depths below, good to 1e-15 */
    ANGLES = 2048  /* steps of the weights' table in sin(angle/2) */
};

/* The cosine of the widest spread of light from the ground, as it fits the Monte Carlo: what is
   scattered farther aside mostly comes from elsewhere. */
static const double WIDEST = 0.7;

/* V is met at these scattering depths: single scattering at 0, the rest to a few per cent of V up
   to 12 where V matters. */
static const double MET[TERMS] = {0, 2, 8};

/* x_j. Those of a small g would be too near to one another for a fit. */
static void choose_parts(double g, double part[TERMS])
{
    double most = fmax(fabs(g), 0.3);
    part[0] = 0;
    part[1] = most * most;
    part[2] = most;
}

/* 4 pi p of Henyey and Greenstein; u = sin(angle/2). */
static double phase(double g, double u)
{
    double d = (1 - g) * (1 - g) + 4 * g * u * u;
    return (1 - g * g) / (d * sqrt(d));
}

/* 4 pi V. */
static double forward_part(double g, double u, double s)
{
    double sum = 0, power = 1, factor = 1; /* g^n, s^(n-1)/n! */
    for (int n = 1; n <= ORDERS; n++) {
        power *= g;
        factor *= n > 1 ? s / n : 1;
        sum += factor * (phase(power, u) - (1 - power));
    }
    return sum;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

/* The a_j of all angles from their three linear equations. */
static void fit(double g, const double part[TERMS], double (*weight)[TERMS])
{
    double row[TERMS][TERMS], column[TERMS][TERMS], determinant = 0;
    for (int i = 0; i < TERMS; i++)
        for (int j = 0; j < TERMS; j++)
            row[i][j] = exp(part[j] * MET[i]);
    for (int i = 0; i < TERMS; i++)
        cross(row[(i + 1) % TERMS], row[(i + 2) % TERMS], column[i]);
    for (int j = 0; j < TERMS; j++)
        determinant += row[0][j] * column[0][j];
    for (int n = 0; n <= ANGLES; n++) {
        memset(weight[n], 0, sizeof weight[n]);
        for (int i = 0; i < TERMS; i++) {
            double v = forward_part(g, (double)n / ANGLES, MET[i]) / determinant;
            for (int j = 0; j < TERMS; j++)
                weight[n][j] += v * column[i][j];
        }
    }
}

/* albedo G_sun/4 in a reduced medium, on the solution's grid. */
static murk_status light_sun(murk_context *context, const murk_solution *solution,
                             const murk_medium *medium, float *source)
{
    const murk_grid *grid = solution->grid, *zones = medium->grid;
    const double mean = murk_mean_albedo(medium);
    double extinguished;
    float *kappa_t = murk_alloc(grid->brick_count * MURK_BRICK_SLOTS, sizeof *kappa_t);
    if (!kappa_t)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the sun's beam");
    for (size_t b = 0; b < zones->brick_count; b++) {
        const int32_t *at = zones->brick[b];
        memcpy(kappa_t + (size_t)murk_grid_find(grid, at[0], at[1], at[2]) * MURK_BRICK_SLOTS,
               medium->kappa_t + b * MURK_BRICK_SLOTS, MURK_BRICK_SLOTS * sizeof *kappa_t);
    }
    murk_status status = murk_beam(context, grid, kappa_t, solution->ground, &solution->sun,
                                   BEAM_RAYS, NULL, source, NULL, NULL, &extinguished);
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int s = 0; s < MURK_BRICK_SLOTS; s++) {
            const int32_t voxel[3] = {grid->brick[b][0] * MURK_BRICK_EDGE + (s >> 6),
                                      grid->brick[b][1] * MURK_BRICK_EDGE + (s >> 3 & 7),
                                      grid->brick[b][2] * MURK_BRICK_EDGE + (s & 7)};
            size_t o = b * MURK_BRICK_SLOTS + (size_t)s;
            if (!murk_grid_active(grid, b, s))
                continue;
            int64_t i = kappa_t[o] > 0 ? murk_grid_slot(zones, voxel[0], voxel[1], voxel[2]) : -1;
            source[o] *= (i < 0 ? murk_margin_albedo(medium, voxel, mean)
                                : murk_value(&medium->albedo, (size_t)i)) /
                         4;
        }
    murk_free(kappa_t);
    return status;
}

static murk_status create_term(murk_context *context, const murk_solution *solution, double part,
                               murk_medium **medium, murk_march *march)
{
    murk_status status = murk_medium_reduce(context, solution->medium, part, medium);
    if (status)
        return status;
    (*medium)->emission = (murk_values){0}; /* sunlight alone */
    murk_solution lit = *solution;
    lit.medium = *medium;
    lit.radiosity =
        murk_alloc(solution->grid->brick_count * MURK_BRICK_SLOTS, sizeof *lit.radiosity);
    if (!lit.radiosity)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    status = light_sun(context, solution, *medium, lit.radiosity);
    if (!status)
        status = murk_march_create(context, &lit, march);
    murk_free(lit.radiosity);
    return status;
}

static murk_status create_sun(murk_context *context, const murk_solution *solution,
                              murk_forward *forward)
{
    const double g = solution->medium->asymmetry;
    double part[TERMS];
    murk_status status = MURK_OK;
    choose_parts(g, part);
    forward->weight = murk_alloc(ANGLES + 1, sizeof *forward->weight);
    if (!forward->weight)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    fit(g, part, forward->weight);
    for (int j = 0; !status && j < TERMS; j++) {
        status = create_term(context, solution, part[j], &forward->medium[j], &forward->sun[j]);
        /* Its albedo is that of the whole medium times 1 - x_j, by kappa_t. */
        for (int n = 0; n <= ANGLES; n++)
            forward->weight[n][j] /= 1 - part[j];
    }
    return status;
}

double murk_forward_spread(const murk_forward *forward, double turned)
{
    /* Scatterings of light that is scattered at all; one after another they are one of g^n. */
    double order = turned > 1e-6 ? turned / -expm1(-turned) : 1;
    double g = pow(fabs(forward->asymmetry), order);
    double cosine = fmax(g * (3 - g * g) / 2, WIDEST);
    return sqrt(fmax(0, 1 - cosine * cosine)) / cosine;
}

murk_status murk_forward_create(murk_context *context, const murk_solution *solution,
                                murk_forward *out)
{
    murk_forward forward = {.asymmetry = solution->medium->asymmetry};
    murk_status status = murk_similarity_reduce(context, solution, &forward.reduced);
    if (!status && solution->ground)
        status = murk_blur_create(context, solution, &forward.ground);
    if (!status)
        status = murk_march_create(context, &forward.reduced, &forward.march);
    if (!status && murk_beam_direction(solution->ground, &solution->sun, forward.travel))
        status = create_sun(context, solution, &forward);
    if (status)
        murk_forward_clear(&forward);
    else
        *out = forward;
    return status;
}

void murk_forward_clear(murk_forward *forward)
{
    murk_march_clear(&forward->march);
    murk_similarity_clear(&forward->reduced);
    murk_blur_clear(&forward->ground);
    murk_free(forward->weight);
    for (int j = 0; j < TERMS; j++) {
        murk_march_clear(&forward->sun[j]);
        murk_medium_release(forward->medium[j]);
    }
}

bool murk_forward_march(const murk_forward *forward, const int32_t *brick, size_t count,
                        const murk_packet *packet, murk_trace *trace, size_t stride,
                        murk_forwarded *out)
{
    murk_packet again = *packet;
    if (!murk_march_light(&forward->march, brick, count, &again, trace))
        return false;
    memcpy(out->path, again.path, sizeof out->path);
    memcpy(out->depth, again.depth, sizeof out->depth);
    for (int j = 1; forward->weight && j < TERMS; j++) {
        again = *packet;
        if (!murk_march_light(&forward->sun[j], brick, count, &again, trace + stride * (size_t)j))
            return false;
        memcpy(out->sun[j], again.path, sizeof out->sun[j]);
    }
    return true;
}

/* The sun's light that is scattered forward towards the camera, `cosine` off its way; path: of the
   first term. */
static double sun_light(const murk_forward *forward, const murk_forwarded *passed, int lane,
                        double path, double cosine)
{
    double x = sqrt(fmax(0, fmin((1 - cosine) / 2, 1))) * ANGLES, sum = 0;
    int n = x < ANGLES ? (int)x : ANGLES - 1;
    for (int j = 0; j < TERMS; j++) {
        double low = forward->weight[n][j], high = forward->weight[n + 1][j];
        sum += (low + (x - n) * (high - low)) * (j ? passed->sun[j][lane] : path);
    }
    return sum;
}

void murk_forward_light(const murk_forward *forward, const murk_forwarded *passed,
                        const double direction[3][MURK_LANES], const double behind[MURK_LANES],
                        murk_packet *packet)
{
    for (int l = 0; l < MURK_LANES; l++) {
        double turned = exp(-passed->depth[l]) - exp(-packet->depth[l]), cosine = 0;
        double path = passed->path[l] + turned * behind[l];
        for (int c = 0; c < 3; c++)
            cosine -= forward->travel[c] * direction[c][l];
        if (forward->weight)
            path += sun_light(forward, passed, l, packet->path[l], cosine);
        packet->path[l] = fmax(0, path);
    }
}
