/* SPDX-License-Identifier: Apache-2.0 */
/* One scene for the library and for the Monte Carlo, and what both say of it. */
#ifndef SETTING_H
#define SETTING_H

#include "check.h"

#include "monte_carlo.h"

enum { BATCHES = 64, MOST_ZONES = 8000, MOST_PATCHES = 600, MOST_VALUES = 24 };
enum { MOST = MOST_ZONES + MOST_PATCHES };

struct setting {
    struct bench_mc_scene mc;
    float kappa_t[MOST_ZONES], albedo[MOST_ZONES], emission[MOST_ZONES];
    float rho[MOST_PATCHES], glow[MOST_PATCHES];
};

/* Voxels of 0.1 m that hold nothing, from the origin on; no ground, sun or sky. */
struct bench_mc_scene *setting_start(struct setting *s, int nx, int ny, int nz);

void setting_fill(struct setting *s, double kappa_t, double albedo);

/* Patches of a voxel's size under the medium and `beyond` more on each side. */
void setting_lay_ground(struct bench_mc_scene *s, int beyond, double gap);

void setting_sun(struct bench_mc_scene *s, double x, double y, double z);

int zone_count(const struct bench_mc_scene *s);
int patch_count(const struct bench_mc_scene *s);
/* kappa_t V. */
double optical_volume(const struct bench_mc_scene *s, int zone);

/* The scene in the library. */
void setting_open(const struct bench_mc_scene *s, int threads, struct world *w);

/* Radiosities of the library's solution: zones, then patches. */
void setting_solution(const struct bench_mc_scene *s, const struct world *w, double *b);

/* Independent batches of the Monte Carlo: radiosities of zones, then of patches, and values that
   tests derive. */
struct batches {
    double b[BATCHES][MOST], value[BATCHES][MOST_VALUES];
};

/* What a batch adds to its row of values, or NULL. */
typedef void batch_fn(const struct bench_mc_scene *s, const struct bench_mc_tally *tally,
                      const double *b, double *value);

void batches_run(const struct bench_mc_scene *s, bool exact, long packets, batch_fn *derive,
                 struct batches *out);

/*
 * The squared L2 distance of b to the expectation of the batches, without their noise: the mean U
 * of <b - b_n, b - b_m> over n != m. With C the covariance of a batch and a the distance, its
 * variance is 4 a C a / N + 2 tr C^2 / (N (N - 1)) (Hoeffding 1948), where a C a <= |a|^2 (tr
 * C^2)^(1/2) and tr C^2 is the mean of <e_n, e_m>^2 over independent deviations.
 */
struct distance {
    double squared; /* U / |b|^2 */
    double error_0; /* its standard error where a = 0, likewise ... */
    double error_1; /* ... and what a^2 adds: (error_0^2 + error_1^2 a^2)^(1/2) */
};

/* Over the elements first ... first + count - 1. */
struct distance batches_distance(const struct batches *mc, int first, int count,
                                 const double *weight, const double *b);

/* The standard error of U at the distance a. */
double distance_error(const struct distance *d, double a);

#endif
