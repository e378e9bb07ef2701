/* SPDX-License-Identifier: Apache-2.0 */
#include "system.h"

#include "apply.h"

#include <string.h>

murk_status murk_vector_create(const murk_system *system, murk_vector *out)
{
    murk_vector made = {.zone = murk_alloc(system->slots, sizeof(float)),
                        .slope = murk_alloc(system->slopes, sizeof(float)),
                        .patch = murk_alloc(system->patches, sizeof(float))};
    if (!made.zone || !made.slope || !made.patch) {
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
    murk_free(vector->slope);
    murk_free(vector->patch);
    memset(vector, 0, sizeof *vector);
}

void murk_vector_copy(const murk_system *system, const murk_vector *from, murk_vector *to)
{
    memcpy(to->zone, from->zone, system->slots * sizeof(float));
    memcpy(to->slope, from->slope, system->slopes * sizeof(float));
    memcpy(to->patch, from->patch, system->patches * sizeof(float));
}

void murk_vector_add(const murk_system *system, double a, const murk_vector *x, murk_vector *y)
{
    float f = (float)a;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] += f * x->zone[i];
    for (size_t i = 0; i < system->slopes; i++)
        y->slope[i] += f * x->slope[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] += f * x->patch[i];
}

void murk_vector_turn(const murk_system *system, const murk_vector *x, double a, murk_vector *y)
{
    float f = (float)a;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] = x->zone[i] + f * y->zone[i];
    for (size_t i = 0; i < system->slopes; i++)
        y->slope[i] = x->slope[i] + f * y->slope[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] = x->patch[i] + f * y->patch[i];
}

/* ---- sums ---------------------------------------------------------------------------------- */

/* The slots are cut into this many parts whatever the number of threads, and their sums added in
   order: rounding does not depend on who did which. */
enum { PARTS = 256 };

static size_t part_of(size_t count, int n)
{
    return count / PARTS * (size_t)n + count % PARTS * (size_t)n / PARTS;
}

static size_t part(const murk_system *system, int n)
{
    return part_of(system->slots, n);
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

/* The part of slopes in a product. */
static double slope_product(const murk_system *system, const float *x, const float *y)
{
    double parts[PARTS];
    if (!system->slopes)
        return 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        double sum = 0;
        for (size_t j = part_of(system->slopes, n); j < part_of(system->slopes, n + 1); j++)
            sum += zone_weight(system, murk_bent_slot(system->bent, j)) * x[j] * y[j];
        parts[n] = sum / 12;
    }
    return sum_of(parts);
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
    return sum_of(parts) + slope_product(system, x->slope, y->slope) + patches;
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

bool murk_vector_zero(const murk_system *system, const murk_vector *x)
{
    for (size_t i = 0; i < system->slots; i++)
        if (x->zone[i] != 0)
            return false;
    for (size_t i = 0; i < system->slopes; i++)
        if (x->slope[i] != 0)
            return false;
    for (size_t i = 0; i < system->patches; i++)
        if (x->patch[i] != 0)
            return false;
    return true;
}

murk_sums murk_vector_sums(const murk_system *system, const murk_vector *r, const murk_vector *z)
{
    double rr[PARTS], rz[PARTS], z2[PARTS], patch_rr = 0, patch_rz = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        rr[n] = rz[n] = z2[n] = 0;
        for (size_t i = part(system, n); i < part(system, n + 1); i++) {
            double weight = zone_weight(system, i), u = r->zone[i], v = z->zone[i];
            rr[n] += weight * u * u;
            rz[n] += weight * u * v;
            z2[n] += system->medium->kappa_t[i] * v * v;
        }
    }
    for (size_t i = 0; i < system->patches; i++) {
        double weight = patch_weight(system, i) * r->patch[i];
        patch_rr += weight * r->patch[i];
        patch_rz += weight * z->patch[i];
    }
    patch_rr += slope_product(system, r->slope, r->slope);
    patch_rz += slope_product(system, r->slope, z->slope);
    return (murk_sums){sum_of(rr) + patch_rr, sum_of(rz) + patch_rz,
                       sum_of(z2) * system->medium->grid->volume};
}

double murk_vector_step(const murk_system *system, double a, const murk_vector *p,
                        const murk_vector *q, murk_vector *x, murk_vector *r, double *x2)
{
    const float f = (float)a;
    double xx[PARTS], norm2[PARTS], patches = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (int n = 0; n < PARTS; n++) {
        xx[n] = norm2[n] = 0;
        for (size_t i = part(system, n); i < part(system, n + 1); i++) {
            x->zone[i] += f * p->zone[i];
            r->zone[i] -= f * q->zone[i];
            double u = x->zone[i];
            xx[n] += zone_weight(system, i) * u * u;
            norm2[n] += system->medium->kappa_t[i] * u * u;
        }
    }
    for (size_t i = 0; i < system->slopes; i++) {
        x->slope[i] += f * p->slope[i];
        r->slope[i] -= f * q->slope[i];
    }
    for (size_t i = 0; i < system->patches; i++) {
        x->patch[i] += f * p->patch[i];
        r->patch[i] -= f * q->patch[i];
        patches += patch_weight(system, i) * x->patch[i] * x->patch[i];
    }
    *x2 = sum_of(norm2) * system->medium->grid->volume;
    return sum_of(xx) + slope_product(system, x->slope, x->slope) + patches;
}

/* ---- the system ---------------------------------------------------------------------------- */

/* From what has arrived in y to L x. The operator gives G/4 - x: the difference is exact where the
   two almost cancel. */
static void finish_product(const murk_system *system, const murk_vector *x, murk_vector *y)
{
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] = -murk_system_left(system, i, 0, y->zone[i], x->zone[i]);
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t j = 0; j < system->slopes; j++)
        y->slope[j] =
            -murk_system_left(system, murk_bent_slot(system->bent, j), 0, y->slope[j], x->slope[j]);
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] = x->patch[i] - system->ground->reflectance[i] * y->patch[i];
}

murk_status murk_system_apply(const murk_application *of, int bands)
{
    const murk_system *system = of->system;
    murk_radiosity in[MURK_MOST_BANDS] = {{0}};
    murk_incident out[MURK_MOST_BANDS];
    for (int b = 0; b < bands; b++) {
        in[b] = murk_system_sent(of[b].system, of[b].x);
        out[b] = murk_system_arriving(of[b].system, of[b].y);
    }
    murk_status status = murk_apply(system->context, system->method, system->state, in, out, bands);
    for (int b = 0; !status && b < bands; b++)
        finish_product(of[b].system, of[b].x, of[b].y);
    return status;
}
