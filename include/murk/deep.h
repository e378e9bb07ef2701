/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file deep.h
 * Deep pictures: for each pixel not one value but samples along the depth, between which other
 * things can be put.
 */
#ifndef MURK_DEEP_H
#define MURK_DEEP_H

#include "bands.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A part of a pixel, as in "Interpreting OpenEXR Deep Pixels" (F. Kainz, 2013). Where z < z_back it
 * is a volume, alike all the way: of its first part f, the opacity is A' = 1 - (1 - a)^f and the
 * light A'/a times that of all.
 */
typedef struct murk_deep_sample {
    float r, g, b;   /**< [W/m^2/sr], premultiplied: less what nearer samples take of it */
    float a;         /**< opacity, of the medium alone */
    float z, z_back; /**< where it begins and ends, along the camera's viewing axis [m] */
} murk_deep_sample;

typedef struct murk_deep murk_deep;

/**
 * Renders a picture whose samples, each `over` the next, give R, G, B and A of the picture that
 * murk_render_bands() renders of the same bands: of those named R, G and B where there are all
 * three, else of the first for all three colours. The name may be NULL where there is one band.
 *
 * The medium becomes volumes that do not overlap, front to back, as few as give opacity and light
 * before any depth within 1 % of the pixel's. For N rays a pixel they are of the means
 *
 *     T(z) = sum e^{-t(z)} / N      L(z) = sum L(z) / N
 *
 * of transmittance and light before z: from z1 to z2 a = 1 - T(z2)/T(z1) and r = (L(z2) - L(z1)) /
 * T(z1), exactly. The light of ground, sky or background is one last sample without extent and
 * without opacity (a = 0, since A is the medium's), at the depth where the farthest ray of the
 * pixel meets the ground, or 1e30 m where one does not. A pixel with nothing in it has no samples.
 *
 * options may be NULL; options->parts is not looked at. Fails like murk_render_bands().
 */
MURK_API murk_status murk_render_deep(murk_context *context, const murk_band_view *views,
                                      size_t count, const murk_camera *camera,
                                      const murk_render_options *options, murk_deep **out);
MURK_API void murk_deep_release(murk_deep *deep);

/** Pixels of the picture. */
MURK_API void murk_deep_size(const murk_deep *deep, int size[2]);

/** The samples of pixel (i, j), j = 0 at the top, owned by the picture; returns their number. */
MURK_API size_t murk_deep_samples(const murk_deep *deep, int i, int j,
                                  const murk_deep_sample **samples);

/** Writes a deep .exr with the float channels R, G, B, A, Z, ZBack, whole or not at all. options
 *  may be NULL; there is no exposure. Fails like murk_image_write(), and for other formats. */
MURK_API murk_status murk_deep_write(murk_context *context, const murk_deep *deep, const char *path,
                                     const murk_image_write_options *options);

#ifdef __cplusplus
}
#endif
#endif
