/* SPDX-License-Identifier: Apache-2.0 */
#include "conjugate_gradients.h"

#include "lanczos.h"
#include "preconditioner.h"

#include <math.h>

/* Vectors are floats: a residual this small relative to x is rounding. */
static const double FLOOR = 1e-7;

/* Below this least eigenvalue of L the preconditioner, about a quarter of a sweep of 48 directions,
   saves more than it costs. */
static const double SLOW = 0.25;

/* It is not made in the midst of an iteration that is this close to its goal. */
static const double WORTH = 10;

/* The preconditioned operator's eigenvalues begin below this in every medium with more than one
   optical depth; the first two steps may not have found them yet. */
static const double PRECONDITIONED = 0.5;

typedef struct murk_gradients {
    murk_system *system;
    murk_vector r, p, q; /* residual, direction, L p and then the preconditioned residual */
    murk_lanczos lanczos;
    bool preconditioned;
    double least;   /* eigenvalue of the preconditioned operator, or a bound from above */
    murk_sums sums; /* over r and z = P^-1 r */
    double xx, x2;  /* <x, x>, norm2 of x */
} murk_gradients;

/* ---- the start ----------------------------------------------------------------------------- */

/* Sets x to `from` on rows without scattering, where that is the solution, and to 0 elsewhere; one
   is 1 elsewhere. False where x is 0 everywhere. */
static bool split(const murk_system *system, const murk_vector *from, murk_vector *x,
                  murk_vector *one)
{
    const murk_medium *medium = system->medium;
    bool any = false;
#pragma omp parallel for num_threads(system->context->threads) schedule(static) reduction(|| : any)
    for (size_t i = 0; i < system->slots; i++) {
        bool scatters = medium->kappa_t[i] > 0 && murk_value(&medium->albedo, i) > 0;
        x->zone[i] = scatters ? 0 : from->zone[i];
        one->zone[i] = scatters;
        any = any || x->zone[i] != 0;
    }
    for (size_t j = 0; j < system->slopes; j++) {
        size_t i = murk_bent_slot(system->bent, j);
        x->slope[j] = murk_value(&medium->albedo, i) > 0 ? 0 : from->slope[j];
        one->slope[j] = 0;
        any = any || x->slope[j] != 0;
    }
    for (size_t i = 0; i < system->patches; i++) {
        bool reflects = system->ground->reflectance[i] > 0;
        x->patch[i] = reflects ? 0 : from->patch[i];
        one->patch[i] = reflects;
        any = any || x->patch[i] != 0;
    }
    return any;
}

/* The part of a uniform light that zones absorb or let escape at once, from L 1. Of the zones
   alone: a wide ground would drown them, and no light stays long between patches. */
static double escape_of(const murk_system *system, const murk_vector *one, const murk_vector *l_one)
{
    double all = 0, lost = 0;
    for (size_t i = 0; i < system->slots; i++)
        if (one->zone[i] > 0) {
            all += system->medium->kappa_t[i];
            lost += (double)system->medium->kappa_t[i] * l_one->zone[i];
        }
    return lost > 0 ? lost / all : 1;
}

/* Whether any zone scatters: without one, no light that a patch sends out comes to another. */
static bool any_scatters(const murk_system *system, const murk_vector *one)
{
    for (size_t i = 0; i < system->slots; i++)
        if (one->zone[i] > 0)
            return true;
    return false;
}

/* Sets x to where the iteration begins and r to b - L x. */
static murk_status start(murk_gradients *g, const murk_vector *b, murk_vector *x)
{
    murk_system *system = g->system;
    murk_status status = MURK_OK;
    murk_vector_copy(system, b, &g->r);
    if (split(system, b, x, &g->p)) {
        status = murk_system_apply(system, x, &g->q);
        if (status)
            return status;
        murk_vector_add(system, -1, &g->q, &g->r);
    }
    if (!any_scatters(system, &g->p)) {
        murk_vector_add(system, 1, &g->r, x);
        murk_vector_add(system, -1, &g->r, &g->r);
        return MURK_OK;
    }
    if (system->escape > 0)
        return MURK_OK;
    status = murk_system_apply(system, &g->p, &g->q);
    if (status)
        return status;
    system->escape = escape_of(system, &g->p, &g->q);
    double lost = murk_vector_product(system, &g->p, &g->q);
    if (!(lost > 0))
        return MURK_OK;
    double c = murk_vector_product(system, &g->p, &g->r) / lost;
    murk_vector_add(system, c, &g->p, x);
    murk_vector_add(system, -c, &g->q, &g->r);
    return MURK_OK;
}

