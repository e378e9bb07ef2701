/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_CONJUGATE_GRADIENTS_H
#define MURK_SOLVE_CONJUGATE_GRADIENTS_H

#include "system.h"

typedef struct murk_cg_result {
    int iterations;
    double residual; /* norm of b - L x over that of x, in the system's inner product */
    double error;    /* estimated error of x, as the root of murk_vector_norm2() */
    double norm;     /* of x, likewise */
} murk_cg_result;

typedef struct murk_cg {
    murk_system *system;
    const murk_vector *b;
    murk_vector *x;
    double relative, absolute;
    murk_cg_result result;
} murk_cg;

/*
 * Solves L x = b by conjugate gradients in the system's inner product, until the error estimate is
 * below `absolute` or `relative` times the norm of x (both as the root of murk_vector_norm2()), or
 * after max_iterations. The first solve of a system starts from the best constant (the solution in
 * an isothermal enclosure); it also tells whether light stays so long that the preconditioner pays,
 * which is then made and kept in the system. Solves that follow are corrections and start from 0.
 * Up to MURK_MOST_BANDS systems over one operator take their steps together, each for as long as it
 * needs to.
 */
murk_status murk_conjugate_gradients(murk_cg *of, int bands, int max_iterations);

#endif
