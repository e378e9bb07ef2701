/* SPDX-License-Identifier: Apache-2.0 */
/* Planck's radiance with its slope. */
#ifndef MURK_BAND_PLANCK_H
#define MURK_BAND_PLANCK_H

#include "murk/band.h"

/* As murk_planck_radiance(), for a valid band and a temperature above 0; *slope is its derivative
   by temperature. */
double murk_planck_slope(const murk_band *band, double kelvin, double *slope);

#endif
