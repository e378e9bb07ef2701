/* SPDX-License-Identifier: Apache-2.0 */
#include "levels.h"

/* Depths are floats in the file: nearer ones than this part of them are one. */
static const double NEAREST = 1e-6;

/* The means over the rays, as those of the picture: neither light nor opacity is taken back. */
static murk_level level_at(const murk_deep_pixel *pixel, double z, const murk_level *before)
{
    murk_level level = {.z = z};
    for (int b = 0; b < pixel->bands; b++) {
        const murk_curves *curves = pixel->curves[b];
        const murk_curve *curve = curves->curve + (size_t)pixel->pixel * (size_t)curves->rays_most;
        double sum = 0;
        for (int r = 0; r < pixel->rays; r++) {
            double tau, path;
            murk_curves_at(curves, &curve[r], z, &tau, &path);
            level.tau += tau / (pixel->rays * pixel->bands);
            sum += path * M_1_PI / pixel->rays;
        }
        level.path[b] = fmin(fmax(sum, before->path[b]), pixel->end.path[b]);
    }
    level.tau = fmax(fmin(level.tau, before->tau), pixel->end.tau);
    return level;
}

/* Whether from one level to another more happens than may. */
static bool differs(const murk_deep_pixel *pixel, const murk_level *a, const murk_level *b)
{
    bool more = a->tau - b->tau > MURK_LEVEL_CHANGE * (1 - pixel->end.tau);
    for (int c = 0; c < pixel->bands; c++)
        more |= b->path[c] - a->path[c] > MURK_LEVEL_CHANGE * pixel->end.path[c];
    return more;
}

static bool append(murk_levels *levels, const murk_level *level)
{
    if (levels->count == levels->capacity) {
        size_t capacity = 2 * levels->capacity + 256;
        if (!murk_enlarge(&levels->level, levels->count, capacity, sizeof *levels->level))
            return false;
        levels->capacity = capacity;
    }
    levels->level[levels->count++] = *level;
    return true;
}

/* Appends levels after `low`, which is there, up to `high`. */
static bool divide(const murk_deep_pixel *pixel, const murk_level *low, const murk_level *high,
                   murk_levels *out)
{
    double middle = low->z + (high->z - low->z) / 2;
    if (!differs(pixel, low, high) || !(high->z - low->z > NEAREST * high->z))
        return append(out, high);
    murk_level between = level_at(pixel, middle, low);
    return divide(pixel, low, &between, out) && divide(pixel, &between, high, out);
}

/* The depths between which the pixel has medium. */
static bool range(const murk_deep_pixel *pixel, double *from, double *to)
{
    *from = INFINITY;
    *to = 0;
    for (int b = 0; b < pixel->bands; b++) {
        const murk_curves *curves = pixel->curves[b];
        const murk_curve *curve = curves->curve + (size_t)pixel->pixel * (size_t)curves->rays_most;
        for (int r = 0; r < pixel->rays; r++)
            if (curve[r].count) {
                const murk_stretch *first = &curves->stretch[curve[r].first];
                *from = fmin(*from, first->from);
                *to = fmax(*to, first[curve[r].count - 1].to);
            }
    }
    return *from < *to;
}

bool murk_levels_find(const murk_deep_pixel *pixel, murk_levels *out)
{
    double from, to;
    out->count = 0;
    if (!range(pixel, &from, &to))
        return true;
    const murk_level low = {.z = from, .tau = 1};
    murk_level high = pixel->end;
    high.z = to;
    return append(out, &low) && divide(pixel, &low, &high, out);
}
