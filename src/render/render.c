/* SPDX-License-Identifier: Apache-2.0 */
#include "memory.h"
#include "murk/murk.h"

#include "image.h"
#include "shot.h"

#include <math.h>

enum {
    R,
    G,
    B,
    A,
    TRANSMITTANCE,
    PATH_R,
    PATH_G,
    PATH_B,
    SURFACE_R,
    SURFACE_G,
    SURFACE_B,
    Z,
    CHANNELS,
    SCATTERED = CHANNELS,
    EMITTED,
    INHERENT_R,
    INHERENT_G,
    INHERENT_B,
    DEPTH,
    CHANNELS_WITH_PARTS
};

static const char *const NAMES[CHANNELS_WITH_PARTS] = {
    "R",           "G",         "B",          "A",          "transmittance.Y", "path.R",
    "path.G",      "path.B",    "surface.R",  "surface.G",  "surface.B",       "Z",
    "scattered.Y", "emitted.Y", "inherent.R", "inherent.G", "inherent.B",      "depth.Y"};

/* The means over the rays of a pixel. */
static void set_pixel(const murk_sum *sum, int rays, bool parts, float *pixel)
{
    pixel[TRANSMITTANCE] = (float)(sum->transmittance / rays);
    pixel[A] = 1 - pixel[TRANSMITTANCE];
    for (int c = 0; c < 3; c++) {
        pixel[PATH_R + c] = (float)(sum->path / rays);
        pixel[SURFACE_R + c] = (float)(sum->surface[c] / rays);
        pixel[R + c] = pixel[PATH_R + c] + pixel[SURFACE_R + c];
    }
    pixel[Z] = sum->deep ? (float)(sum->distance / sum->deep) : INFINITY;
    if (!parts)
        return;
    pixel[EMITTED] = (float)(fmin(sum->emitted, sum->path) / rays);
    pixel[SCATTERED] = pixel[PATH_R] - pixel[EMITTED];
    for (int c = 0; c < 3; c++)
        pixel[INHERENT_R + c] = (float)(sum->inherent[c] / rays);
    pixel[DEPTH] = (float)(sum->depth / rays);
}

static bool shoot_bin(const murk_shot *shot, int column, int row, murk_trace *trace,
                      murk_image *image)
{
    murk_sum sum[MURK_BLOCK_PIXELS * MURK_BLOCK_PIXELS];
    int i0 = column * MURK_BIN_PIXELS, j0 = row * MURK_BIN_PIXELS, edge = shot->block;
    for (int j = j0; j < j0 + MURK_BIN_PIXELS && j < image->height; j += edge)
        for (int i = i0; i < i0 + MURK_BIN_PIXELS && i < image->width; i += edge) {
            if (!murk_shot_block(shot, i, j, trace, NULL, sum))
                return false;
            for (int y = 0; y < edge && j + y < image->height; y++)
                for (int x = 0; x < edge && i + x < image->width; x++)
                    set_pixel(
                        &sum[y * MURK_BLOCK_PIXELS + x], shot->samples * shot->samples, shot->parts,
                        image->pixels + ((size_t)(j + y) * (size_t)image->width + (size_t)(i + x)) *
                                            (size_t)image->channels);
        }
    return true;
}

static murk_status shoot(murk_context *context, const murk_shot *shot, murk_image *image)
{
    int done = 0, columns = shot->seen.count[0], rows = shot->seen.count[1];
    bool ok = true;
#pragma omp parallel num_threads(context->threads) reduction(&& : ok)
    {
        murk_trace trace = {0};
#pragma omp for schedule(dynamic)
        for (int j = 0; j < rows; j++) {
            for (int i = 0; ok && i < columns; i++)
                ok = shoot_bin(shot, i, j, &trace, image);
            int ready;
#pragma omp atomic capture
            ready = ++done;
#pragma omp critical(murk_render_progress)
            murk_progress(context, "render", (double)ready / rows);
        }
        murk_trace_clear(&trace);
    }
    return ok ? MURK_OK : murk_fail(context, MURK_ERROR_MEMORY, "out of memory while rendering");
}

/* The view of a camera that stands where a picture can be taken. */
static murk_status make_view(murk_context *context, const murk_ground *ground,
                             const murk_camera *camera, murk_view *out)
{
    murk_view view;
    murk_status status = murk_view_create(context, camera, &view);
    if (status)
        return status;
    if (ground && !(view.eye[murk_ground_axis_up(ground)] > ground->height))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "camera.eye: %g is not above the ground at %g; raise it",
                         view.eye[murk_ground_axis_up(ground)], ground->height);
    *out = view;
    return MURK_OK;
}

murk_status murk_shot_view(murk_context *context, const murk_scene *scene,
                           const murk_solution *solution, const murk_camera *camera, murk_view *out)
{
    if (scene->medium != solution->medium || scene->ground != solution->ground)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the solution belongs to another scene; solve this one");
    return make_view(context, solution->ground, camera, out);
}

murk_status murk_camera_check(murk_context *context, const murk_scene *scene,
                              const murk_camera *camera)
{
    murk_view view;
    return make_view(context, scene->ground, camera, &view);
}

murk_status murk_render(murk_context *context, const murk_scene *scene,
                        const murk_solution *solution, const murk_camera *camera,
                        const murk_render_options *options, murk_image **out)
{
    const murk_render_options defaults = MURK_RENDER_DEFAULT;
    if (!options)
        options = &defaults;
    murk_view view;
    murk_status status = murk_shot_view(context, scene, solution, camera, &view);
    if (status)
        return status;
    status = murk_memory_check(context, "the picture", murk_render_memory(scene, camera, 0));
    if (status)
        return status;
    murk_image *image = NULL;
    status = murk_image_create(context, view.size[0], view.size[1],
                               options->parts ? CHANNELS_WITH_PARTS : CHANNELS, NAMES, &image);
    if (status)
        return status;
    murk_shot shot;
    status = murk_shot_create(context, solution, &view, options, &shot);
    if (!status) {
        status = shoot(context, &shot, image);
        murk_shot_clear(&shot);
    }
    if (status)
        murk_image_release(image);
    else
        *out = image;
    return status;
}
