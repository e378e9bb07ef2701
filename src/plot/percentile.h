/* SPDX-License-Identifier: Apache-2.0 */
/* Order statistics of floats without sorting them. */
#ifndef MURK_PLOT_PERCENTILE_H
#define MURK_PLOT_PERCENTILE_H

#include <stddef.h>

/* The smallest of the finite values (every stride-th of count) that at least a part in [0, 1] of
   them do not exceed; NaN where none is finite. Exact, in time proportional to count. */
double murk_percentile(const float *values, size_t count, size_t stride, double part);

#endif
