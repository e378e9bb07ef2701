/* SPDX-License-Identifier: Apache-2.0 */
#include "compare.h"

#include "coarse.h"
#include "quadrature.h"
#include "refine.h"

#include <math.h>

/* What a halving changes under one light it changes under another by at most this much more:
   measured up to 1.2, from the light whose linear estimate is the largest. */
static const double ALIKE = 1.3;

/* Relative difference of the coarse solutions of a level and the next, in the band that is n there
   and m here. */
static murk_status difference(murk_context *context, const murk_compared *of, int m, int n,
                              double *out)
{
    const murk_coarse *here = murk_levels_coarse(of->levels, m);
    const murk_coarse *there = murk_levels_coarse(of->next, n);
    float *mean = murk_alloc(here->system.slots, sizeof *mean);
    if (!mean)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                         here->medium->grid->zone_count);
    murk_refine_average(there->medium->grid, there->x.zone, of->base, here->medium->grid, mean);
    double size = murk_vector_norm2(&here->system, &here->x);
    for (size_t i = 0; i < here->system.slots; i++)
        mean[i] = here->medium->kappa_t[i] > 0 ? mean[i] - here->x.zone[i] : 0;
    double left = murk_vector_norm2(&here->system, &(murk_vector){.zone = mean});
    *out = size > 0 ? sqrt(left / size) : 0;
    murk_free(mean);
    return MURK_OK;
}

/* Both levels have been crossed by the same lines, four to a face here and one to a face there,
   which still feel few lines differently: squares of that fall as 1 / N, so two numbers of
   directions tell it. */
murk_status murk_compare(murk_context *context, const murk_solve_options *options,
                         const murk_compared *of, double out[])
{
    static const int COMPARED[2] = {MURK_ORBIT, 4 * MURK_ORBIT};
    double found[2][MURK_MOST_BANDS] = {{0}};
    murk_status status = MURK_OK;
    for (int n = 0; !status && n < 2; n++) {
        status = murk_levels_probe(of->levels, COMPARED[n], 2 * options->rays);
        if (!status && n)
            status = murk_levels_probe(of->next, COMPARED[n], options->rays);
        for (int b = 0; !status && b < of->next_count; b++)
            status = difference(context, of, of->band < 0 ? b : of->band, b, &found[n][b]);
    }
    for (int b = 0; b < of->next_count; b++) {
        double few = found[0][b] * found[0][b], many = found[1][b] * found[1][b];
        double by_lines = (few - many) / (1.0 / COMPARED[0] - 1.0 / COMPARED[1]);
        out[b] = sqrt(fmax(0.5 * many, many - fmax(0, by_lines) / COMPARED[1]));
    }
    double alone = out[0];
    for (int b = 0; of->band >= 0 && b < of->count; b++)
        out[b] = b == of->band ? alone : ALIKE * alone;
    return status;
}