/* ---- the iteration ------------------------------------------------------------------------- */

/* Sets z = P^-1 r, as q or r itself, and the sums over it. */
static const murk_vector *precondition(murk_gradients *g)
{
    const murk_vector *z = &g->r;
    if (g->preconditioned) {
        murk_preconditioner_apply(g->system->preconditioner, g->system, &g->r, &g->q);
        z = &g->q;
    }
    g->sums = murk_vector_sums(g->system, &g->r, z);
    return z;
}

/* From here on with the preconditioner. */
static murk_status turn_preconditioned(murk_gradients *g)
{
    murk_system *system = g->system;
    murk_status status = MURK_OK;
    if (!system->preconditioner)
        status =
            murk_preconditioner_create(system->context, system->medium, &system->preconditioner);
    if (status)
        return status;
    g->preconditioned = true;
    g->least = PRECONDITIONED;
    g->lanczos.count = 0;
    murk_vector_copy(system, precondition(g), &g->p);
    return MURK_OK;
}

/* One step along p; false where the residual has come down to rounding. */
static murk_status step(murk_gradients *g, murk_vector *x, bool *done)
{
    murk_status status = murk_system_apply(g->system, &g->p, &g->q);
    if (status)
        return status;
    double pq = murk_vector_product(g->system, &g->p, &g->q), before = g->sums.rz;
    *done = !(pq > 0 && before > 0);
    if (*done)
        return MURK_OK;
    g->xx = murk_vector_step(g->system, before / pq, &g->p, &g->q, x, &g->r, &g->x2);
    const murk_vector *z = precondition(g);
    double ratio = fmax(0, g->sums.rz / before);
    murk_lanczos_add(&g->lanczos, before / pq, ratio);
    g->least = murk_lanczos_least(&g->lanczos, g->least);
    murk_vector_turn(g->system, z, ratio, &g->p);
    return MURK_OK;
}

static murk_status iterate(murk_gradients *g, murk_vector *x, double relative, double absolute,
                           int max_iterations, murk_cg_result *result)
{
    murk_status status = MURK_OK;
    bool done = false;
    g->least = g->system->escape > 0 ? g->system->escape : 1; /* 1: nothing scatters */
    g->xx = murk_vector_product(g->system, x, x);
    g->x2 = murk_vector_norm2(g->system, x);
    murk_vector_copy(g->system, precondition(g), &g->p);
    for (*result = (murk_cg_result){0};; result->iterations++) {
        /* Preconditioned, z is about the error itself; else the bound holds for z = r. */
        result->residual = g->xx > 0 ? sqrt(g->sums.rr / g->xx) : 0;
        result->error = sqrt(g->sums.z2) / g->least;
        result->norm = sqrt(g->x2);
        double goal = fmax(relative * result->norm, absolute);
        if (g->sums.rr <= FLOOR * FLOOR * g->xx || result->iterations == max_iterations ||
            (result->iterations > 1 && result->error <= goal))
            break;
        bool far = !result->iterations || result->error > WORTH * goal;
        bool slow = g->least < SLOW || g->system->preconditioner;
        if (!g->preconditioned && slow && far)
            status = turn_preconditioned(g);
        if (!status)
            status = step(g, x, &done);
        if (status || done)
            break;
    }
    return status;
}

murk_status murk_conjugate_gradients(murk_system *system, const murk_vector *b, murk_vector *x,
                                     double relative, double absolute, int max_iterations,
                                     murk_cg_result *result)
{
    murk_gradients g = {.system = system};
    murk_vector *vectors[] = {&g.r, &g.p, &g.q};
    murk_status status = murk_lanczos_create(system->context, max_iterations, &g.lanczos);
    for (int i = 0; !status && i < 3; i++)
        status = murk_vector_create(system, vectors[i]);
    if (!status)
        status = start(&g, b, x);
    if (!status)
        status = iterate(&g, x, relative, absolute, max_iterations, result);
    for (int i = 0; i < 3; i++)
        murk_vector_clear(vectors[i]);
    murk_lanczos_clear(&g.lanczos);
    return status;
}
