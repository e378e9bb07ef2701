/* SPDX-License-Identifier: Apache-2.0 */
/* Packets of light on their way through voxels and over patches. */
#ifndef BENCH_MONTE_CARLO_PACKET_H
#define BENCH_MONTE_CARLO_PACKET_H

#include "monte_carlo.h"

/* In place of a patch: the sky, and the plane of the ground beyond the patches. */
enum { BENCH_MC_NOWHERE = -1, BENCH_MC_BEYOND = -2 };

/* What is left of a packet behind this depth, 1e-17, changes no sum. */
#define BENCH_MC_DEEPEST 40

/* Where a straight flight began. */
enum bench_mc_origin { FROM_SUN, FROM_OUTSIDE, FROM_ZONE };

/* Coordinates of a packet at its start that are spread evenly: which element or side, place,
   direction. */
enum { CHOICE, PLACE, ALONG = PLACE + 3, SPREAD = ALONG + 2 };

struct bench_mc_walk {
    const struct bench_mc_scene *scene;
    struct bench_mc_tally *tally;
    bool exact;
    uint64_t random;
    double spread[SPREAD];
    double box_high[3], patch_size[2];
    double cell_volume, patch_area;
};

/* A packet on its way: the power w it stands for, and its power when it started. */
struct bench_mc_packet {
    double at[3], along[3], w, start;
    enum bench_mc_origin origin;
};

/* A walk that puts nothing down in a tally. */
void bench_mc_walk_begin(struct bench_mc_walk *walk, const struct bench_mc_scene *scene,
                         uint64_t seed);

/* A number in (0, 1). */
double bench_mc_draw(struct bench_mc_walk *walk);

/* A sequence of points that are spread evenly: begins at random, so that batches are independent;
   each point by itself is uniformly distributed. */
void bench_mc_spread_begin(struct bench_mc_walk *walk);
void bench_mc_spread_next(struct bench_mc_walk *walk);

/* Directions from two numbers in (0, 1): uniformly distributed over the sphere, or with the density
   cos(theta)/pi about an axis, towards its positive or negative end. */
void bench_mc_turn_isotropic(double u, double v, double out[3]);
void bench_mc_turn_lambertian(double u, double v, int axis, double sign, double out[3]);

/* Turns a unit vector by an angle distributed as Henyey and Greenstein (1941) have it for g. */
void bench_mc_turn_scattered(double g, double u, double v, double along[3]);

/* Points of zones and patches at fractions of their edges. */
void bench_mc_place_in_zone(const struct bench_mc_walk *walk, int zone, const double part[3],
                            double at[3]);
void bench_mc_place_on_patch(const struct bench_mc_walk *walk, int patch, const double part[2],
                             double at[3]);

/* Transmittance of the medium from a point on. */
double bench_mc_transmittance(const struct bench_mc_walk *walk, const double at[3],
                              const double along[3]);

/* The patch that a line meets, or one of the above; where it meets the plane, if it does. */
int bench_mc_find_patch(const struct bench_mc_walk *walk, const double at[3], const double along[3],
                        double meets[3]);

/* Sends a packet that is on a patch on its way. */
void bench_mc_leave_patch(struct bench_mc_walk *walk, int patch, struct bench_mc_packet *p);

/* Follows a packet to its end. `direct`: light of sun and sky, whose transmitted part is accounted
   for at the patches. */
void bench_mc_follow(struct bench_mc_walk *walk, struct bench_mc_packet *p, bool direct);

#endif
