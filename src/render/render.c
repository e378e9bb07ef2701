/* SPDX-License-Identifier: Apache-2.0 */
#include "murk/murk.h"

#include "blocks.h"
#include "image.h"
#include "march.h"
#include "view.h"

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
    CHANNELS
};

static const char *const NAMES[CHANNELS] = {
    "R",      "G",      "B",         "A",         "transmittance.Y", "path.R",
    "path.G", "path.B", "surface.R", "surface.G", "surface.B",       "Z"};

typedef struct murk_shot {
    murk_march march;
    murk_view view;
    int samples;
    bool no_background;
    const murk_image *background;
    int background_channel[3];
} murk_shot;

/* Bilinear value of the background picture, stretched over the frame; x, y in [0, 1]. */
static double background_at(const murk_shot *shot, int band, double x, double y)
{
    const murk_image *image = shot->background;
    double u = fmin(fmax(x * image->width - 0.5, 0), image->width - 1);
    double v = fmin(fmax(y * image->height - 0.5, 0), image->height - 1);
    int i = (int)u, j = (int)v;
    int i1 = i + 1 < image->width ? i + 1 : i, j1 = j + 1 < image->height ? j + 1 : j;
    int channel = shot->background_channel[band], n = image->channels;
    const float *row0 = image->pixels + (size_t)j * (size_t)image->width * (size_t)n + channel;
    const float *row1 = image->pixels + (size_t)j1 * (size_t)image->width * (size_t)n + channel;
    double top = row0[i * n] + (u - i) * (row0[i1 * n] - row0[i * n]);
    double bottom = row1[i * n] + (u - i) * (row1[i1 * n] - row1[i * n]);
    return top + (v - j) * (bottom - top);
}

/* Radiance behind the medium at the end of a ray: ground, else background picture, else sky. */
static void behind(const murk_shot *shot, const double direction[3], double x, double y,
                   double t_ground, double out[3])
{
    const murk_solution *solution = shot->march.solution;
    for (int c = 0; c < 3; c++)
        out[c] = 0;
    if (shot->no_background)
        return;
    if (isfinite(t_ground)) {
        const murk_ground *ground = solution->ground;
        int a = murk_ground_axis_a(ground), b = murk_ground_axis_b(ground);
        double radiosity =
            murk_march_ground(&shot->march, shot->view.eye[a] + t_ground * direction[a],
                              shot->view.eye[b] + t_ground * direction[b]);
        for (int c = 0; c < 3; c++)
            out[c] = radiosity / M_PI;
    } else {
        for (int c = 0; c < 3; c++)
            out[c] = shot->background
                         ? background_at(shot, c, x / shot->view.size[0], y / shot->view.size[1])
                         : solution->sky_radiance;
    }
}

/* Distance to the ground along a ray; INFINITY where it is not met. */
static double meet_ground(const murk_shot *shot, const double direction[3])
{
    const murk_ground *ground = shot->march.solution->ground;
    if (!ground)
        return INFINITY;
    int up = murk_ground_axis_up(ground);
    if (!(direction[up] < 0))
        return INFINITY;
    double t = (ground->height - shot->view.eye[up]) / direction[up];
    if (!ground->horizon) {
        int a = murk_ground_axis_a(ground), b = murk_ground_axis_b(ground);
        if (murk_ground_patch(ground, shot->view.eye[a] + t * direction[a],
                              shot->view.eye[b] + t * direction[b]) < 0)
            return INFINITY;
    }
    return t;
}

static bool shoot_pixel(const murk_shot *shot, int i, int j, murk_trace *trace, float *pixel)
{
    double sum[CHANNELS] = {0}, depth = 0;
    int n = shot->samples, deep = 0;
    for (int s = 0; s < n * n; s++) {
        double x = i + (s % n + 0.5) / n, y = j + (s / n + 0.5) / n;
        double direction[3], back[3];
        murk_light light;
        murk_view_ray(&shot->view, x, y, direction);
        double t_ground = meet_ground(shot, direction);
        if (!murk_march_ray(&shot->march, shot->view.eye, direction, t_ground, trace, &light))
            return false;
        behind(shot, direction, x, y, t_ground, back);
        sum[TRANSMITTANCE] += light.transmittance;
        for (int c = 0; c < 3; c++) {
            sum[PATH_R + c] += light.path;
            sum[SURFACE_R + c] += light.transmittance * back[c];
        }
        if (isfinite(light.half_depth)) {
            depth += light.half_depth;
            deep++;
        }
    }
    for (int c = 0; c < CHANNELS; c++)
        pixel[c] = (float)(sum[c] / (n * n));
    for (int c = 0; c < 3; c++)
        pixel[R + c] = pixel[PATH_R + c] + pixel[SURFACE_R + c];
    pixel[A] = 1 - pixel[TRANSMITTANCE];
    pixel[Z] = deep ? (float)(depth / deep) : INFINITY;
    return true;
}

static murk_status shoot(murk_context *context, const murk_shot *shot, murk_image *image)
{
    int done = 0;
    bool ok = true;
#pragma omp parallel num_threads(context->threads) reduction(&& : ok)
    {
        murk_trace trace = {0};
#pragma omp for schedule(dynamic, 4)
        for (int j = 0; j < image->height; j++) {
            for (int i = 0; ok && i < image->width; i++)
                ok = shoot_pixel(shot, i, j, &trace,
                                 image->pixels +
                                     ((size_t)j * (size_t)image->width + (size_t)i) * CHANNELS);
            int rows;
#pragma omp atomic capture
            rows = ++done;
            if (rows % 8 == 0)
#pragma omp critical(murk_render_progress)
                murk_progress(context, "render", (double)rows / image->height);
        }
        murk_free(trace.passed);
    }
    return ok ? MURK_OK : murk_fail(context, MURK_ERROR_MEMORY, "out of memory while rendering");
}

/* The background's colour channels by name, else its first ones. */
static void choose_channels(const murk_image *image, int channel[3])
{
    static const char *const names[3] = {"R", "G", "B"};
    for (int c = 0; c < 3; c++) {
        channel[c] = c < image->channels ? c : 0;
        for (int i = 0; i < image->channels; i++)
            if (image->names[i][0] == names[c][0] && !image->names[i][1])
                channel[c] = i;
    }
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
    if (scene->medium != solution->medium || scene->ground != solution->ground)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the solution belongs to another scene; solve this one");
    murk_shot shot = {.march = {.solution = solution},
                      .samples = options->samples > 0 ? options->samples : 2,
                      .no_background = options->no_background,
                      .background = options->background};
    murk_status status = make_view(context, solution->ground, camera, &shot.view);
    if (status)
        return status;
    if (shot.background)
        choose_channels(shot.background, shot.background_channel);
    murk_image *image = NULL;
    status =
        murk_image_create(context, shot.view.size[0], shot.view.size[1], CHANNELS, NAMES, &image);
    if (status)
        return status;
    shot.march.blocks = murk_blocks_create(context, solution);
    if (!shot.march.blocks)
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    if (!status)
        status = shoot(context, &shot, image);
    murk_free(shot.march.blocks);
    if (status)
        murk_image_release(image);
    else
        *out = image;
    return status;
}
