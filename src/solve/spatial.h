/* SPDX-License-Identifier: Apache-2.0 */
/* How large the error of a source is that is constant, or linear, within zones: estimates from
   which zones get slopes and whether that is enough (EQUATIONS.md, "Sources that vary within a
   zone"). */
#ifndef MURK_SOLVE_SPATIAL_H
#define MURK_SOLVE_SPATIAL_H

#include "system.h"

/* Relative error of B [1] in a zone of so many optical depths an edge with a constant source. */
double murk_spatial_flat(double depth);

/* An upper estimate of the relative error of x, with slopes, in the norm of the tolerance, from how
   its source leaps from zone to zone and how it falls off at rims. direct is what beam and emission
   alone bring about. */
double murk_spatial_linear(const murk_system *system, const murk_vector *x,
                           const murk_vector *direct);

#endif
