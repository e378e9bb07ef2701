/* SPDX-License-Identifier: Apache-2.0 */
#include "build.h"
#include "obscurant.h"

#include <math.h>
#include <stdlib.h>

/* What the obscurant's file says of the band. */
static murk_status take_obscurant(const struct scene_description *description,
                                  murk_medium_options *options, double *mass, char *message)
{
    struct scene_obscurant obscurant;
    struct scene_optics optics = {0};
    if (!description->obscurant)
        return MURK_OK;
    char *path = scene_path(description, description->obscurant);
    if (!path)
        return scene_refuse(description, "obscurant", "out of memory", message);
    murk_status status = scene_obscurant_read(path, &obscurant, message);
    free(path);
    if (status != MURK_OK)
        return status;
    status = scene_obscurant_band(&obscurant, description->wavelength.wavelength, &optics, message);
    scene_obscurant_release(&obscurant);
    if (status != MURK_OK)
        return status;
    *mass = optics.mass_extinction;
    if (!description->albedo_named)
        options->albedo = (murk_quantity){NULL, 1.0, optics.albedo};
    if (!description->asymmetry_named)
        options->asymmetry = optics.asymmetry;
    return MURK_OK;
}

/* kappa_t = mass extinction coefficient times concentration. */
static murk_status take_mass(const struct scene_description *description, double mass,
                             murk_medium_options *options, struct scene_band *band, char *message)
{
    const murk_quantity *concentration = &description->concentration;
    if (isnan(mass))
        return MURK_OK;
    if (!description->has_concentration)
        return scene_refuse(description, description->obscurant ? "obscurant" : "mass_extinction",
                            "needs \"medium\": {\"concentration\": {\"grid\": \"density\", "
                            "\"scale\": 1}} in g/m^3, or --concentration",
                            message);
    options->extinction = *concentration;
    options->extinction.scale *= mass;
    if (!concentration->grid && concentration->value != MURK_FROM_GRID)
        options->extinction.value *= mass;
    band->mass_extinction = mass;
    return MURK_OK;
}

murk_status scene_build_medium(murk_context *context, const struct scene_description *description,
                               const murk_volume *volume, struct scene_band *band,
                               char message[SCENE_MESSAGE_SIZE])
{
    murk_medium_options options = description->medium;
    double mass = description->mass_extinction;
    murk_status status = take_obscurant(description, &options, &mass, message);
    if (status == MURK_OK)
        status = take_mass(description, mass, &options, band, message);
    if (status != MURK_OK)
        return status;
    status = murk_medium_from_volume(context, volume, &options, &band->medium);
    return scene_pass_on(context, status, description, "medium", message);
}
