/* SPDX-License-Identifier: Apache-2.0 */
#include "reduce.h"

#include <math.h>

static float reduced_albedo(double albedo, double part)
{
    return (float)(albedo * (1 - part) / (1 - albedo * part));
}

murk_status murk_medium_reduce(murk_context *context, const murk_medium *medium, double part,
                               murk_medium **out)
{
    const size_t slots = medium->grid->brick_count * MURK_BRICK_SLOTS;
    murk_medium *reduced = murk_alloc(1, sizeof *reduced);
    float *kappa_t = murk_alloc(slots, sizeof *kappa_t);
    float *albedo = medium->albedo.field ? murk_alloc(slots, sizeof *albedo) : NULL;
    if (!reduced || !kappa_t || (medium->albedo.field && !albedo)) {
        murk_free(reduced);
        murk_free(kappa_t);
        murk_free(albedo);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                         medium->grid->zone_count);
    }
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t i = 0; i < slots; i++) {
        double of = murk_value(&medium->albedo, i);
        kappa_t[i] = (float)fmin(medium->kappa_t[i] * (1 - of * part), 3e38);
        if (albedo)
            albedo[i] = reduced_albedo(of, part);
    }
    *reduced = *medium;
    reduced->references = 1;
    reduced->asymmetry = 0;
    reduced->whole = murk_medium_share(medium);
    reduced->kappa_t = kappa_t;
    reduced->albedo = (murk_values){albedo, reduced_albedo(medium->albedo.constant, part)};
    *out = reduced;
    return MURK_OK;
}
