/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file bands.h
 * One scene in several bands of wavelengths: visible, near infrared, thermal. Every band is a
 * murk_scene of its own, with the coefficients and lights that it has there.
 */
#ifndef MURK_BANDS_H
#define MURK_BANDS_H

#include "band.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A band to take a picture of. */
typedef struct murk_band_view {
    const char *name; /**< of letters, digits, _ and -: "R", "LWIR" */
    murk_band band;   /**< may be unknown; there are no temperatures then */
    /** Of the medium per mass [m^2/g], for its amount along the lines of sight; 0: unknown. */
    double mass_extinction;
    const murk_scene *scene;
    const murk_solution *solution;
} murk_band_view;

/**
 * Renders what a sensor sees in each of count >= 1 bands, as murk_render() does one. The channels
 * of the picture, row 0 at the top:
 *  - R, G, B, A, transmittance.Y, path.*, surface.* and Z of murk_render(): of the bands named R, G
 *    and B where there are all three (A = 1 - the mean of their transmittances), else of the first
 *    band for all three;
 *  - for each band NAME.radiance [W/m^2/sr] = NAME.surface + NAME.scattered + NAME.emitted: light
 *    of ground, sky or background as it comes through, and the two parts of the path radiance;
 *    NAME.transmittance; NAME.inherent, the surface's light before it enters the medium; and, where
 *    the band is known, NAME.temperature [K], the apparent temperature of the radiance;
 *  - CL.Y [g/m^2], concentration times length along the line of sight, by the first band with a
 *    mass extinction.
 * The attribute "murk:bands" lists bands and wavelengths [m]: "R:6e-07:7e-07,LWIR:8e-06:1.2e-05".
 * Of a background picture the band takes the channel of its name, R for bands other than R, G, B.
 * options may be NULL; options->parts is taken as set. Fails like murk_render(), and for names that
 * are empty, hold other signs, or are there twice.
 */
MURK_API murk_status murk_render_bands(murk_context *context, const murk_band_view *views,
                                       size_t count, const murk_camera *camera,
                                       const murk_render_options *options, murk_image **out);

#ifdef __cplusplus
}
#endif
#endif
