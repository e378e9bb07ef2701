/* SPDX-License-Identifier: Apache-2.0 */
#include "curves.h"

#include <string.h>

/* Below this depth the light of a stretch grows in proportion to the way, to 1e-4 of it. */
static const float THIN = 2e-4f;

bool murk_curves_create(int pixels, int rays_most, murk_curves *out)
{
    murk_curves curves = {.pixels = pixels, .rays_most = rays_most};
    curves.curve = murk_alloc((size_t)pixels * (size_t)rays_most, sizeof *curves.curve);
    curves.rays = murk_alloc((size_t)pixels, sizeof *curves.rays);
    curves.back = murk_alloc((size_t)pixels, sizeof *curves.back);
    *out = curves;
    if (curves.curve && curves.rays && curves.back)
        return true;
    murk_curves_clear(out);
    return false;
}

void murk_curves_clear(murk_curves *curves)
{
    murk_free(curves->stretch);
    murk_free(curves->curve);
    murk_free(curves->rays);
    murk_free(curves->back);
    *curves = (murk_curves){0};
}

void murk_curves_restart(murk_curves *curves)
{
    curves->count = 0;
    memset(curves->rays, 0, (size_t)curves->pixels * sizeof *curves->rays);
    memset(curves->back, 0, (size_t)curves->pixels * sizeof *curves->back);
}

static bool reserve(murk_curves *curves, size_t more)
{
    if (curves->capacity - curves->count >= more)
        return true;
    size_t capacity = 2 * curves->capacity + more;
    if (!murk_enlarge(&curves->stretch, curves->count, capacity, sizeof *curves->stretch))
        return false;
    curves->capacity = capacity;
    return true;
}

bool murk_curves_add(murk_curves *curves, int pixel, const murk_trace *trace, int lane,
                     double cosine, double end)
{
    murk_curve *curve =
        &curves->curve[(size_t)pixel * (size_t)curves->rays_most + (size_t)curves->rays[pixel]++];
    float depth = 0, to = 0, path = 0;
    *curve = (murk_curve){.first = curves->count};
    curves->back[pixel] = fmax(curves->back[pixel], end < MURK_FOREVER ? end * cosine : end);
    if (!reserve(curves, trace->count))
        return false;
    for (size_t n = 0; n < trace->count; n++) {
        const murk_passed *passed = &trace->passed[n];
        float step = passed->depth[lane] - depth;
        if (!(step > 0))
            continue;
        float from = (float)((passed->t[lane] - step / passed->kappa_t[lane]) * cosine);
        murk_stretch *stretch = &curves->stretch[curves->count++];
        stretch->from = from > to ? from : to;
        to = (float)(passed->t[lane] * cosine);
        to = to > stretch->from ? to : stretch->from;
        depth = passed->depth[lane];
        path = fmaxf(path, trace->path[n][lane]);
        stretch->to = to;
        stretch->depth = step;
        stretch->path = path;
        stretch->tau = exp(-depth);
    }
    curve->count = curves->count - curve->first;
    return true;
}

/* The last stretch that begins before z, or -1. */
static ptrdiff_t find(const murk_stretch *stretch, size_t count, double z)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (stretch[middle].from < z)
            low = middle + 1;
        else
            high = middle;
    }
    return (ptrdiff_t)low - 1;
}

void murk_curves_at(const murk_curves *curves, const murk_curve *curve, double z, double *tau,
                    double *path)
{
    const murk_stretch *all = curves->stretch + curve->first;
    ptrdiff_t n = find(all, curve->count, z);
    if (n < 0) {
        *tau = 1;
        *path = 0;
        return;
    }
    const murk_stretch *in = &all[n];
    *tau = in->tau;
    *path = in->path;
    if (z >= in->to)
        return;
    double tau0 = n > 0 ? all[n - 1].tau : 1, path0 = n > 0 ? (double)all[n - 1].path : 0;
    double way = (z - in->from) / ((double)in->to - in->from);
    *tau = tau0 * exp(-in->depth * way);
    /* A constant source, as good as one that varies within a voxel can be told here. */
    double part = in->depth > THIN && tau0 > in->tau ? (tau0 - *tau) / (tau0 - in->tau) : way;
    *path = path0 + part * (in->path - path0);
}
