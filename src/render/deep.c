/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures with samples along the depth. */
#include "deep.h"

#include "band_colors.h"
#include "samples.h"
#include "shot.h"

enum { BLOCK = MURK_BLOCK_PIXELS * MURK_BLOCK_PIXELS, COLORS = 3 };

/* The depth of what has none. */
static const double FARTHEST = 1e30;
/* What is behind less transmittance than this cannot be seen in a float picture. */
static const double CLEAR = 1e-9;

/* One band, or R, G and B. */
typedef struct shots {
    murk_shot of[COLORS];
    int bands;
} shots;

/* What a thread needs. */
typedef struct workspace {
    murk_trace trace[MURK_SHOT_TRACES];
    murk_curves curves[COLORS];
    murk_sum sum[COLORS][BLOCK];
    murk_levels levels;
} workspace;

static bool workspace_create(const shots *all, workspace *out)
{
    const int rays = all->of[0].samples * all->of[0].samples;
    bool ok = true;
    *out = (workspace){0};
    for (int t = 0; t < MURK_SHOT_TRACES; t++)
        out->trace[t].records = true;
    for (int b = 0; b < all->bands; b++)
        ok &= murk_curves_create(BLOCK, rays, &out->curves[b]);
    return ok;
}

static void workspace_clear(workspace *own)
{
    for (int t = 0; t < MURK_SHOT_TRACES; t++)
        murk_trace_clear(&own->trace[t]);
    for (int b = 0; b < COLORS; b++)
        murk_curves_clear(&own->curves[b]);
    murk_free(own->levels.level);
}

/* The means of a pixel of a block, as in the flat picture. */
static murk_deep_pixel pixel_of(const shots *all, const workspace *own, int pixel)
{
    murk_deep_pixel of = {
        .bands = all->bands, .pixel = pixel, .rays = all->of[0].samples * all->of[0].samples};
    for (int b = 0; b < all->bands; b++) {
        const murk_sum *sum = &own->sum[b][pixel];
        of.curves[b] = &own->curves[b];
        of.end.tau += sum->transmittance / (of.rays * all->bands);
        of.end.path[b] = sum->path / of.rays;
    }
    return of;
}

/* The light that lies behind the medium; false where there is none. */
static bool surface(const shots *all, const workspace *own, const murk_deep_pixel *pixel,
                    murk_deep_sample *out)
{
    float light[COLORS];
    double tau = pixel->end.tau * pixel->rays, z = own->curves[0].back[pixel->pixel];
    for (int c = 0; c < COLORS; c++)
        light[c] = (float)(own->sum[all->bands > 1 ? c : 0][pixel->pixel].surface[c] / tau);
    *out = (murk_deep_sample){.r = light[0], .g = light[1], .b = light[2]};
    out->z = out->z_back = (float)fmin(z, FARTHEST);
    return light[0] > 0 || light[1] > 0 || light[2] > 0;
}

/* The samples of pixel (i, j), which is one of a block. */
static bool add_samples(const shots *all, workspace *own, int pixel, int i, int j, murk_deep *deep)
{
    const murk_deep_pixel of = pixel_of(all, own, pixel);
    const murk_levels *levels = &own->levels;
    murk_deep_sample sample;
    float behind = 0;
    if (!murk_levels_find(&of, &own->levels))
        return false;
    for (size_t n = 0, next; n + 1 < levels->count && levels->level[n].tau > CLEAR; n = next) {
        next = murk_sample_reach(levels, n, of.bands);
        sample = murk_sample(&levels->level[n], &levels->level[next], of.bands);
        behind = sample.z_back;
        if ((sample.a > 0 || sample.r > 0 || sample.g > 0 || sample.b > 0) &&
            !murk_deep_append(deep, i, j, &sample))
            return false;
    }
    if (!(of.end.tau > CLEAR) || !surface(all, own, &of, &sample))
        return true;
    sample.z = sample.z_back = fmaxf(sample.z, behind);
    return murk_deep_append(deep, i, j, &sample);
}

static bool shoot_bin(const shots *all, int column, int row, workspace *own, murk_deep *deep)
{
    const int i0 = column * MURK_BIN_PIXELS, j0 = row * MURK_BIN_PIXELS, edge = all->of[0].block;
    for (int j = j0; j < j0 + MURK_BIN_PIXELS && j < deep->height; j += edge)
        for (int i = i0; i < i0 + MURK_BIN_PIXELS && i < deep->width; i += edge) {
            for (int b = 0; b < all->bands; b++)
                if (!murk_shot_block(&all->of[b], i, j, own->trace, &own->curves[b], own->sum[b]))
                    return false;
            for (int y = 0; y < edge && j + y < deep->height; y++)
                for (int x = 0; x < edge && i + x < deep->width; x++)
                    if (!add_samples(all, own, y * MURK_BLOCK_PIXELS + x, i + x, j + y, deep))
                        return false;
        }
    return true;
}

static murk_status shoot(murk_context *context, const shots *all, murk_deep *deep)
{
    int done = 0, columns = all->of[0].seen.count[0], rows = all->of[0].seen.count[1];
    bool ok = true;
#pragma omp parallel num_threads(context->threads) reduction(&& : ok)
    {
        workspace own;
        ok = workspace_create(all, &own);
#pragma omp for schedule(dynamic)
        for (int j = 0; j < rows; j++) {
            for (int i = 0; ok && i < columns; i++)
                ok = shoot_bin(all, i, j, &own, deep);
            int ready;
#pragma omp atomic capture
            ready = ++done;
#pragma omp critical(murk_render_progress)
            murk_progress(context, "deep", (double)ready / rows);
        }
        workspace_clear(&own);
    }
    return ok ? MURK_OK : murk_fail(context, MURK_ERROR_MEMORY, "out of memory while rendering");
}

static void shots_clear(shots *all)
{
    while (all->bands > 0)
        murk_shot_clear(&all->of[--all->bands]);
}

static murk_status shots_create(murk_context *context, const murk_band_view *views, size_t count,
                                const murk_camera *camera, const murk_render_options *options,
                                shots *out)
{
    const murk_band_view *color[COLORS];
    const int bands = murk_band_colors(views, count, color) ? COLORS : 1;
    murk_status status = MURK_OK;
    out->bands = 0;
    for (int b = 0; !status && b < bands; b++) {
        murk_view view;
        status = murk_shot_view(context, color[b]->scene, color[b]->solution, camera, &view);
        if (!status)
            status = murk_shot_create(context, color[b]->solution, &view, options, &out->of[b]);
        out->bands += !status;
    }
    if (status)
        shots_clear(out);
    return status;
}

murk_status murk_render_deep(murk_context *context, const murk_band_view *views, size_t count,
                             const murk_camera *camera, const murk_render_options *options,
                             murk_deep **out)
{
    const murk_render_options defaults = MURK_RENDER_DEFAULT;
    murk_render_options plain = options ? *options : defaults;
    plain.parts = false;
    shots all;
    murk_deep *deep = NULL;
    murk_status status = shots_create(context, views, count, camera, &plain, &all);
    if (status)
        return status;
    status = murk_deep_create(context, camera->size[0], camera->size[1], MURK_BIN_PIXELS, &deep);
    if (!status)
        status = shoot(context, &all, deep);
    shots_clear(&all);
    if (status)
        murk_deep_release(deep);
    else
        *out = deep;
    return status;
}
