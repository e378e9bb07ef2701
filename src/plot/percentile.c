/* SPDX-License-Identifier: Apache-2.0 */
#include "percentile.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { HALF = 1 << 16 };

/* Whole numbers in the order of the floats, and back. */
static uint32_t rank_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

static float value_of(uint32_t rank)
{
    uint32_t bits = rank & 0x80000000u ? rank & 0x7fffffffu : ~rank;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The bin in which the n-th falls, n from 0; n becomes its place in the bin. */
static uint32_t find_bin(const uint32_t bins[HALF], size_t *n)
{
    uint32_t bin = 0;
    while (*n >= bins[bin])
        *n -= bins[bin++];
    return bin;
}

double murk_percentile(const float *values, size_t count, size_t stride, double part)
{
    uint32_t bins[HALF] = {0};
    size_t finite = 0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(values[i * stride])) {
            bins[rank_of(values[i * stride]) >> 16]++;
            finite++;
        }
    if (finite == 0)
        return NAN;
    size_t n = (size_t)fmin((double)finite - 1, fmax(0, ceil(part * (double)finite) - 1));
    uint32_t high = find_bin(bins, &n);
    memset(bins, 0, sizeof bins);
    for (size_t i = 0; i < count; i++)
        if (isfinite(values[i * stride]) && rank_of(values[i * stride]) >> 16 == high)
            bins[rank_of(values[i * stride]) & (HALF - 1)]++;
    return value_of(high << 16 | find_bin(bins, &n));
}
