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
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] += f * x->zone[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] += f * x->patch[i];
}

void murk_vector_turn(const murk_system *system, const murk_vector *x, double a, murk_vector *y)
{
    float f = (float)a;
    for (size_t i = 0; i < system->slots; i++)
        y->zone[i] = x->zone[i] + f * y->zone[i];
    for (size_t i = 0; i < system->patches; i++)
        y->patch[i] = x->patch[i] + f * y->patch[i];
}

double murk_vector_product(const murk_system *system, const murk_vector *x, const murk_vector *y)
{
    const murk_medium *medium = system->medium;
    double volume = 4 * medium->grid->volume, sum = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static) reduction(+ : sum)
    for (size_t i = 0; i < system->slots; i++) {
        float albedo = murk_value(&medium->albedo, i);
        if (albedo > 0)
            sum += volume * medium->kappa_t[i] / albedo * x->zone[i] * y->zone[i];
    }
    for (size_t i = 0; i < system->patches; i++)
        if (system->ground->reflectance[i] > 0)
            sum += murk_ground_area(system->ground, i) / system->ground->reflectance[i] *
                   x->patch[i] * y->patch[i];
    return sum;
}

double murk_vector_norm2(const murk_system *system, const murk_vector *x)
{
    const murk_medium *medium = system->medium;
    double sum = 0;
#pragma omp parallel for num_threads(system->context->threads) schedule(static) reduction(+ : sum)
    for (size_t i = 0; i < system->slots; i++)
        sum += (double)medium->kappa_t[i] * x->zone[i] * x->zone[i];
    return sum * medium->grid->volume;
}

bool murk_vector_zero(const murk_system *system, const murk_vector *x)
{
    for (size_t i = 0; i < system->slots; i++)
        if (x->zone[i] != 0)
            return false;
    for (size_t i = 0; i < system->patches; i++)
        if (x->patch[i] != 0)
            return false;
    return true;
}

murk_status murk_system_apply(murk_system *system, const murk_vector *x, murk_vector *y)
{
    const murk_medium *medium = system->medium;
    const murk_radiosity in = {.zone = x->zone, .patch = system->ground ? x->patch : NULL};
    murk_incident out = {.zone = y->zone, .patch = system->ground ? y->patch : NULL};
    murk_status status = system->method->apply(system->context, system->state, &in, &out, 1);
    if (status)
        return status;
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

murk_status murk_system_residual(murk_system *system, const murk_vector *direct,
                                 const murk_around *around, const murk_vector *x, murk_vector *r,
                                 murk_vector *scratch, double *diffuse)
{
    const murk_medium *medium = system->medium;
    bool ground = system->ground;
    const float *patch = x && ground ? x->patch : NULL;
    const murk_radiosity in[2] = {{x ? x->zone : NULL, patch, around->sky, around->horizon},
                                  {NULL, patch, around->sky, around->horizon}};
    murk_incident out[2] = {{.zone = r->zone, .patch = ground ? r->patch : NULL}};
    if (diffuse)
        out[1] = (murk_incident){.zone = scratch->zone, .patch = ground ? scratch->patch : NULL};
    murk_status status =
        system->method->apply(system->context, system->state, in, out, diffuse ? 2 : 1);
    if (status)
        return status;
    if (diffuse)
        *diffuse = out[1].net_power;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++) {
        float albedo = murk_value(&medium->albedo, i), value = x ? x->zone[i] : 0;
        r->zone[i] = medium->kappa_t[i] > 0
                         ? direct->zone[i] + albedo * r->zone[i] - (1 - albedo) * value
                         : 0;
    }
    for (size_t i = 0; i < system->patches; i++)
        r->patch[i] =
            direct->patch[i] + system->ground->reflectance[i] * r->patch[i] - (x ? x->patch[i] : 0);
    return MURK_OK;
}
