/* SPDX-License-Identifier: Apache-2.0 */
#include "statistics.h"

#include <math.h>
#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_quantile(double *values, size_t count, double part)
{
    for (size_t i = 0; i < count; i++)
        if (isnan(values[i]))
            return NAN;
    if (count == 0)
        return NAN;
    qsort(values, count, sizeof *values, compare);
    double at = part * (double)(count - 1);
    size_t low = (size_t)at, high = low + 1 < count ? low + 1 : low;
    return values[low] + (at - (double)low) * (values[high] - values[low]);
}

double bench_median(double *values, size_t count)
{
    return bench_quantile(values, count, 0.5);
}

double bench_power(const double *x, const double *y, size_t count)
{
    double n = (double)count, u = 0, v = 0, uu = 0, uv = 0;
    for (size_t i = 0; i < count; i++) {
        if (!(x[i] > 0) || !(y[i] > 0))
            return NAN;
        u += log(x[i]) / n;
        v += log(y[i]) / n;
    }
    for (size_t i = 0; i < count; i++) {
        uu += pow(log(x[i]) - u, 2);
        uv += (log(x[i]) - u) * (log(y[i]) - v);
    }
    return uu > 0 ? uv / uu : NAN;
}
