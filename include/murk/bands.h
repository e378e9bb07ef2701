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

/**
 * Solves scenes that differ in albedo, emission, reflectance and light alone - bands, or suns - as
 * murk_solve() does each. Neighbours in the list whose media have the same voxels with the same
 * extinction, and whose grounds have the same patches, are solved together: light of up to three
 * goes along the same lines at once, which is where most of the time goes. They get the voxels of
 * the one that needs the smallest, slopes where any of them does, and at first the directions of
 * the one that needs most. Under suns alone, of one medium object, without ground and sky, one sun
 * tells for all what smaller voxels would change, with a margin in the estimates of the others.
 * Scenes that do not match the one before them are solved after it, which the log tells; so are all
 * by the pairwise method.
 *
 * scene holds `count` scenes; start is NULL, or tells for each where its iteration starts, as
 * options->start does for murk_solve(); options->start itself is not looked at. options may be
 * NULL. The caller has room for `count` solutions in out, which are to be released one by one.
 * Returns MURK_NOT_REACHED, with all solutions, where the estimated error of any stays above the
 * tolerance; on any other failure there are none. The report of each solution holds for it, but for
 * crossings, sweeps and times: these are of all that were solved together.
 */
MURK_API murk_status murk_solve_many(murk_context *context, const murk_scene scene[], size_t count,
                                     const murk_solve_options *options,
                                     const murk_solution *const start[], murk_solution *out[]);

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

/**
 * A picture of size[0] x size[1] pixels, all 0, with the channels that murk_render_bands() gives
 * it, to be asked for before long work: solutions are not looked at, and names not checked. count
 * 0: those of murk_render() without parts.
 */
MURK_API murk_status murk_bands_picture(murk_context *context, const murk_band_view *views,
                                        size_t count, const int size[2], murk_image **out);

/**
 * Writes the solutions of count >= 1 bands as one VDB, as murk_solution_write() does one. name[i],
 * of letters, digits, _ and -, 39 at most, is that of the band of solution[i]; where count is 1,
 * name or name[0] may be NULL.
 *  - Bands named R, G and B, where all three are there on the same voxels, share the vec3s grid
 *    "radiosity" (x = R, y = G, z = B). Any other band has a float grid "radiosity_NAME", or
 * "radiosity" where it is the only one.
 *  - What options add goes by the same rule, but an extinction that all bands share is written
 *    once, as the float grid "extinction". options may be NULL.
 *  - The file metadata "band" lists the names as "R,G,B,LWIR", or is "single" where there is none.
 *    With several bands, sun_irradiance, sky_radiance, tolerance_reached, error_estimate and the
 *    energies are there for each, as sun_irradiance_NAME and so on; so are others that differ.
 * Fails with MURK_ERROR_INPUT where solutions are not on one transform, or a name is missing, there
 * twice or no such name. Messages go to the context of solution[0].
 */
MURK_API murk_status murk_solutions_write(const murk_solution *const *solution,
                                          const char *const *name, size_t count, const char *path,
                                          const murk_write_options *options);

/**
 * Takes the solution of one band from a volume, as murk_solution_from_volume() does: from the grid
 * "radiosity_NAME", for R, G and B else from the component of a vec3s "radiosity", and for any name
 * else from a float "radiosity" that is the only one, unless the file says that it is of another
 * band. name NULL: from the float "radiosity". Fails with MURK_ERROR_INPUT, naming the radiosities
 * that there are, for a band that is not there.
 */
MURK_API murk_status murk_solution_from_volume_band(murk_context *context, const murk_scene *scene,
                                                    const murk_volume *volume, const char *name,
                                                    murk_solution **out);

#ifdef __cplusplus
}
#endif
#endif
