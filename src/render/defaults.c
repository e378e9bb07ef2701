/* SPDX-License-Identifier: Apache-2.0 */
/* A ground, a scene and a camera that show a medium without further thought. */
#include "murk/murk.h"

#include "ground.h"
#include "medium.h"

#include <math.h>

/* Patches along the longer side of a default ground, and patches per square of its pattern. */
enum { PATCHES = 64, SQUARE = 4 };
/* A shadow is followed no further than this many heights of the medium. */
static const double LONGEST_SHADOW = 2.0;

static void horizontal(murk_up up, int axis[2])
{
    axis[0] = 0;
    axis[1] = murk_axis_b(up);
}

/* How far a point at height 1 throws its shadow along (a, b). */
static void shadow_slope(const murk_sun *sun, murk_up up, double out[2])
{
    int axis[2];
    horizontal(up, axis);
    out[0] = out[1] = 0;
    double down = -sun->direction[murk_axis_up(up)];
    if (!(sun->irradiance > 0) || !(down > 0))
        return;
    for (int c = 0; c < 2; c++)
        out[c] = sun->direction[axis[c]] / down;
    double length = hypot(out[0], out[1]);
    if (length > LONGEST_SHADOW)
        for (int c = 0; c < 2; c++)
            out[c] *= LONGEST_SHADOW / length;
}

murk_status murk_ground_fit(murk_context *context, const murk_medium *medium, const murk_sun *sun,
                            murk_ground_options *options)
{
    (void)context;
    murk_medium_info info;
    murk_status status = murk_medium_info_get(medium, &info);
    if (status)
        return status;
    int axis[2], up = murk_axis_up(options->up);
    horizontal(options->up, axis);
    bool open = options->extent_min[0] == options->extent_max[0] &&
                options->extent_min[1] == options->extent_max[1];
    if (open) {
        double slope[2], size = 0;
        shadow_slope(sun, options->up, slope);
        for (int c = 0; c < 2; c++)
            size = fmax(size, info.box_max[axis[c]] - info.box_min[axis[c]]);
        size = size > 0 ? size : 1;
        double low = fmax(0, info.box_min[up] - options->height);
        double high = fmax(low, info.box_max[up] - options->height);
        for (int c = 0; c < 2; c++) {
            double a = info.box_min[axis[c]], b = info.box_max[axis[c]];
            options->extent_min[c] =
                fmin(a, a + fmin(slope[c] * low, slope[c] * high)) - 0.3 * size;
            options->extent_max[c] =
                fmax(b, b + fmax(slope[c] * low, slope[c] * high)) + 0.3 * size;
        }
    }
    if (options->patches[0] <= 0 || options->patches[1] <= 0) {
        double extent[2] = {options->extent_max[0] - options->extent_min[0],
                            options->extent_max[1] - options->extent_min[1]};
        double patch = fmax(extent[0], extent[1]) / PATCHES;
        for (int c = 0; c < 2; c++)
            options->patches[c] = (int)fmax(1, round(extent[c] / patch));
    }
    return MURK_OK;
}

murk_status murk_scene_default(murk_context *context, const murk_medium *medium, murk_up up,
                               murk_scene *scene, murk_ground **ground)
{
    murk_scene made = {.medium = medium, .sun = {.irradiance = 1.0}, .sky_radiance = 0.03};
    int axis[2];
    horizontal(up, axis);
    made.sun.direction[axis[0]] = 0.5;
    made.sun.direction[axis[1]] = up == MURK_UP_Z ? 0.25 : -0.25;
    made.sun.direction[murk_axis_up(up)] = -0.8;

    murk_medium_info info;
    murk_status status = murk_medium_info_get(medium, &info);
    if (status)
        return status;
    murk_ground_options options = MURK_GROUND_DEFAULT;
    options.up = up;
    options.height = info.box_min[murk_axis_up(up)];
    options.patches[0] = options.patches[1] = 0;
    options.extent_max[0] = options.extent_max[1] = 0;
    status = murk_ground_fit(context, medium, &made.sun, &options);
    if (status)
        return status;
    int nx = options.patches[0], ny = options.patches[1];
    float *reflectance = murk_alloc((size_t)nx * (size_t)ny, sizeof *reflectance);
    if (!reflectance)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    for (int row = 0; row < ny; row++)
        for (int i = 0; i < nx; i++)
            reflectance[row * nx + i] = (row / SQUARE + i / SQUARE) % 2 ? 0.4f : 0.1f;
    options.reflectance_image = reflectance;
    status = murk_ground_create(context, &options, ground);
    murk_free(reflectance);
    if (status)
        return status;
    made.ground = *ground;
    *scene = made;
    return MURK_OK;
}

