/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange factors between zones that are several zones apart. */
#ifndef MURK_EXCHANGE_FACTOR_FAR_H
#define MURK_EXCHANGE_FACTOR_FAR_H

#include "sight.h"

/* The integral of 1 / (pi r^2) over two boxes at a distance that is large against them [m^4];
   offset between their middles [m]. */
double murk_far_geometry(const double size[3], const double offset[3]);

/* The mean attenuation between the zones at cells m and k: tau between them, times the share that
   escapes each along its own chord. Times kappa_m kappa_k and the geometry it is the factor. */
double murk_far_attenuation(const murk_sight *sight, const int32_t m[3], const int32_t k[3],
                            double kappa_m, double kappa_k);

#endif
