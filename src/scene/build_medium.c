/* SPDX-License-Identifier: Apache-2.0 */
#include "build.h"

#include <math.h>

/* kappa_t = mass extinction coefficient times concentration. */
static murk_status take_mass(const struct scene_description *description,
                             murk_medium_options *options, struct scene_band *band, char *message)
{
    const murk_quantity *concentration = &description->concentration;
    const double mass = description->mass_extinction;
    if (isnan(mass))
        return MURK_OK;
    if (!description->has_concentration)
        return scene_refuse(description, "mass_extinction",
                            "needs \"medium\": {\"concentration\": {\"grid\": \"density\", "
                            "\"scale\": 1}} in g/m^3",
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
    murk_status status = take_mass(description, &options, band, message);
    if (status != MURK_OK)
        return status;
    status = murk_medium_from_volume(context, volume, &options, &band->medium);
    return scene_pass_on(context, status, description, "medium", message);
}
