/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a camera sees, by a Monte Carlo that shares no code with the library: paths of light are
 * followed back from the pixels through a dense array of voxels over a plane of patches. Flights
 * end where extinction wants it, light is scattered by the phase function of Henyey and Greenstein,
 * and at every end the sun adds what comes straight from it. It has no other error than its noise.
 */
#ifndef BENCH_MONTE_CARLO_VIEW_H
#define BENCH_MONTE_CARLO_VIEW_H

#include "monte_carlo.h"
#include "murk/murk.h"

/* A rectangle of pixels of a camera above the ground, row 0 on top. */
struct bench_mc_view {
    const struct bench_mc_scene *scene;
    murk_camera camera;
    int left, top, width, height;
    bool horizon; /* the ground goes on beyond the patches with their means, else black */
};

/* A mean of independent batches and its standard error [W/m^2/sr]. */
struct bench_mc_mean {
    double value, error;
};

struct bench_mc_radiance {
    struct bench_mc_mean surface; /* light of ground and sky that meets nothing on its way */
    struct bench_mc_mean path;    /* light that the medium sends */
    struct bench_mc_mean total;
};

/* The mean radiance of the rectangle, from `batches` >= 2 batches of `paths` in all, on `threads`
   threads (0: as many as OpenMP takes), which do not change the result. False when memory runs
   out. */
bool bench_mc_view_radiance(const struct bench_mc_view *view, long paths, int batches, int threads,
                            struct bench_mc_radiance *out);

/* The phase function of Henyey and Greenstein [1/sr]; its integral over the sphere is 1. */
double bench_mc_phase(double g, double cosine);

#endif
