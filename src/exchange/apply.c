/* SPDX-License-Identifier: Apache-2.0 */
#include "apply.h"

murk_status murk_apply(murk_context *context, const murk_exchange_method *method, void *state,
                       const murk_radiosity *in, murk_incident *out, int bands)
{
    murk_status status = MURK_OK;
    for (int b = 0; !status && b < bands; b += MURK_MOST_BANDS) {
        int now = bands - b < MURK_MOST_BANDS ? bands - b : MURK_MOST_BANDS;
        status = method->apply(context, state, in + b, out + b, now);
    }
    return status;
}
