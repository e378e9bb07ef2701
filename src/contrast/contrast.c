/* SPDX-License-Identifier: Apache-2.0 */
#include "murk/contrast.h"

#include "context.h"
#include "image.h"
#include "region.h"

#include <math.h>
#include <stdio.h>

enum quantity { RADIANCE, INHERENT, SCATTERED, EMITTED, TRANSMITTANCE, CL, QUANTITY_COUNT };

/* Where the quantities of a band are in a pixel; -1: nowhere. */
static murk_status find_channels(murk_context *context, const murk_image *picture, const char *band,
                                 int channel[QUANTITY_COUNT])
{
    static const char *const NAMES[CL] = {"radiance", "inherent", "scattered", "emitted",
                                          "transmittance"};
    for (int q = 0; q < CL; q++) {
        char name[MURK_BAND_NAME_MAX + 16];
        snprintf(name, sizeof name, "%s.%s", band, NAMES[q]);
        channel[q] = murk_image_channel(picture, name);
        if (channel[q] < 0)
            return murk_fail(
                context, MURK_ERROR_INPUT,
                "the picture has no channel %s; render it again, and keep all channels", name);
    }
    channel[CL] = murk_image_channel(picture, "CL.Y");
    return MURK_OK;
}

/* The means of the quantities over the pixels of a region that are not in `without` (NULL: none);
   gives their number. */
static uint64_t average(const murk_image *picture, const int channel[QUANTITY_COUNT],
                        const murk_region *region, const murk_region *without,
                        double mean[QUANTITY_COUNT])
{
    int width = murk_image_width(picture), height = murk_image_height(picture);
    const float *pixel = murk_image_pixels_const(picture);
    double sum[QUANTITY_COUNT] = {0};
    uint64_t count = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++, pixel += murk_image_channels(picture)) {
            if (!murk_region_holds(region, x, y) || (without && murk_region_holds(without, x, y)))
                continue;
            for (int q = 0; q < QUANTITY_COUNT; q++)
                sum[q] += channel[q] < 0 ? NAN : pixel[channel[q]];
            count++;
        }
    for (int q = 0; q < QUANTITY_COUNT; q++)
        mean[q] = sum[q] / (double)count;
    return count;
}

static double temperature(const murk_band *band, double radiance)
{
    return murk_band_valid(band) && isfinite(radiance) ? murk_planck_temperature(band, radiance)
                                                       : NAN;
}

static murk_region_mean mean_of(const murk_band *band, const double mean[QUANTITY_COUNT],
                                uint64_t pixels)
{
    return (murk_region_mean){
        .pixels = pixels,
        .radiance = mean[RADIANCE],
        .inherent = mean[INHERENT],
        .scattered = mean[SCATTERED],
        .emitted = mean[EMITTED],
        .transmittance = mean[TRANSMITTANCE],
        .optical_depth = 0 - log(mean[TRANSMITTANCE]),
        .temperature = temperature(band, mean[RADIANCE]),
        .temperature_inherent = temperature(band, mean[INHERENT]),
        .cl = mean[CL],
    };
}

static double quotient(double a, double b)
{
    return b != 0 ? a / b : NAN;
}

/* All but the means of the regions. */
static void compare(const murk_sensor *sensor, murk_contrast *c)
{
    const murk_region_mean *t = &c->target, *b = &c->background;
    c->inherent = quotient(t->inherent - b->inherent, b->inherent);
    c->apparent = quotient(t->radiance - b->radiance, b->radiance);
    c->transmittance = quotient(c->apparent, c->inherent);
    c->dt_inherent = t->temperature_inherent - b->temperature_inherent;
    c->dt_apparent = t->temperature - b->temperature;
    c->cnr_thermal = sensor ? quotient(fabs(c->dt_apparent), sensor->netd) : NAN;
    c->cnr_radiance = sensor ? fabs(c->apparent) * sensor->snr : NAN;
}

murk_status murk_contrast_measure(murk_context *context, const murk_image *picture,
                                  const murk_picture_band *band, const murk_region *target,
                                  const murk_region *background, const murk_sensor *sensor,
                                  murk_contrast *out)
{
    int channel[QUANTITY_COUNT];
    double mean[2][QUANTITY_COUNT];
    murk_status status = find_channels(context, picture, band->name, channel);
    if (status == MURK_OK)
        status = murk_region_check(context, target, picture, "target");
    if (status == MURK_OK)
        status = murk_region_check(context, background, picture, "background");
    if (status != MURK_OK)
        return status;
    uint64_t in_target = average(picture, channel, target, NULL, mean[0]);
    uint64_t in_background = average(picture, channel, background, target, mean[1]);
    if (in_target == 0)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the target has no pixel; its mask is to be above 0.5 somewhere");
    if (in_background == 0)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the background has no pixel outside of the target; name a region beside "
                         "or around it");
    murk_contrast result = {.target = mean_of(&band->band, mean[0], in_target),
                            .background = mean_of(&band->band, mean[1], in_background)};
    compare(sensor, &result);
    *out = result;
    return MURK_OK;
}
