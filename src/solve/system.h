/* SPDX-License-Identifier: Apache-2.0 */
/* The linear system of [BG91] eqs. (1), (2) over an exchange operator. */
#ifndef MURK_SOLVE_SYSTEM_H
#define MURK_SOLVE_SYSTEM_H

#include "bent.h"
#include "ground.h"
#include "medium.h"
#include "murk/exchange.h"

/* Radiosities of zones (a field on the medium's grid), their slopes (a field over the bent bricks,
   if there are any) and patches (NULL without ground). */
typedef struct murk_vector {
    float *zone;
    float *slope;
    float *patch;
} murk_vector;

typedef struct murk_preconditioner murk_preconditioner;

/*
 * L x = b with (L x)_k = x_k - albedo_k (G x)_k / 4 for zones and x_i - rho_i H_i for patches. L is
 * self-adjoint and positive definite in the inner product
 *     <u, v> = sum 4 kappa V / albedo u v + sum A / rho u v,
 * over the zones with albedo > 0 and the patches with rho > 0; elsewhere L is the identity. Slopes
 * have equations of the same form, and 1/12 of their zone's weight: the mean of p^2 over it.
 */
typedef struct murk_system {
    murk_context *context;
    const murk_exchange_method *method;
    void *state;
    const murk_medium *medium;
    const murk_ground *ground;
    const murk_bent *bent; /* NULL: sources are constant within zones */
    size_t slots, slopes, patches;
    /* From the first solve on, for those that follow: the part of a uniform light that zones absorb
       or let escape at once, and the preconditioner where it was made (the owner's to release). */
    double escape;
    murk_preconditioner *preconditioner;
} murk_system;

murk_status murk_vector_create(const murk_system *system, murk_vector *out);
void murk_vector_clear(murk_vector *vector);
void murk_vector_copy(const murk_system *system, const murk_vector *from, murk_vector *to);
/* y += a x */
void murk_vector_add(const murk_system *system, double a, const murk_vector *x, murk_vector *y);
/* y = x + a y */
void murk_vector_turn(const murk_system *system, const murk_vector *x, double a, murk_vector *y);
/* Sums are the same for any number of threads. */
double murk_vector_product(const murk_system *system, const murk_vector *x, const murk_vector *y);
/* Sum of kappa_t V x^2 over the zones: the norm that the tolerance is about, squared. */
double murk_vector_norm2(const murk_system *system, const murk_vector *x);

bool murk_vector_zero(const murk_system *system, const murk_vector *x);

/* Sums that an iteration needs at a time: <r, r>, <r, z>, and the norm2 of z. */
typedef struct murk_sums {
    double rr, rz, z2;
} murk_sums;

murk_sums murk_vector_sums(const murk_system *system, const murk_vector *r, const murk_vector *z);
/* x += a p and r -= a q; gives <x, x> and sets *x2 to the norm2 of x. */
double murk_vector_step(const murk_system *system, double a, const murk_vector *p,
                        const murk_vector *q, murk_vector *x, murk_vector *r, double *x2);

/* What is left of the equation of a zone, or of one of its slopes: b - L x, of its value x, what
   beam and emission give it, and the net G/4 - x that arrives. 0 where there is no zone. */
static inline float murk_system_left(const murk_system *system, size_t slot, float direct,
                                     float net, float x)
{
    float albedo = murk_value(&system->medium->albedo, slot);
    return system->medium->kappa_t[slot] > 0 ? direct + albedo * net - (1 - albedo) * x : 0;
}

/* What x sends, and where its light arrives in y, for the operator. */
static inline murk_radiosity murk_system_sent(const murk_system *system, const murk_vector *x)
{
    return (murk_radiosity){.zone = x->zone,
                            .slope = system->slopes ? x->slope : NULL,
                            .patch = system->ground ? x->patch : NULL};
}

static inline murk_incident murk_system_arriving(const murk_system *system, const murk_vector *y)
{
    return (murk_incident){.zone = y->zone,
                           .slope = system->slopes ? y->slope : NULL,
                           .patch = system->ground ? y->patch : NULL};
}

typedef struct murk_application {
    murk_system *system;
    const murk_vector *x;
    murk_vector *y;
} murk_application;

/* y = L x for up to MURK_MOST_BANDS systems over one operator, which is applied to all at once. */
murk_status murk_system_apply(const murk_application *of, int bands);

#endif
