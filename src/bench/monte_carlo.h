/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A Monte Carlo that shares no code with the library: packets of light run through a dense array of
 * voxels over a plane of patches. Every zone on a flight gets the part of the packet that it is
 * expected to extinguish. Where the flight ends is drawn; there the packet scatters, with the
 * albedo as its weight, until Russian roulette ends it.
 *
 * What leaves a zone begins, by what the Monte Carlo is asked for,
 *  - at a point uniformly distributed in the zone: the zonal model, whose source, 4 kappa B per
 *    volume, is constant in a zone. Zones and patches then have the expected radiosities of [BG91]
 *    eqs. (1), (2), without any quadrature;
 *  - at the very point where it was extinguished (`exact`): the equation of transfer for
 * extinction, albedo and emission that are constant in a voxel. Patches reflect by Lambert's law,
 * likewise.
 */
#ifndef BENCH_MONTE_CARLO_H
#define BENCH_MONTE_CARLO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct bench_mc_scene {
    int size[3];             /* zones [i][j][k], the last index fastest */
    double voxel[3], low[3]; /* m */
    const float *kappa_t, *albedo, *emission;
    double asymmetry; /* g of the phase function of Henyey and Greenstein, in (-1, 1) */

    int patches[2]; /* columns along x, rows along y; 0: no ground, the sky is all around */
    double height, ground_low[2], ground_high[2];      /* m; below the medium; black beyond */
    const float *ground_reflectance, *ground_emission; /* [row][column], both ascending */

    double sun[3]; /* direction of travel, a unit vector */
    double irradiance, sky_radiance;
};

/* Powers [W]. */
struct bench_mc_tally {
    double *zone;   /* extinguished in each zone: kappa_t V G */
    double *patch;  /* incident on each patch: A H, sun included */
    double sun;     /* extinguished sunlight */
    double diffuse; /* extinguished light of sky and ground */
    double escaped; /* light of the zones that leaves the medium */
};

/* Adds to a tally of zeros: `packets` from each of sun, sky, zones and patches (where they shine),
   and as many for what sun and sky send directly to the ground. The same seed, the same tally.
   False when memory runs out. */
bool bench_mc_run(const struct bench_mc_scene *scene, bool exact, uint64_t seed, long packets,
                  struct bench_mc_tally *tally);

size_t bench_mc_zones(const struct bench_mc_scene *scene);
size_t bench_mc_patches(const struct bench_mc_scene *scene);

/* The radiosities [W/m^2] that a tally stands for: means over zones and patches. Zones without
   extinction have 0. */
void bench_mc_radiosity(const struct bench_mc_scene *scene, const struct bench_mc_tally *tally,
                        double *zone, double *patch);

/* Means of independent batches and their standard errors, for each zone and each patch. */
struct bench_mc_result {
    double *zone, *zone_error;
    double *patch, *patch_error;
};

/* `batches` >= 2 batches of `packets` in all as in bench_mc_run(), on `threads` threads (0: as many
   as OpenMP takes), which do not change the result. Fills the caller's arrays; false when memory
   runs out. */
bool bench_mc_solve(const struct bench_mc_scene *scene, bool exact, long packets, int batches,
                    int threads, struct bench_mc_result *result);

#endif