/* The points that a default picture has to show: the medium's box and its shadow. */
static int frame_points(const murk_scene *scene, const murk_medium_info *info, double points[16][3])
{
    int count = 0;
    for (int c = 0; c < 8; c++, count++)
        for (int a = 0; a < 3; a++)
            points[count][a] = c >> a & 1 ? info->box_max[a] : info->box_min[a];
    if (!scene->ground)
        return count;
    murk_up up = scene->ground->up;
    int axis[2];
    double slope[2];
    horizontal(up, axis);
    shadow_slope(&scene->sun, up, slope);
    for (int c = 0; c < 8; c++, count++) {
        double height = points[c][murk_axis_up(up)] - scene->ground->height;
        for (int h = 0; h < 2; h++)
            points[count][axis[h]] = points[c][axis[h]] + slope[h] * height;
        points[count][murk_axis_up(up)] = scene->ground->height;
    }
    return count;
}

murk_status murk_camera_default(murk_context *context, const murk_scene *scene, murk_camera *out)
{
    (void)context;
    murk_medium_info info;
    murk_status status = murk_medium_info_get(scene->medium, &info);
    if (status)
        return status;
    murk_up up = scene->ground ? scene->ground->up : MURK_UP_Z;
    murk_camera camera = {.fov = 40, .size = {512, 512}};
    camera.up[murk_axis_up(up)] = 1;
    double points[16][3];
    int count = frame_points(scene, &info, points);

    /* Looking along this direction, 24 degrees down, with the sun over the left shoulder. */
    double forward[3], right[3], above[3];
    int axis[2];
    horizontal(up, axis);
    double turn = up == MURK_UP_Z ? 1 : -1;
    forward[axis[0]] = 0.28;
    forward[axis[1]] = turn * 0.87;
    forward[murk_axis_up(up)] = -0.41;
    double length = hypot(hypot(forward[0], forward[1]), forward[2]);
    for (int c = 0; c < 3; c++)
        forward[c] /= length;
    double flat = hypot(forward[axis[0]], forward[axis[1]]);
    right[axis[0]] = turn * forward[axis[1]] / flat;
    right[axis[1]] = -turn * forward[axis[0]] / flat;
    right[murk_axis_up(up)] = 0;
    for (int c = 0; c < 3; c++)
        above[c] = (camera.up[c] - forward[murk_axis_up(up)] * forward[c]) / flat;

    double target[3] = {0}, distance = 0, tangent = 0.9 * tan(camera.fov * M_PI / 360);
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            target[c] += points[i][c] / count;
    for (int pass = 0; pass < 4; pass++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        distance = 0;
        for (int i = 0; i < count; i++) {
            double x = 0, y = 0, z = 0;
            for (int c = 0; c < 3; c++) {
                double d = points[i][c] - target[c];
                x += d * right[c];
                y += d * above[c];
                z += d * forward[c];
            }
            distance = fmax(distance, fmax(fabs(x), fabs(y)) / tangent - z);
            low[0] = fmin(low[0], x);
            high[0] = fmax(high[0], x);
            low[1] = fmin(low[1], y);
            high[1] = fmax(high[1], y);
        }
        for (int c = 0; c < 3 && pass < 3; c++)
            target[c] += (low[0] + high[0]) / 2 * right[c] + (low[1] + high[1]) / 2 * above[c];
    }
    if (!(distance > 0))
        distance = 1;
    for (int c = 0; c < 3; c++) {
        camera.target[c] = target[c];
        camera.eye[c] = target[c] - distance * forward[c];
    }
    *out = camera;
    return MURK_OK;
}
