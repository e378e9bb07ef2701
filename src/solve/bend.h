/* SPDX-License-Identifier: Apache-2.0 */
/* Which bricks need sources that vary within their zones. */
#ifndef MURK_SOLVE_BEND_H
#define MURK_SOLVE_BEND_H

#include "bent.h"
#include "medium.h"
#include "murk/exchange.h"

/* The bricks that would bring an error of more than `allowed` [1] all together if their sources
   were constant within zones: those that err most first, but for opaque ones, which it
   would not help. On a grid that holds brick b of the medium
   as map[b], too. */
typedef struct murk_bend {
    murk_bent zones, there;
} murk_bend;

/* For media that share kappa_t: within what is allowed for each, and flat[] is the relative error
   in each of what is left constant. */
murk_status murk_bend_create(murk_context *context, const murk_medium *const medium[], int count,
                             double allowed, const murk_grid *grid, const int32_t *map,
                             double flat[], murk_bend *out);
void murk_bend_clear(murk_bend *bend);

#endif
