/* SPDX-License-Identifier: Apache-2.0 */
/* The iteration of the paper. */
#ifndef MURK_SOLVE_GAUSS_SEIDEL_H
#define MURK_SOLVE_GAUSS_SEIDEL_H

#include "ground.h"
#include "medium.h"
#include "murk/exchange.h"

/*
 * Solves for the radiosities of all zones and patches by Gauss-Seidel sweeps, [BG91] eqs. (7), (8),
 * until no radiosity changes by epsilon [W/m^2] or more, eqs. (9), (10).
 *
 * Elements are numbered as in the method's row(): zones, then patches. source is what each would
 * have without exchange: (1 - albedo) E + albedo (beam + sky + horizon) / 4 of a zone, E + rho
 * (sun + sky) of a patch. x holds the start and then the radiosities. *iterations counts the sweeps
 * and *change is the largest change of the last; it is not below epsilon where max_iterations came
 * first. Fails for a method without rows.
 */
murk_status murk_gauss_seidel(murk_context *context, const murk_exchange_method *method,
                              void *state, const murk_medium *medium, const murk_ground *ground,
                              const double *source, double epsilon, int max_iterations, double *x,
                              int *iterations, double *change);

#endif
