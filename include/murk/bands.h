/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file bands.h
 * Solutions of several named bands ("R", "G", "B", "NIR", ...): one scene and one solution a band,
 * all on the voxels of one volume.
 */
#ifndef MURK_BANDS_H
#define MURK_BANDS_H

#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Writes the solutions of count >= 1 bands as one VDB, as murk_solution_write() does one. name[i],
 * up to 31 letters, digits, '_', '-' and '.', is that of the band of solution[i]; where count is 1,
 * name or name[0] may be NULL.
 *  - Bands named R, G and B, where all three are there, share the vec3s grid "radiosity" (x = R,
 *    y = G, z = B). Any other band has a float grid "radiosity_NAME", or "radiosity" where it is
 *    the only one.
 *  - What options add goes by the same rule, but an extinction that all bands share is written
 *    once, as the float grid "extinction". options may be NULL.
 *  - The file metadata "band" lists the names as "R,G,B,LWIR", or is "single" where there is none.
 *    With several bands, sun_irradiance, sky_radiance, tolerance_reached, error_estimate and the
 *    energies are there for each, as sun_irradiance_NAME and so on; so are others that differ.
 * Fails with MURK_ERROR_INPUT where solutions are not on the same voxels, or a name is missing,
 * there twice or no such name. Messages go to the context of solution[0].
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
