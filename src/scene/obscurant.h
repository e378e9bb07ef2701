/* SPDX-License-Identifier: Apache-2.0 */
/* A file of one aerosol: what a gram of it does to light, by wavelength. */
#ifndef SCENE_OBSCURANT_H
#define SCENE_OBSCURANT_H

#include "scene.h"

/* Of a medium in a band, or at a wavelength. */
struct scene_optics {
    double mass_extinction; /* [m^2/g] */
    double albedo;          /* single-scattering albedo in [0, 1] */
    double asymmetry;       /* g, the mean cosine of the scattering angle, in (-1, 1) */
};

struct scene_obscurant {
    char *path;         /* of the file, for messages */
    char *name;         /* "soot smoke", or NULL */
    char *source;       /* what was measured by whom, or NULL */
    size_t count;       /* >= 1 */
    double *wavelength; /* [m], ascending */
    struct scene_optics *optics;
};

/*
 * Reads a JSON file such as {"name": "soot smoke", "source": "...", "wavelength": [4e-7, 7e-7],
 * "mass_extinction": [10, 8], "albedo": 0.25, "asymmetry": [0.4, 0.3]}: one value for each
 * wavelength, or one for all. On failure message holds one line that names the file, the key, what
 * is wrong and what would be right; there is nothing to release then.
 */
murk_status scene_obscurant_read(const char *path, struct scene_obscurant *out,
                                 char message[SCENE_MESSAGE_SIZE]);
void scene_obscurant_release(struct scene_obscurant *obscurant);

/*
 * The means over a band of wavelengths [m], where all values run linearly from one wavelength of
 * the file to the next: of the extinction k by wavelength, of the albedo a weighted with k, of the
 * asymmetry weighted with the scattering k a; each by the trapezoidal rule over the wavelengths of
 * the file and the band's ends. Both ends the same: the values there. MURK_ERROR_INPUT with one
 * line in message where the band is not within the wavelengths of the file.
 */
murk_status scene_obscurant_band(const struct scene_obscurant *obscurant,
                                 const double wavelength[2], struct scene_optics *out,
                                 char message[SCENE_MESSAGE_SIZE]);

#endif
