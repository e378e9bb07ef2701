/* SPDX-License-Identifier: Apache-2.0 */
#include "usd_light.h"

#include "usd_text.h"

#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void normalize(double v[3])
{
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* Axes of a camera or light, which look along their -z. */
static void look(const double along[3], const double up[3], double axes[3][3])
{
    for (int i = 0; i < 3; i++)
        axes[2][i] = -along[i];
    normalize(axes[2]);
    cross(up, axes[2], axes[0]);
    normalize(axes[0]);
    cross(axes[2], axes[0], axes[1]);
}

/* A value of each band as red, green and blue: that of the bands R, G and B, else the first. */
static void in_colour(const struct scene *scene, double (*take)(const murk_scene *), double out[3])
{
    static const char *const NAMES[] = {"R", "G", "B"};
    int found = 0;
    out[0] = out[1] = out[2] = take(&scene->band[0].scene);
    for (int c = 0; c < 3; c++)
        for (size_t n = 0; n < scene->band_count; n++)
            found += scene->band[n].name && !strcmp(scene->band[n].name, NAMES[c]);
    for (int c = 0; c < 3 && found == 3; c++)
        for (size_t n = 0; n < scene->band_count; n++)
            if (!strcmp(scene->band[n].name, NAMES[c]))
                out[c] = take(&scene->band[n].scene);
}

static double sun_irradiance(const murk_scene *scene)
{
    return scene->sun.irradiance;
}

static double sky_radiance(const murk_scene *scene)
{
    return scene->sky_radiance;
}

void cli_usd_camera(FILE *stream, const murk_camera *camera)
{
    static const double aperture = 24.0; /* only its ratio to the focal length counts */
    double along[3], axes[3][3];
    for (int i = 0; i < 3; i++)
        along[i] = camera->target[i] - camera->eye[i];
    look(along, camera->up, axes);
    const double distance = sqrt(dot(along, along));
    fputs("\n    def Camera \"Camera\"\n    {\n", stream);
    fprintf(stream, "        float2 clippingRange = (%.9g, %.9g)\n", 1e-3 * distance,
            1e3 * distance);
    fprintf(stream, "        float focalLength = %.9g\n",
            0.5 * aperture / tan(camera->fov * acos(-1.0) / 360.0));
    fprintf(stream, "        float horizontalAperture = %.9g\n",
            aperture * camera->size[0] / camera->size[1]);
    fprintf(stream, "        float verticalAperture = %.9g\n", aperture);
    cli_usd_transform(stream, axes, camera->eye);
    fputs("    }\n", stream);
}

static void write_colour(FILE *s, const double colour[3], const char *text)
{
    fputs("        color3f inputs:color = ", s);
    cli_usd_vector(s, colour);
    fprintf(s, " (\n            doc = \"%s\"\n        )\n        float inputs:intensity = 1\n",
            text);
}

void cli_usd_lights(FILE *stream, const struct scene *scene)
{
    static const double ORIGIN[3] = {0}, Y[3] = {0, 1, 0}, X[3] = {1, 0, 0};
    const double *direction = scene->band[0].scene.sun.direction;
    double colour[3], axes[3][3];
    in_colour(scene, sun_irradiance, colour);
    if (fmax(colour[0], fmax(colour[1], colour[2])) > 0.0) {
        look(direction, fabs(direction[1]) > 0.9 * sqrt(dot(direction, direction)) ? X : Y, axes);
        fputs("\n    def DistantLight \"Sun\"\n    {\n        float inputs:angle = 0\n", stream);
        write_colour(stream, colour, "irradiance across the beam [W/m^2]");
        fputs("        bool inputs:normalize = 1\n", stream);
        cli_usd_transform(stream, axes, ORIGIN);
        fputs("    }\n", stream);
    }
    in_colour(scene, sky_radiance, colour);
    if (fmax(colour[0], fmax(colour[1], colour[2])) > 0.0) {
        fputs("\n    def DomeLight \"Sky\"\n    {\n", stream);
        write_colour(stream, colour, "radiance [W/m^2/sr]");
        fputs("    }\n", stream);
    }
}
