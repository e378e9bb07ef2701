/* SPDX-License-Identifier: Apache-2.0 */
#include "system.h"

#include <string.h>

murk_status murk_vector_create(const murk_system *system, murk_vector *out)
{
    murk_vector made = {.zone = murk_alloc(system->slots, sizeof(float)),
                        .patch = murk_alloc(system->patches, sizeof(float))};
    if (!made.zone || !made.patch) {
        murk_vector_clear(&made);
        return murk_fail(system->context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                         system->medium->grid->zone_count);
    }
    *out = made;
    return MURK_OK;
}

void murk_vector_clear(murk_vector *vector)
{
    murk_free(vector->zone);
    murk_free(vector->patch);
    memset(vector, 0, sizeof *vector);
}

void murk_vector_copy(const murk_system *system, const murk_vector *from, murk_vector *to)
{
    memcpy(to->zone, from->zone, system->slots * sizeof(float));
    memcpy(to->patch, from->patch, system->patches * sizeof(float));
}

void murk_vector_add(const murk_system *system, double a, const murk_vector *x, murk_vector *y)
{
    float f = (float)a;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] += f * x->zone[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] += f * x->patch[i];
}

void murk_vector_turn(const murk_system *system, const murk_vector *x, double a, murk_vector *y)
{
    float f = (float)a;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] = x->zone[i] + f * y->zone[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] = x->patch[i] + f * y->patch[i];
}

/* ---- sums ---------------------------------------------------------------------------------- */

/* The slots are cut into this many parts whatever the number of threads, and their sums added in
   order: rounding does not depend on who did which. */
enum { PARTS = 256 };

static size_t part(const murk_system *system, int n)
{
    return system->slots / PARTS * (size_t)n + system->slots % PARTS * (size_t)n / PARTS;
}

static double sum_of(const double parts[PARTS])
{
    double sum = 0;
    for (int n = 0; n < PARTS; n++)
        sum += parts[n];
    return sum;
}

/* 4 kappa V / albedo and A / rho, 0 in rows without scattering. */
static double zone_weight(const murk_system *system, size_t i)
{
    float albedo = murk_value(&system->medium->albedo, i);
    return albedo > 0 ? 4 * system->medium->grid->volume * system->medium->kappa_t[i] / albedo : 0;
}

static double patch_weight(const murk_system *system, size_t i)
{
    float reflectance = system->ground->reflectance[i];
    return reflectance > 0 ? murk_ground_area(system->ground, i) / reflectance : 0;
}

double murk_vector_product(const murk_system *system, const murk_vector *x, const murk_vector *y)
{
    double parts[PARTS], patches = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        double sum = 0;
        for (size_t i = part(system, n); i < part(system, n + 1); i++)
            sum += zone_weight(system, i) * x->zone[i] * y->zone[i];
        parts[n] = sum;
    }
    for (size_t i = 0; i < system->patches; i++)
        patches += patch_weight(system, i) * x->patch[i] * y->patch[i];
    return sum_of(parts) + patches;
}

double murk_vector_norm2(const murk_system *system, const murk_vector *x)
{
    const murk_medium *medium = system->medium;
    double parts[PARTS];
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        double sum = 0;
        for (size_t i = part(system, n); i < part(system, n + 1); i++)
            sum += (double)medium->kappa_t[i] * x->zone[i] * x->zone[i];
        parts[n] = sum;
    }
    return sum_of(parts) * medium->grid->volume;
}

void murk_vector_products(const murk_system *system, const murk_vector *r, const murk_vector *z,
                          double *rr, double *rz, double *zz)
{
    double parts[3][PARTS], patches[3] = {0};
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        double sum[3] = {0};
        for (size_t i = part(system, n); i < part(system, n + 1); i++) {
            double weight = zone_weight(system, i), u = r->zone[i], v = z->zone[i];
            sum[0] += weight * u * u;
            sum[1] += weight * u * v;
            sum[2] += weight * v * v;
        }
        for (int c = 0; c < 3; c++)
            parts[c][n] = sum[c];
    }
    for (size_t i = 0; i < system->patches; i++) {
        double weight = patch_weight(system, i), u = r->patch[i], v = z->patch[i];
        patches[0] += weight * u * u;
        patches[1] += weight * u * v;
        patches[2] += weight * v * v;
    }
    *rr = sum_of(parts[0]) + patches[0];
    *rz = sum_of(parts[1]) + patches[1];
    *zz = sum_of(parts[2]) + patches[2];
}

double murk_vector_step(const murk_system *system, double a, const murk_vector *p,
                        const murk_vector *q, murk_vector *x, murk_vector *r)
{
    const float f = (float)a;
    double parts[PARTS], patches = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        double sum = 0;
        for (size_t i = part(system, n); i < part(system, n + 1); i++) {
            x->zone[i] += f * p->zone[i];
            r->zone[i] -= f * q->zone[i];
            sum += zone_weight(system, i) * x->zone[i] * x->zone[i];
        }
        parts[n] = sum;
    }
    for (size_t i = 0; i < system->patches; i++) {
        x->patch[i] += f * p->patch[i];
        r->patch[i] -= f * q->patch[i];
        patches += patch_weight(system, i) * x->patch[i] * x->patch[i];
    }
    return sum_of(parts) + patches;
}

/* ---- the system ---------------------------------------------------------------------------- */

murk_status murk_system_apply(murk_system *system, const murk_vector *x, murk_vector *y)
{
    const murk_medium *medium = system->medium;
    const murk_radiosity in = {.zone = x->zone, .patch = system->ground ? x->patch : NULL};
    murk_incident out = {.zone = y->zone, .patch = system->ground ? y->patch : NULL};
    murk_status status = system->method->apply(system->context, system->state, &in, &out);
    if (status)
        return status;
    system->power += system->cost;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++) {
        /* The operator gives G/4 - x: the difference is exact where the two almost cancel. */
        float albedo = murk_value(&medium->albedo, i);
        y->zone[i] = medium->kappa_t[i] > 0 ? (1 - albedo) * x->zone[i] - albedo * y->zone[i] : 0;
    }
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] = x->patch[i] - system->ground->reflectance[i] * y->patch[i];
    return MURK_OK;
}
