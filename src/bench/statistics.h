/* SPDX-License-Identifier: Apache-2.0 */
/* Numbers out of several measurements. */
#ifndef BENCH_STATISTICS_H
#define BENCH_STATISTICS_H

#include <stddef.h>

/* The median of values, which are sorted on the way; the mean of the two in the middle where their
   number is even. NaN where one of them is. */
double bench_median(double *values, size_t count);

/* Where `part` in [0, 1] of the values, which are sorted on the way, lies below. */
double bench_quantile(double *values, size_t count, double part);

/* The exponent p of y ~ x^p that fits best: least squares of the logarithms. NaN for fewer than two
   different x or values that are not positive. */
double bench_power(const double *x, const double *y, size_t count);

#endif
