/* SPDX-License-Identifier: Apache-2.0 */
/* Apparent temperatures of many radiances of one band. */
#ifndef MURK_BAND_APPARENT_H
#define MURK_BAND_APPARENT_H

#include "murk/band.h"

enum { MURK_APPARENT_NODES = 1024 };

/* 1 / T over the logarithm of the radiance, almost a straight line, by cubics between nodes where
   value and slope are exact. */
typedef struct murk_apparent {
    double low, step; /* logarithm of the first node's radiance, and from node to node */
    double inverse[MURK_APPARENT_NODES], slope[MURK_APPARENT_NODES]; /* 1 / T, and its change */
} murk_apparent;

/* For radiances from low > 0 to high: to 6e-8, as floats are, over 30 decades. */
void murk_apparent_init(const murk_band *band, double low, double high, murk_apparent *out);

/* What murk_planck_temperature() would give. */
double murk_apparent_temperature(const murk_apparent *apparent, double radiance);

#endif
