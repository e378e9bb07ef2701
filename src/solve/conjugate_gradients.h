/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_CONJUGATE_GRADIENTS_H
#define MURK_SOLVE_CONJUGATE_GRADIENTS_H

#include "system.h"

typedef struct murk_cg_result {
    int iterations;
    double residual; /* norm of b - L x, in the system's inner product */
    double error;    /* bound on the error of x in that norm: residual over the least eigenvalue */
    double norm;     /* of x */
} murk_cg_result;

/*
 * Solves L x = b by conjugate gradients in the system's inner product, from the best combination of
 * b (the solution without multiple scattering) and a constant (the solution in an isothermal
 * enclosure, and the slowest part of the error in a thick medium), until the error
 * estimate is below `absolute` or `relative` times the norm of x, or after max_iterations.
 */
murk_status murk_conjugate_gradients(murk_system *system, const murk_vector *b, murk_vector *x,
                                     double relative, double absolute, int max_iterations,
                                     murk_cg_result *result);

#endif
