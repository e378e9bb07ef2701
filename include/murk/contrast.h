/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file contrast.h
 * What can still be seen through the medium: contrast of a target against its background in the
 * bands of a picture.
 *
 * A picture of a band NAME has the channels NAME.radiance, NAME.inherent (the same light before it
 * enters the medium), NAME.scattered and NAME.emitted (what the medium adds), all in [W/m^2/sr], or
 * [W/m^2/sr/um] where the band is one wavelength, and NAME.transmittance; where concentrations are
 * known CL.Y [g/m^2], the concentration times the length along the line of sight. Its attribute
 * murk:bands lists the bands and their wavelengths [m]: "R:6e-07:7e-07,LWIR:8e-06:1.2e-05", both 0
 * where they are not known.
 */
#ifndef MURK_CONTRAST_H
#define MURK_CONTRAST_H

#include "band.h"
#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A band that a picture shows. */
typedef struct murk_picture_band {
    char name[MURK_BAND_NAME_MAX + 1];
    murk_band band; /**< both wavelengths 0: not known */
} murk_picture_band;

/**
 * Copies what murk:bands says of the first `capacity` bands of a picture; *count is the number
 * there are in all. Fails with MURK_ERROR_INPUT where a picture has no bands, or a list that is
 * none.
 */
MURK_API murk_status murk_picture_bands(murk_context *context, const murk_image *picture,
                                        size_t capacity, murk_picture_band *bands, size_t *count);

/** Pixels of a picture: those of a rectangle, or of a mask. */
typedef struct murk_region {
    int x, y;               /**< the rectangle's pixel at the top left; row 0 is on top */
    int width, height;      /**< >= 1; the rectangle must not reach outside of the picture */
    const murk_image *mask; /**< NULL: the rectangle. Else an image of the picture's size, whose
                                 pixels count where the first channel is above 0.5. Borrowed */
} murk_region;

/** Means over the pixels of a region. */
typedef struct murk_region_mean {
    uint64_t pixels;
    double radiance;             /**< apparent: through the medium [W/m^2/sr] */
    double inherent;             /**< without it [W/m^2/sr] */
    double scattered, emitted;   /**< path radiance [W/m^2/sr] */
    double transmittance;        /**< of the medium along the line of sight */
    double optical_depth;        /**< -ln of the mean transmittance */
    double temperature;          /**< of the black body with the mean radiance [K] */
    double temperature_inherent; /**< with the mean inherent radiance [K] */
    double cl;                   /**< [g/m^2] */
} murk_region_mean;

/** The sensor that sees the picture; NaN for what is not known of it. */
typedef struct murk_sensor {
    double netd; /**< noise-equivalent temperature difference [K] */
    double snr;  /**< signal-to-noise ratio at the radiance of the background */
} murk_sensor;

/**
 * Contrast of a target t against a background b, from the mean radiances L of their pixels; 0 marks
 * what is inherent. NaN stands for what is not known: temperatures without wavelengths, cl without
 * concentrations, quotients by 0.
 *
 *     C = (L_t - L_b) / L_b        C0 = (L_t0 - L_b0) / L_b0
 *
 * (S. Q. Duntley, "The reduction of apparent contrast by the atmosphere", J. Opt. Soc. Am. 38, 179,
 * 1948). Where transmittance tau and path radiance L_p are the same for both, L = tau L0 + L_p and
 *
 *     C / C0 = tau L_b0 / (tau L_b0 + L_p).
 */
typedef struct murk_contrast {
    murk_region_mean target, background;
    double inherent;      /**< C0 */
    double apparent;      /**< C */
    double transmittance; /**< C / C0, the contrast transmittance */
    double dt_inherent;   /**< difference of the inherent temperatures, target - background [K] */
    double dt_apparent;   /**< of the apparent ones [K] */
    double cnr_thermal;   /**< contrast-to-noise ratio |dt_apparent| / NETD */
    double cnr_radiance;  /**< |C| SNR */
} murk_contrast;

/**
 * Measures the contrast in a band of a picture. Pixels that are in both regions count for the
 * target alone, so the background may be a rectangle around the target. sensor may be NULL. Fails
 * with MURK_ERROR_INPUT where the picture lacks a channel of the band, a rectangle reaches outside,
 * a mask has another size, or a region has no pixel.
 */
MURK_API murk_status murk_contrast_measure(murk_context *context, const murk_image *picture,
                                           const murk_picture_band *band, const murk_region *target,
                                           const murk_region *background, const murk_sensor *sensor,
                                           murk_contrast *out);

#ifdef __cplusplus
}
#endif
#endif
