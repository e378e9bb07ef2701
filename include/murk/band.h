/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file band.h
 * Bands of wavelengths, and the thermal radiation of black bodies in them.
 */
#ifndef MURK_BAND_H
#define MURK_BAND_H

#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Whether 0 < wavelength[0] <= wavelength[1], both finite. */
MURK_API bool murk_band_valid(const murk_band *band);

/** Whether a text can name a band: 1 to MURK_BAND_NAME_MAX letters, digits, _ and -. */
MURK_API bool murk_band_name_valid(const char *name);
enum { MURK_BAND_NAME_MAX = 39 };

/**
 * Planck's radiance of a black body, integrated over the band [W/m^2/sr], or [W/m^2/sr/um] at one
 * wavelength: 2 k^4 T^4 / (h^3 c^2) times the integral of x^3 / (e^x - 1) over x = h c / (lambda k
 * T), by its series on both sides of x = 1; good to 1e-12 of the radiance of all wavelengths, or of
 * that of the band where it lies at x > 1. 0 for temperatures [K] that are not above 0. The
 * emissive power E of murk.h is pi times this.
 */
MURK_API double murk_planck_radiance(const murk_band *band, double kelvin);

/** The apparent (brightness) temperature [K]: that of the black body with this radiance in the
 *  band, to 1e-9 of itself. 0 for a radiance that is not above 0. */
MURK_API double murk_planck_temperature(const murk_band *band, double radiance);

#ifdef __cplusplus
}
#endif
#endif
