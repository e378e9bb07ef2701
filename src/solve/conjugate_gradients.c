/* SPDX-License-Identifier: Apache-2.0 */
#include "conjugate_gradients.h"

#include <math.h>

/* Vectors are floats: a residual this small relative to x is rounding. */
static const double FLOOR = 1e-7;

/* The coefficients of the iteration are a Lanczos tridiagonal matrix of L, whose eigenvalues
   approach those of L that matter for this right-hand side. */
typedef struct murk_lanczos {
    int count;
    double *diagonal, *off; /* off[i] couples i and i + 1 */
} murk_lanczos;

/* How many eigenvalues lie below x: the negative pivots of T - x (Sturm sequence). */
static int count_below(const murk_lanczos *t, double x)
{
    int below = 0;
    double pivot = 1;
    for (int i = 0; i < t->count; i++) {
        double square = i ? t->off[i - 1] * t->off[i - 1] : 0;
        pivot = t->diagonal[i] - x - square / pivot;
        if (pivot == 0)
            pivot = 1e-300;
        below += pivot < 0;
    }
    return below;
}

/* The least eigenvalue of the tridiagonal matrix to 1 %, in (0, 1] as L's are. */
static double least_eigenvalue(const murk_lanczos *t)
{
    double low = 1e-12, high = 1;
    while (high > 1.01 * low) {
        double middle = sqrt(low * high);
        if (count_below(t, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}

murk_status murk_conjugate_gradients(murk_system *system, const murk_vector *b, murk_vector *x,
                                     double relative, double absolute, int max_iterations,
                                     murk_cg_result *result)
{
    murk_vector r = {0}, p = {0}, q = {0};
    murk_lanczos lanczos = {0};
    murk_status status = murk_vector_create(system, &r);
    if (!status)
        status = murk_vector_create(system, &p);
    if (!status)
        status = murk_vector_create(system, &q);
    lanczos.diagonal = murk_alloc((size_t)max_iterations, sizeof(double));
    lanczos.off = murk_alloc((size_t)max_iterations, sizeof(double));
    if (!status && (!lanczos.diagonal || !lanczos.off))
        status = murk_fail(system->context, MURK_ERROR_MEMORY, "out of memory");
    if (status)
        goto done;

    /* x = b solves the rows without scattering, so that they never enter the iteration. */
    murk_vector_copy(system, b, x);
    status = murk_system_apply(system, x, &q);
    if (status)
        goto done;
    murk_vector_copy(system, b, &r);
    murk_vector_add(system, -1, &q, &r);
    murk_vector_copy(system, &r, &p);
    double rr = murk_vector_product(system, &r, &r), least = 1, last_a = 1, last_b = 0;
    *result = (murk_cg_result){0};
    for (;;) {
        result->residual = sqrt(rr);
        result->error = result->residual / least;
        result->norm = sqrt(murk_vector_product(system, x, x));
        bool settled = result->iterations > 1 || result->residual == 0;
        if (settled && (result->error <= relative * result->norm || result->error <= absolute))
            break;
        if (result->iterations == max_iterations || result->residual <= FLOOR * result->norm)
            break;
        status = murk_system_apply(system, &p, &q);
        if (status)
            goto done;
        double pq = murk_vector_product(system, &p, &q);
        if (!(pq > 0))
            break; /* the residual has come down to rounding */
        double a = rr / pq;
        murk_vector_add(system, a, &p, x);
        murk_vector_add(system, -a, &q, &r);
        double next = murk_vector_product(system, &r, &r), ratio = next / rr;
        int i = result->iterations++;
        lanczos.diagonal[i] = 1 / a + last_b / last_a;
        lanczos.off[i] = sqrt(ratio) / a;
        lanczos.count = i + 1;
        least = least_eigenvalue(&lanczos);
        murk_vector_turn(system, &r, ratio, &p);
        rr = next;
        last_a = a;
        last_b = ratio;
    }
done:
    murk_vector_clear(&r);
    murk_vector_clear(&p);
    murk_vector_clear(&q);
    murk_free(lanczos.diagonal);
    murk_free(lanczos.off);
    return status;
}
