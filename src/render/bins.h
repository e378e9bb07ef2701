/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks by where they are seen: lists for the bins of a raster. */
#ifndef MURK_RENDER_BINS_H
#define MURK_RENDER_BINS_H

#include "context.h"

typedef struct murk_bins {
    int count[2];   /* columns, rows */
    size_t *first;  /* count[0] * count[1] + 1: where the list of a bin starts */
    int32_t *brick; /* all lists */
} murk_bins;

/* The bins [low, high] that a brick is seen in; none where low > high on an axis. */
typedef struct murk_bin_range {
    int32_t brick, low[2], high[2];
} murk_bin_range;

/* Fills bins->first and bins->brick for bins->count; lists keep the order of the ranges. */
murk_status murk_bins_fill(murk_context *context, const murk_bin_range *range, size_t count,
                           murk_bins *bins);
void murk_bins_clear(murk_bins *bins);

/* A bin's bricks; column and row must be inside. */
static inline const int32_t *murk_bins_list(const murk_bins *bins, int column, int row,
                                            size_t *count)
{
    size_t bin = (size_t)row * (size_t)bins->count[0] + (size_t)column;
    *count = bins->first[bin + 1] - bins->first[bin];
    return bins->brick + bins->first[bin];
}

/* Sets one axis of a range: what covers [low, high], in bins, of `count`. */
static inline void murk_bin_range_set(murk_bin_range *range, int axis, double low, double high,
                                      int count)
{
    range->low[axis] = low < 0 ? 0 : low < count ? (int32_t)low : count;
    range->high[axis] = high < 0 ? -1 : high < count ? (int32_t)high : count - 1;
}

#endif
