/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A Monte Carlo of the zonal model that shares no code with the library: packets of light run
 * through a dense array of voxels over a plane of patches. What a zone extinguishes it scatters
 * with its albedo, isotropically, from a point uniformly distributed in the zone: the zone method's
 * source, 4 kappa B per volume, is constant in a zone. A patch sends on with its reflectance, by
 * Lambert's law, from a uniformly distributed point of the patch. So zones and patches have the
 * expected radiosities of [BG91] eqs. (1), (2), without any quadrature.
 */
#ifndef MONTE_CARLO_H
#define MONTE_CARLO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct mc_scene {
    int size[3];             /* zones [i][j][k], the last index fastest */
    double voxel[3], low[3]; /* m */
    const float *kappa_t, *albedo, *emission;

    int patches[2]; /* columns along x, rows along y; 0: no ground, the sky is all around */
    double height, ground_low[2], ground_high[2];      /* m; below the medium; black beyond */
    const float *ground_reflectance, *ground_emission; /* [row][column], both ascending */

    double sun[3]; /* direction of travel, a unit vector */
    double irradiance, sky_radiance;
} mc_scene;

/* Powers [W]. */
typedef struct mc_tally {
    double *zone;   /* extinguished in each zone: kappa_t V G */
    double *patch;  /* incident on each patch: A H, sun included */
    double sun;     /* extinguished sunlight */
    double diffuse; /* extinguished light of sky and ground */
    double escaped; /* light of the zones that leaves the medium */
} mc_tally;

/* Adds to a tally of zeros: `packets` from each of sun, sky, zones and patches (where they shine),
   and as many for what sun and sky send directly to the ground. The same seed, the same tally. */
void mc_run(const mc_scene *scene, uint64_t seed, long packets, mc_tally *tally);

#endif
