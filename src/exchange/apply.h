/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_EXCHANGE_APPLY_H
#define MURK_EXCHANGE_APPLY_H

#include "murk/exchange.h"

/* out = G in for any number of bands, as many at a time as an operator takes. */
murk_status murk_apply(murk_context *context, const murk_exchange_method *method, void *state,
                       const murk_radiosity *in, murk_incident *out, int bands);

#endif
