/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange factors between zones and ground patches, in any position and medium. */
#ifndef MURK_EXCHANGE_FACTOR_PATCH_H
#define MURK_EXCHANGE_FACTOR_PATCH_H

#include "sight.h"

/* V_kS_i of [BG91] eqs. (4), (6) for the zone at a cell, all of it above the ground, and a patch of
   sight->ground [m^2]. */
double murk_patch_factor(const murk_sight *sight, const int32_t cell[3], double kappa,
                         size_t patch);

#endif
