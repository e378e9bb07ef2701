/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures by channel, and where the rays of a pinhole camera go. */
#ifndef CAMERA_H
#define CAMERA_H

#include "check.h"

static inline murk_image *take(const struct world *w, const murk_camera *camera,
                               const murk_render_options *options)
{
    murk_image *image = NULL;
    if (murk_render(w->context, &w->scene, w->solution, camera, options, &image))
        fail_msg("%s", murk_context_message(w->context));
    assert_int_equal(murk_image_width(image), camera->size[0]);
    assert_int_equal(murk_image_height(image), camera->size[1]);
    return image;
}

static inline float pixel(const murk_image *image, const char *channel, int i, int j)
{
    int channels = murk_image_channels(image);
    for (int c = 0; c < channels; c++)
        if (!strcmp(murk_image_channel_name(image, c), channel))
            return murk_image_pixels_const(image)[(j * murk_image_width(image) + i) * channels + c];
    fail_msg("no channel %s", channel);
    return NAN;
}

static inline double mean_pixel(const murk_image *image, const char *channel)
{
    double sum = 0;
    for (int j = 0; j < murk_image_height(image); j++)
        for (int i = 0; i < murk_image_width(image); i++)
            sum += pixel(image, channel, i, j);
    return sum / murk_image_width(image) / murk_image_height(image);
}

static inline void cross_product(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double dot_product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void scale_to(double v[3], double length)
{
    double factor = length / sqrt(dot_product(v, v));
    for (int c = 0; c < 3; c++)
        v[c] *= factor;
}

/* The unit vector through the middle of pixel (i, j): x to the right, row 0 on top, fov vertical.
 */
static inline void look_through(const murk_camera *camera, int i, int j, double out[3])
{
    double right[3], up[3], forward[3];
    for (int c = 0; c < 3; c++)
        forward[c] = camera->target[c] - camera->eye[c];
    scale_to(forward, 1);
    cross_product(forward, camera->up, right);
    scale_to(right, 1);
    cross_product(right, forward, up);
    double pitch = 2 * tan(camera->fov / 2 * M_PI / 180) / camera->size[1];
    double x = (i + 0.5 - camera->size[0] / 2.0) * pitch,
           y = (camera->size[1] / 2.0 - j - 0.5) * pitch;
    for (int c = 0; c < 3; c++)
        out[c] = forward[c] + x * right[c] + y * up[c];
    scale_to(out, 1);
}

/* Where a ray is inside a box: [*from, *to] with *from >= 0, empty where *to <= *from. */
static inline void meet_box(const double low[3], const double high[3], const double at[3],
                            const double along[3], double *from, double *to)
{
    *from = 0;
    *to = INFINITY;
    for (int a = 0; a < 3; a++) {
        double t0 = (low[a] - at[a]) / along[a], t1 = (high[a] - at[a]) / along[a];
        if (along[a] == 0) { /* all of the ray, or nothing */
            t0 = -INFINITY;
            t1 = at[a] > low[a] && at[a] < high[a] ? INFINITY : -INFINITY;
        }
        *from = fmax(*from, fmin(t0, t1));
        *to = fmin(*to, fmax(t0, t1));
    }
}

static inline double chord(const double low[3], const double high[3], const double at[3],
                           const double along[3])
{
    double from, to;
    meet_box(low, high, at, along, &from, &to);
    return fmax(0, to - from);
}

#endif
