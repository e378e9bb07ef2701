/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_PRECONDITIONER_H
#define MURK_SOLVE_PRECONDITIONER_H

#include "system.h"

/*
 * An approximate inverse of L: z = r + M W r, with W = 4 kappa V / albedo and M one V-cycle for the
 * diffusion limit C of W L (EQUATIONS.md, "Preconditioner"). r alone is right for the rough part of
 * the error, where a zone's light is scattered among many others, M W r for the smooth one. W L and
 * the inverse are symmetric, so in the system's inner product it is self-adjoint and positive
 * definite.
 */
murk_status murk_preconditioner_create(murk_context *context, const murk_medium *medium,
                                       murk_preconditioner **out);
void murk_preconditioner_release(murk_preconditioner *preconditioner);

/* r is 0 in rows without scattering. */
void murk_preconditioner_apply(murk_preconditioner *preconditioner, const murk_system *system,
                               const murk_vector *r, murk_vector *z);

#endif
