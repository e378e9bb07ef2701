/* SPDX-License-Identifier: Apache-2.0 */
/* The coefficients of conjugate gradients are a Lanczos tridiagonal matrix of the operator, whose
   eigenvalues approach those that matter for this right-hand side. */
#ifndef MURK_SOLVE_LANCZOS_H
#define MURK_SOLVE_LANCZOS_H

#include "context.h"

typedef struct murk_lanczos {
    int count;
    double *diagonal, *off; /* off[i] couples i and i + 1 */
    double last_a, last_b;
} murk_lanczos;

murk_status murk_lanczos_create(murk_context *context, int most, murk_lanczos *out);
void murk_lanczos_clear(murk_lanczos *lanczos);

/* Adds a step: a its length, b what of this direction went into the next. */
void murk_lanczos_add(murk_lanczos *lanczos, double a, double b);

/* The least eigenvalue to 1 %, or `most` where none lies below that. */
double murk_lanczos_least(const murk_lanczos *lanczos, double most);

#endif
