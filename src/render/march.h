/* SPDX-License-Identifier: Apache-2.0 */
/* [BG91] eq. (11) along rays. */
#ifndef MURK_RENDER_MARCH_H
#define MURK_RENDER_MARCH_H

#include "march_kernel.h"
#include "solution.h"

/* The medium, and the function that this processor marches with. */
typedef struct murk_march {
    murk_marched medium;
    murk_march_fn *run;
    float *blocks; /* owned, as is box */
    murk_box *box;
} murk_march;

murk_status murk_march_create(murk_context *context, const murk_solution *solution,
                              murk_march *out);
void murk_march_clear(murk_march *march);

/* The same march through what the zones radiate by themselves, (1 - albedo) E in place of B. It
   borrows from the first all but its blocks. */
murk_status murk_march_glow(murk_context *context, const murk_solution *solution,
                            const murk_march *march, murk_march *out);

/* Light from the bricks, given front to back, into the packet, and its steps into the trace. False
   when memory runs out. */
bool murk_march_light(const murk_march *march, const int32_t *brick, size_t count,
                      murk_packet *packet, murk_trace *trace);

void murk_trace_clear(murk_trace *trace);

/* Where the ray of a lane has passed half of its depth [m]; INFINITY if there is none. */
double murk_trace_half(const murk_trace *trace, int lane, double depth);

#endif
