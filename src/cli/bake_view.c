/* SPDX-License-Identifier: Apache-2.0 */
#include "bake_view.h"

#include <math.h>
#include <string.h>

const char *const CLI_BAKE_SIDE[CLI_BAKE_SIDES] = {"right", "top",    "back",
                                                   "left",  "bottom", "front"};

enum { CELL = 256 };

/* Unit vectors of a picture. */
struct axes {
    double right[3], up[3], forward[3];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static bool normalise(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int c = 0; c < 3; c++)
        v[c] /= length;
    return length > 0;
}

static bool find_axes(const murk_camera *camera, struct axes *out)
{
    for (int c = 0; c < 3; c++)
        out->forward[c] = camera->target[c] - camera->eye[c];
    if (!normalise(out->forward))
        return false;
    cross(out->forward, camera->up, out->right);
    if (!normalise(out->right))
        return false;
    cross(out->right, out->forward, out->up);
    return true;
}

void cli_bake_box_add(struct cli_bake_box *box, const murk_medium_info *info)
{
    bool empty = !(box->low[0] < box->high[0]);
    for (int c = 0; info->zones && c < 3; c++) {
        box->low[c] = empty ? info->box_min[c] : fmin(box->low[c], info->box_min[c]);
        box->high[c] = empty ? info->box_max[c] : fmax(box->high[c], info->box_max[c]);
    }
}

/* Where the box ends along an axis, on both sides of its middle. */
static double half_along(const struct cli_bake_box *box, const double axis[3])
{
    double half = 0;
    for (int c = 0; c < 3; c++)
        half += fabs(axis[c]) * (box->high[c] - box->low[c]) / 2;
    return half;
}

murk_status cli_bake_camera(struct cli_job *job, const struct cli_bake_box *box, murk_camera *out)
{
    const struct scene_description *description = &job->description;
    const bool given = !isnan(description->camera.eye[0]) && !isnan(description->camera.target[0]);
    murk_camera camera = job->scene.camera;
    struct axes axes;
    for (int c = 0; c < 3 && !given; c++) {
        camera.target[c] = 0;
        camera.eye[c] = description->up == MURK_UP_Z ? -(c == 1) : c == 2;
    }
    if (!find_axes(&camera, &axes)) {
        cli_error(&job->terminal, "--eye, --target: camera.up runs along the line of sight, or "
                                  "they are the same point; move one of them");
        return MURK_ERROR_INPUT;
    }
    for (int c = 0; c < 2; c++)
        camera.size[c] = job->options->size[c] > 0 ? job->options->size[c] : CELL;
    const double inner[2] = {camera.size[0] - 2, camera.size[1] - 2};
    double pixel =
        fmax(2 * half_along(box, axes.right) / inner[0], 2 * half_along(box, axes.up) / inner[1]);
    double back = 1.01 * half_along(box, axes.forward) + pixel;
    camera.height = pixel > 0 ? pixel * camera.size[1] : 1;
    for (int c = 0; c < 3; c++) {
        camera.target[c] = (box->low[c] + box->high[c]) / 2;
        camera.eye[c] = camera.target[c] - (back > 0 ? back : 1) * axes.forward[c];
    }
    memcpy(camera.up, axes.up, sizeof camera.up);
    *out = camera;
    return MURK_OK;
}

murk_sun cli_bake_light(const murk_camera *camera, int side)
{
    struct axes axes = {0};
    murk_sun sun = {.irradiance = M_PI};
    find_axes(camera, &axes);
    /* Towards the light from the right, the top, the back; the others come from across. */
    const double *towards[] = {axes.right, axes.up, axes.forward};
    for (int c = 0; c < 3; c++)
        sun.direction[c] = (side < 3 ? -1 : 1) * towards[side % 3][c];
    return sun;
}
