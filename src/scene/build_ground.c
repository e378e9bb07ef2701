/* SPDX-License-Identifier: Apache-2.0 */
#include "build.h"
#include "pixels.h"

#include <math.h>
#include <stdlib.h>

/* Images of the ground, NULL where there is a number. */
struct images {
    float *reflectance, *emission, *temperature;
};

static murk_status read_images(murk_context *context, const struct scene_description *description,
                               int patches[2], struct images *out, char *message)
{
    const struct {
        const char *key, *file;
        double max;
        float **to;
    } all[] = {
        {"ground.reflectance", description->reflectance_image, 1.0, &out->reflectance},
        {"ground.emission", description->emission_image, INFINITY, &out->emission},
        {"ground.temperature", description->temperature_image, INFINITY, &out->temperature},
    };
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sizeof all / sizeof *all && status == MURK_OK; i++)
        if (all[i].file)
            status = scene_read_pixels(context, description, all[i].key, all[i].file, all[i].max,
                                       patches, all[i].to, message);
    return status;
}

/* Adds what the ground radiates by its temperature T: (1 - rho) pi L(T), L Planck's radiance. */
static murk_status add_thermal(const struct scene_description *description,
                               murk_ground_options *options, struct images *images, char *message)
{
    const murk_band *band = &description->wavelength;
    const double kelvin = description->ground_temperature;
    const double black = isnan(kelvin) ? 0.0 : M_PI * murk_planck_radiance(band, kelvin);
    if (!images->temperature && !(black > 0.0))
        return MURK_OK;
    if (!images->temperature && !images->reflectance && !images->emission) {
        options->emission += (1 - options->reflectance) * black;
        return MURK_OK;
    }
    size_t count = (size_t)options->patches[0] * (size_t)options->patches[1];
    float *emission = images->emission ? images->emission : malloc(count * sizeof *emission);
    if (!emission)
        return scene_refuse(description, "ground", "out of memory", message);
    for (size_t i = 0; i < count; i++) {
        double rho = images->reflectance ? images->reflectance[i] : options->reflectance;
        double own = images->emission ? images->emission[i] : options->emission;
        double radiates =
            images->temperature ? M_PI * murk_planck_radiance(band, images->temperature[i]) : black;
        emission[i] = (float)(own + (1 - rho) * radiates);
    }
    images->emission = emission;
    return MURK_OK;
}

static murk_status create_ground(murk_context *context, const struct scene_description *description,
                                 struct images *images, struct scene_band *band, char *message)
{
    murk_ground_options options = description->ground;
    murk_status status = MURK_OK;
    options.up = description->up;
    if (isnan(options.height)) {
        murk_medium_info info;
        status = murk_medium_info_get(band->medium, &info);
        options.height = info.box_min[description->up == MURK_UP_Y ? 1 : 2];
    }
    if (status == MURK_OK)
        status = read_images(context, description, options.patches, images, message);
    if (status == MURK_OK)
        status = add_thermal(description, &options, images, message);
    if (status != MURK_OK)
        return status;
    options.reflectance_image = images->reflectance;
    options.emission_image = images->emission;
    status = murk_ground_fit(context, band->medium, &band->scene.sun, &options);
    if (status == MURK_OK)
        status = murk_ground_create(context, &options, &band->ground);
    band->scene.ground = band->ground;
    return scene_pass_on(context, status, description, "ground", message);
}

murk_status scene_build_ground(murk_context *context, const struct scene_description *description,
                               struct scene_band *band, char message[SCENE_MESSAGE_SIZE])
{
    struct images images = {0};
    if (!description->ground_named)
        return MURK_OK;
    murk_status status = create_ground(context, description, &images, band, message);
    free(images.reflectance);
    free(images.emission);
    free(images.temperature);
    return status;
}
