/* SPDX-License-Identifier: Apache-2.0 */
#include "view.h"

#include <math.h>

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static bool normalise(double v[3])
{
    double length = hypot(hypot(v[0], v[1]), v[2]);
    if (!(length > 0) || !isfinite(length))
        return false;
    for (int c = 0; c < 3; c++)
        v[c] /= length;
    return true;
}

murk_status murk_view_create(murk_context *context, const murk_camera *camera, murk_view *out)
{
    murk_view view = {.size = {camera->size[0], camera->size[1]}};
    for (int c = 0; c < 2; c++)
        if (camera->size[c] < 1 || camera->size[c] > 1 << 16)
            return murk_fail(context, MURK_ERROR_INPUT,
                             "camera.size: %d x %d is not a picture; 1 to 65536 pixels a side",
                             camera->size[0], camera->size[1]);
    if (!(camera->height >= 0 && isfinite(camera->height)))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "camera.height: %g is no height; > 0 for parallel rays, else 0",
                         camera->height);
    view.parallel = camera->height > 0;
    if (!view.parallel && !(camera->fov > 0 && camera->fov < 180))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "camera.fov: %g is not between 0 and 180 degrees", camera->fov);
    for (int c = 0; c < 3; c++) {
        view.eye[c] = camera->eye[c];
        view.forward[c] = camera->target[c] - camera->eye[c];
        if (!isfinite(camera->eye[c]) || !isfinite(camera->target[c]) || !isfinite(camera->up[c]))
            return murk_fail(context, MURK_ERROR_INPUT, "camera: a coordinate is not finite");
    }
    if (!normalise(view.forward))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "camera.target: the same point as camera.eye; move one of them");
    cross(view.forward, camera->up, view.right);
    if (!normalise(view.right))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "camera.up: runs along the line of sight; choose another");
    cross(view.right, view.forward, view.up);
    view.half_height = view.parallel ? camera->height / 2 : tan(camera->fov * M_PI / 360);
    view.half_width = view.half_height * camera->size[0] / camera->size[1];
    *out = view;
    return MURK_OK;
}
