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
    murk_cg *of;
    murk_system *system;
    murk_vector r, p, q; /* residual, direction, L p and then the preconditioned residual */
    murk_lanczos lanczos;
    bool preconditioned;
    double least;   /* eigenvalue of the preconditioned operator, or a bound from above */
    murk_sums sums; /* over r and z = P^-1 r */
    double xx, x2;  /* <x, x>, norm2 of x */
    bool waits;     /* for L times a vector */
    bool done;
} murk_gradients;

/* Sets q = L p, or L x, for the bands that wait for it. */
static murk_status apply(murk_gradients *g, int bands, bool to_x)
{
    murk_application of[MURK_MOST_BANDS];
    int count = 0;
    for (int b = 0; b < bands; b++)
        if (g[b].waits)
            of[count++] = (murk_application){g[b].system, to_x ? g[b].of->x : &g[b].p, &g[b].q};
    return count ? murk_system_apply(of, count) : MURK_OK;
}

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

/* x + c p where c makes the error least, from q = L p. */
static void add_best_constant(murk_gradients *g)
{
    g->system->escape = escape_of(g->system, &g->p, &g->q);
    double lost = murk_vector_product(g->system, &g->p, &g->q);
    if (!(lost > 0))
        return;
    double c = murk_vector_product(g->system, &g->p, &g->r) / lost;
    murk_vector_add(g->system, c, &g->p, g->of->x);
    murk_vector_add(g->system, -c, &g->q, &g->r);
}

/* Sets x to where the iteration begins and r to b - L x. */
static murk_status start(murk_gradients *g, int bands)
{
    for (int b = 0; b < bands; b++) {
        murk_vector_copy(g[b].system, g[b].of->b, &g[b].r);
        g[b].waits = split(g[b].system, g[b].of->b, g[b].of->x, &g[b].p);
    }
    murk_status status = apply(g, bands, true);
    for (int b = 0; !status && b < bands; b++) {
        if (g[b].waits)
            murk_vector_add(g[b].system, -1, &g[b].q, &g[b].r);
        bool scatters = any_scatters(g[b].system, &g[b].p);
        if (!scatters) {
            murk_vector_add(g[b].system, 1, &g[b].r, g[b].of->x);
            murk_vector_add(g[b].system, -1, &g[b].r, &g[b].r);
        }
        g[b].waits = scatters && !(g[b].system->escape > 0);
    }
    if (!status)
        status = apply(g, bands, false);
    for (int b = 0; !status && b < bands; b++)
        if (g[b].waits)
            add_best_constant(&g[b]);
    return status;
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

/* One step along p, from q = L p. */
static void step(murk_gradients *g)
{
    double pq = murk_vector_product(g->system, &g->p, &g->q), before = g->sums.rz;
    g->done = !(pq > 0 && before > 0); /* the residual has come down to rounding */
    if (g->done)
        return;
    g->xx = murk_vector_step(g->system, before / pq, &g->p, &g->q, g->of->x, &g->r, &g->x2);
    const murk_vector *z = precondition(g);
    double ratio = fmax(0, g->sums.rz / before);
    murk_lanczos_add(&g->lanczos, before / pq, ratio);
    g->least = murk_lanczos_least(&g->lanczos, g->least);
    murk_vector_turn(g->system, z, ratio, &g->p);
    g->of->result.iterations++;
}

static void begin(murk_gradients *g)
{
    g->least = g->system->escape > 0 ? g->system->escape : 1; /* 1: nothing scatters */
    g->xx = murk_vector_product(g->system, g->of->x, g->of->x);
    g->x2 = murk_vector_norm2(g->system, g->of->x);
    murk_vector_copy(g->system, precondition(g), &g->p);
    g->of->result = (murk_cg_result){0};
}

/* Takes stock before a step: whether it is wanted, and with the preconditioner from now on. */
static murk_status judge(murk_gradients *g, int max_iterations)
{
    murk_cg_result *result = &g->of->result;
    /* Preconditioned, z is about the error itself; else the bound holds for z = r. */
    result->residual = g->xx > 0 ? sqrt(g->sums.rr / g->xx) : 0;
    result->error = sqrt(g->sums.z2) / g->least;
    result->norm = sqrt(g->x2);
    double goal = fmax(g->of->relative * result->norm, g->of->absolute);
    g->done = g->sums.rr <= FLOOR * FLOOR * g->xx || result->iterations == max_iterations ||
              (result->iterations > 1 && result->error <= goal);
    bool far = !result->iterations || result->error > WORTH * goal;
    bool slow = g->least < SLOW || g->system->preconditioner;
    return !g->done && !g->preconditioned && slow && far ? turn_preconditioned(g) : MURK_OK;
}

static murk_status iterate(murk_gradients *g, int bands, int max_iterations)
{
    murk_status status = MURK_OK;
    for (int b = 0; b < bands; b++)
        begin(&g[b]);
    for (bool any = true; !status && any;) {
        any = false;
        for (int b = 0; !status && b < bands; b++) {
            if (!g[b].done)
                status = judge(&g[b], max_iterations);
            g[b].waits = !g[b].done;
            any = any || g[b].waits;
        }
        if (!status)
            status = apply(g, bands, false);
        for (int b = 0; !status && b < bands; b++)
            if (g[b].waits)
                step(&g[b]);
    }
    return status;
}

murk_status murk_conjugate_gradients(murk_cg *of, int bands, int max_iterations)
{
    murk_gradients g[MURK_MOST_BANDS] = {{0}};
    murk_status status = MURK_OK;
    for (int b = 0; !status && b < bands; b++) {
        murk_vector *vectors[] = {&g[b].r, &g[b].p, &g[b].q};
        g[b].of = &of[b];
        g[b].system = of[b].system;
        status = murk_lanczos_create(of[b].system->context, max_iterations, &g[b].lanczos);
        for (int i = 0; !status && i < 3; i++)
            status = murk_vector_create(of[b].system, vectors[i]);
    }
    if (!status)
        status = start(g, bands);
    if (!status)
        status = iterate(g, bands, max_iterations);
    for (int b = 0; b < bands; b++) {
        murk_vector_clear(&g[b].r);
        murk_vector_clear(&g[b].p);
        murk_vector_clear(&g[b].q);
        murk_lanczos_clear(&g[b].lanczos);
    }
    return status;
}
