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

/* Splits b into its part on rows without scattering, where x = b, and the rest; one is 1 there.
   False where there is no first part. */
static bool split(const murk_system *system, const murk_vector *b, murk_vector *fixed,
                  murk_vector *free, murk_vector *one)
{
    const murk_medium *medium = system->medium;
    bool any = false;
    for (size_t i = 0; i < system->slots; i++) {
        bool scatters = medium->kappa_t[i] > 0 && murk_value(&medium->albedo, i) > 0;
        fixed->zone[i] = scatters ? 0 : b->zone[i];
        free->zone[i] = scatters ? b->zone[i] : 0;
        one->zone[i] = scatters;
        any = any || fixed->zone[i] != 0;
    }
    for (size_t i = 0; i < system->patches; i++) {
        bool reflects = system->ground->reflectance[i] > 0;
        fixed->patch[i] = reflects ? 0 : b->patch[i];
        free->patch[i] = reflects ? b->patch[i] : 0;
        one->patch[i] = reflects;
        any = any || fixed->patch[i] != 0;
    }
    return any;
}

/* Sets x to the best start in the span of b and 1 and r to b - L x; p, q, s are work space. */
static murk_status start(murk_system *system, const murk_vector *b, murk_vector *x, murk_vector *r,
                         murk_vector *p, murk_vector *q, murk_vector *s)
{
    murk_status status = MURK_OK;
    murk_vector_copy(system, b, r);
    if (split(system, b, x, p, s)) {
        status = murk_system_apply(system, x, q);
        if (status)
            return status;
        murk_vector_add(system, -1, q, r); /* what b and 1 have to make up for */
    }
    double rb = murk_vector_product(system, r, p), r1 = murk_vector_product(system, r, s);
    status = murk_system_apply(system, p, q);
    if (status)
        return status;
    double bb = murk_vector_product(system, p, q), b1 = murk_vector_product(system, s, q);
    status = murk_system_apply(system, s, x); /* x is free: its two parts are b and b - p */
    if (status)
        return status;
    double one = murk_vector_product(system, s, x), determinant = bb * one - b1 * b1;
    double cb = 1, c1 = 0;
    if (bb > 0 && one > 0 && determinant > 1e-6 * bb * one) {
        cb = (rb * one - r1 * b1) / determinant;
        c1 = (r1 * bb - rb * b1) / determinant;
    }
    murk_vector_add(system, -cb, q, r);
    murk_vector_add(system, -c1, x, r);
    murk_vector_copy(system, b, x);
    murk_vector_add(system, cb - 1, p, x);
    murk_vector_add(system, c1, s, x);
    return MURK_OK;
}

murk_status murk_conjugate_gradients(murk_system *system, const murk_vector *b, murk_vector *x,
                                     double relative, double absolute, int max_iterations,
                                     murk_cg_result *result)
{
    murk_vector r = {0}, p = {0}, q = {0}, s = {0};
    murk_lanczos lanczos = {0};
    murk_status status = murk_vector_create(system, &r);
    if (!status)
        status = murk_vector_create(system, &p);
    if (!status)
        status = murk_vector_create(system, &q);
    if (!status)
        status = murk_vector_create(system, &s);
    lanczos.diagonal = murk_alloc((size_t)max_iterations, sizeof(double));
    lanczos.off = murk_alloc((size_t)max_iterations, sizeof(double));
    if (!status && (!lanczos.diagonal || !lanczos.off))
        status = murk_fail(system->context, MURK_ERROR_MEMORY, "out of memory");
    if (status)
        goto done;

    status = start(system, b, x, &r, &p, &q, &s);
    if (status)
        goto done;
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
    murk_vector_clear(&s);
    murk_free(lanczos.diagonal);
    murk_free(lanczos.off);
    return status;
}
