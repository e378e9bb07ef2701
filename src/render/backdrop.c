/* SPDX-License-Identifier: Apache-2.0 */
#include "backdrop.h"

#include "beam.h"
#include "image.h"

/* The image's colour channels by name, else its first ones. */
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

static bool set_centres(const murk_ground *ground, double *centre[2])
{
    for (int c = 0; c < 2; c++) {
        centre[c] = murk_alloc((size_t)ground->count[c], sizeof *centre[c]);
        if (!centre[c])
            return false;
        for (int i = 0; i < ground->count[c]; i++)
            centre[c][i] = (ground->edge[c][i] + ground->edge[c][i + 1]) / 2;
    }
    return true;
}

murk_status murk_backdrop_create(murk_context *context, const murk_solution *solution,
                                 const murk_march *march, const murk_image *image,
                                 murk_backdrop *out)
{
    const murk_ground *ground = solution->ground;
    murk_backdrop backdrop = {.solution = solution, .march = march, .image = image};
    double travel[3];
    murk_status status = MURK_OK;
    if (image)
        choose_channels(image, backdrop.channel);
    if (ground && !set_centres(ground, backdrop.centre))
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    if (!status && ground && murk_beam_direction(ground, &solution->sun, travel)) {
        backdrop.sun = murk_beam_on_ground(ground, &solution->sun);
        status = murk_shadow_create(context, solution->medium->grid, march->box, travel,
                                    &backdrop.shadow);
    }
    if (status)
        murk_backdrop_clear(&backdrop);
    else
        *out = backdrop;
    return status;
}

void murk_backdrop_clear(murk_backdrop *backdrop)
{
    murk_free(backdrop->centre[0]);
    murk_free(backdrop->centre[1]);
    murk_shadow_clear(&backdrop->shadow);
}

/* Bilinear value of the image, stretched over the frame; x, y in [0, 1]. */
static double image_at(const murk_backdrop *backdrop, int band, double x, double y)
{
    const murk_image *image = backdrop->image;
    double u = fmin(fmax(x * image->width - 0.5, 0), image->width - 1);
    double v = fmin(fmax(y * image->height - 0.5, 0), image->height - 1);
    int i = (int)u, j = (int)v;
    int i1 = i + 1 < image->width ? i + 1 : i, j1 = j + 1 < image->height ? j + 1 : j;
    int channel = backdrop->channel[band], n = image->channels;
    const float *row0 = image->pixels + (size_t)j * (size_t)image->width * (size_t)n + channel;
    const float *row1 = image->pixels + (size_t)j1 * (size_t)image->width * (size_t)n + channel;
    double top = row0[i * n] + (u - i) * (row0[i1 * n] - row0[i * n]);
    double bottom = row1[i * n] + (u - i) * (row1[i1 * n] - row1[i * n]);
    return top + (v - j) * (bottom - top);
}

/* The patch centre on the other side of x, and how far x is on the way there. */
static int beside(const double *centre, int count, int column, double x, double *fraction)
{
    int other = x < centre[column] ? column - 1 : column + 1;
    bool alone = other < 0 || other >= count;
    *fraction = alone ? 0 : (x - centre[column]) / (centre[other] - centre[column]);
    return alone ? column : other;
}

static double diffuse_at(const murk_backdrop *backdrop, int ia, int ib, double a, double b)
{
    const murk_ground *ground = backdrop->solution->ground;
    double fa, fb;
    int ja = beside(backdrop->centre[0], ground->count[0], ia, a, &fa);
    int jb = beside(backdrop->centre[1], ground->count[1], ib, b, &fb);
    const float *low = backdrop->solution->patch_diffuse + (size_t)ib * (size_t)ground->count[0];
    const float *high = backdrop->solution->patch_diffuse + (size_t)jb * (size_t)ground->count[0];
    double near = low[ia] + fa * (low[ja] - low[ia]), far = high[ia] + fa * (high[ja] - high[ia]);
    return near + fb * (far - near);
}

/* Radiosity of the ground at (a, b) without the sun, and its reflectance. */
static double ground_at(const murk_backdrop *backdrop, double a, double b, double *reflectance)
{
    const murk_ground *ground = backdrop->solution->ground;
    int ia = murk_ground_column_at(ground, 0, a), ib = murk_ground_column_at(ground, 1, b);
    if (ia < 0 || ib < 0) {
        *reflectance = ground->horizon ? ground->mean_reflectance : 0;
        return ground->horizon ? ground->mean_emission + ground->mean_reflectance * M_PI *
                                                             backdrop->solution->sky_radiance
                               : 0;
    }
    size_t patch = (size_t)ib * (size_t)ground->count[0] + (size_t)ia;
    *reflectance = ground->reflectance[patch];
    return ground->emission[patch] + *reflectance * diffuse_at(backdrop, ia, ib, a, b);
}

static void light_ground(const murk_backdrop *backdrop, const murk_ends *ends,
                         double radiance[MURK_LANES])
{
    double reflectance[MURK_LANES], depth[MURK_LANES];
    bool lit[MURK_LANES], any = false;
    for (int l = 0; l < MURK_LANES; l++) {
        if (!(lit[l] = ends->wanted[l] && ends->ground[l]))
            continue;
        radiance[l] = ground_at(backdrop, ends->a[l], ends->b[l], &reflectance[l]) * M_1_PI;
        lit[l] = reflectance[l] * backdrop->sun > 0;
        any |= lit[l];
    }
    if (!any)
        return;
    murk_shadow_depth(&backdrop->shadow, backdrop->march, ends->point, lit, depth);
    for (int l = 0; l < MURK_LANES; l++)
        if (lit[l])
            radiance[l] +=
                reflectance[l] * backdrop->sun * M_1_PI * (depth[l] > 0 ? exp(-depth[l]) : 1);
}

void murk_backdrop_light(const murk_backdrop *backdrop, const murk_ends *ends,
                         double radiance[3][MURK_LANES])
{
    for (int l = 0; l < MURK_LANES; l++)
        radiance[0][l] = ends->wanted[l] ? backdrop->solution->sky_radiance : 0;
    light_ground(backdrop, ends, radiance[0]);
    for (int l = 0; l < MURK_LANES; l++)
        radiance[1][l] = radiance[2][l] = radiance[0][l];
    for (int l = 0; backdrop->image && l < MURK_LANES; l++)
        for (int c = 0; c < 3 && ends->wanted[l] && !ends->ground[l]; c++)
            radiance[c][l] = image_at(backdrop, c, ends->x[l], ends->y[l]);
}
