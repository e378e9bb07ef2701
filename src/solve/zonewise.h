/* SPDX-License-Identifier: Apache-2.0 */
/* Errors zone by zone. */
#ifndef MURK_SOLVE_ZONEWISE_H
#define MURK_SOLVE_ZONEWISE_H

#include "medium.h"

/* The 95th percentile over the zones of |change / value|, within 9 %. The tolerance allows it five
   times as much as the norm. */
double murk_zonewise_change(const murk_medium *medium, const float *change, const float *value);

#endif
