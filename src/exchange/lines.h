/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange by lines: the factors of [BG91] eqs. (3)-(5) as a quadrature over lines of sight. */
#ifndef MURK_EXCHANGE_LINES_H
#define MURK_EXCHANGE_LINES_H

#include "medium.h"
#include "murk/exchange.h"
#include "sweep.h"

extern const murk_exchange_method murk_exchange_lines;

/* The same operator on any grid with a kappa_t field, not only on a medium's zones: for results in
   the margin. directions is rounded up to whole orbits; rays counts per face and axis; another set
   is the same directions with lines elsewhere. */
typedef struct murk_lines murk_lines;

murk_status murk_lines_create(murk_context *context, const murk_grid *grid, const float *kappa_t,
                              const murk_ground *ground, int directions, int rays, int set,
                              murk_lines **out);
void murk_lines_release(murk_lines *lines);
const char *murk_lines_kernel(const murk_lines *lines);

const murk_traced *murk_lines_traced(const murk_lines *lines);
/* As murk_sweep_bend(), murk_sweep_limit(). */
void murk_lines_bend(murk_lines *lines, const murk_bent *bent);
void murk_lines_limit(murk_lines *lines, const murk_region *region);

/* As exchange.h says, for 1 ... MURK_MOST_BANDS bands at once; zone and patch of out may be NULL
   where they are not wanted, in all bands alike. In active slots without extinction out->zone is
   G/4. */
murk_status murk_lines_apply(murk_context *context, murk_lines *lines, const murk_radiosity *in,
                             murk_incident *out, int bands);

#endif
