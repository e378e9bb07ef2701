/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file bands.h
 * Several scenes with one extinction, solved together: bands of wavelengths, or suns.
 */
#ifndef MURK_BANDS_H
#define MURK_BANDS_H

#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Solves scenes that differ in albedo, emission, reflectance and light alone: each as murk_solve()
 * does, but neighbours in the list whose media have the same voxels with the same extinction, and
 * whose grounds have the same patches, together: light of up to three goes along the same lines at
 * once, which is what most of the time goes into. They get the voxels
 * of the one that needs most, and slopes where any of them does. Scenes that do not match the one
 * before them are solved after it, which the log tells; so are all by the pairwise method.
 *
 * scene holds `count` scenes, start NULL or for each of them where its iteration starts, as
 * options->start does for murk_solve(); options->start itself is not looked at. options may be
 * NULL. The caller gives out room for `count` solutions, which are to be released one by one.
 * Returns MURK_NOT_REACHED, with all solutions, where the estimated error of any stays above the
 * tolerance; on any other failure none is made. The report of each solution holds for it, but for
 * crossings, sweeps and times: these are those of all that were solved together.
 */
MURK_API murk_status murk_solve_many(murk_context *context, const murk_scene scene[], size_t count,
                                     const murk_solve_options *options,
                                     const murk_solution *const start[], murk_solution *out[]);

#ifdef __cplusplus
}
#endif
#endif
