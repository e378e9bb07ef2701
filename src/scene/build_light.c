/* SPDX-License-Identifier: Apache-2.0 */
#include "build.h"

#include <math.h>
#include <string.h>

/* Solid angle of the sun at its mean distance: pi (695,700 km / 149,597,871 km)^2 [sr]. */
static const double SUN_SOLID_ANGLE = 6.7943e-5;

bool scene_has_light(const struct scene_description *description)
{
    const murk_medium_options *medium = &description->medium;
    return description->sun_named || description->sky_named || medium->emission.grid ||
           medium->emission.value > 0.0 || medium->temperature.grid ||
           medium->temperature.value > 0.0 || description->emission_image ||
           description->ground.emission > 0.0 || description->temperature_image ||
           description->ground_temperature > 0.0;
}

/* What the description leaves open is that of the default scene. */
static void fill_light(const struct scene_description *description, const murk_scene *fallback,
                       bool sun_shines, bool sky_shines, murk_scene *out)
{
    const murk_band *band = &description->wavelength;
    murk_sun sun = description->sun;
    double sky = description->sky_radiance;
    if (isnan(sun.direction[0]))
        memcpy(sun.direction, fallback->sun.direction, sizeof sun.direction);
    if (!isnan(description->sun_temperature))
        sun.irradiance = SUN_SOLID_ANGLE * murk_planck_radiance(band, description->sun_temperature);
    else if (isnan(sun.irradiance))
        sun.irradiance = fallback->sun.irradiance;
    if (!isnan(description->sky_temperature))
        sky = (isnan(sky) ? 0.0 : sky) + murk_planck_radiance(band, description->sky_temperature);
    else if (isnan(sky))
        sky = fallback->sky_radiance;
    if (sun_shines)
        out->sun = sun;
    if (sky_shines)
        out->sky_radiance = sky;
}

murk_status scene_build_light(murk_context *context, const struct scene_description *description,
                              bool lit, struct scene_band *band, char message[SCENE_MESSAGE_SIZE])
{
    murk_scene fallback = {0};
    if (!lit || description->sun_named || description->sky_named) {
        murk_ground *ground = NULL;
        murk_status status =
            murk_scene_default(context, band->medium, description->up, &fallback, &ground);
        if (status != MURK_OK)
            return scene_pass_on(context, status, description, NULL, message);
        if (!lit && !description->ground_named)
            band->ground = ground;
        else
            murk_ground_release(ground);
    }
    band->scene.medium = band->medium;
    band->scene.ground = band->ground;
    fill_light(description, &fallback, !lit || description->sun_named,
               !lit || description->sky_named, &band->scene);
    return MURK_OK;
}
