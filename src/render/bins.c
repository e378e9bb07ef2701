/* SPDX-License-Identifier: Apache-2.0 */
#include "bins.h"

murk_status murk_bins_fill(murk_context *context, const murk_bin_range *range, size_t count,
                           murk_bins *bins)
{
    size_t columns = (size_t)bins->count[0], total = columns * (size_t)bins->count[1], sum = 0;
    bins->first = murk_alloc(total + 1, sizeof *bins->first);
    if (!bins->first)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    for (size_t i = 0; i < count; i++)
        for (int row = range[i].low[1]; row <= range[i].high[1]; row++)
            for (int column = range[i].low[0]; column <= range[i].high[0]; column++)
                bins->first[(size_t)row * columns + (size_t)column]++;
    for (size_t bin = 0; bin <= total; bin++) {
        size_t here = bins->first[bin];
        bins->first[bin] = sum;
        sum += here;
    }
    bins->brick = murk_alloc(sum, sizeof *bins->brick);
    if (!bins->brick)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    for (size_t i = 0; i < count; i++)
        for (int row = range[i].low[1]; row <= range[i].high[1]; row++)
            for (int column = range[i].low[0]; column <= range[i].high[0]; column++)
                bins->brick[bins->first[(size_t)row * columns + (size_t)column]++] = range[i].brick;
    /* Each start has moved to its list's end, which is the start of the next. */
    for (size_t bin = total; bin > 0; bin--)
        bins->first[bin] = bins->first[bin - 1];
    bins->first[0] = 0;
    return MURK_OK;
}

void murk_bins_clear(murk_bins *bins)
{
    murk_free(bins->first);
    murk_free(bins->brick);
    *bins = (murk_bins){0};
}
