/* SPDX-License-Identifier: Apache-2.0 */
#include "samples.h"

static double light(const murk_level *first, const murk_level *last, int band)
{
    return (last->path[band] - first->path[band]) / first->tau;
}

murk_deep_sample murk_sample(const murk_level *first, const murk_level *last, int bands)
{
    return (murk_deep_sample){.r = (float)light(first, last, 0),
                              .g = (float)light(first, last, bands > 1 ? 1 : 0),
                              .b = (float)light(first, last, bands > 1 ? 2 : 0),
                              .a = (float)(1 - last->tau / first->tau),
                              .z = (float)first->z,
                              .z_back = (float)last->z};
}

/* Whether one sample from first to last gives the levels between, as those who read it do. */
static bool fits(const murk_levels *levels, size_t first, size_t last, int bands)
{
    const murk_level *a = &levels->level[first], *b = &levels->level[last];
    const murk_level *end = &levels->level[levels->count - 1];
    const double opacity = (float)(1 - b->tau / a->tau), clear = log(1 - opacity);
    const double length = b->z - a->z;
    for (size_t n = first + 1; n < last; n++) {
        const murk_level *at = &levels->level[n];
        double way = (at->z - a->z) / length, passed = -expm1(way * clear);
        double part = opacity > 0 ? passed / opacity : way;
        bool good = fabs(a->tau * (1 - passed) - at->tau) <= MURK_SAMPLE_ERROR * (1 - end->tau);
        for (int c = 0; c < bands; c++)
            good &= fabs(a->path[c] + part * (b->path[c] - a->path[c]) - at->path[c]) <=
                    MURK_SAMPLE_ERROR * end->path[c];
        if (!good)
            return false;
    }
    return true;
}

size_t murk_sample_reach(const murk_levels *levels, size_t first, int bands)
{
    /* Twice as far until it is too far, then halfway between. */
    size_t good = first + 1, bad = levels->count, step = 1;
    while (good + step < bad && fits(levels, first, good + step, bands)) {
        good += step;
        step *= 2;
    }
    bad = good + step < bad ? good + step : bad;
    while (bad - good > 1) {
        size_t middle = good + (bad - good) / 2;
        if (fits(levels, first, middle, bands))
            good = middle;
        else
            bad = middle;
    }
    return good;
}
