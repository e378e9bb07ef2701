/* SPDX-License-Identifier: Apache-2.0 */
/* Reproducible randomness: numbers, and noise in space. */
#ifndef BENCH_NOISE_H
#define BENCH_NOISE_H

#include <stdint.h>

/* The next number in [0, 1) of the sequence that *state starts (splitmix64). */
double bench_random(uint64_t *state);

/* Sum of octaves of value noise at a point, each with half the wavelength and `gain` times the
   amplitude of the one before; within about +-1 and 0 on average. The first has the wavelength 1.
 */
double bench_noise(const double point[3], int octaves, double gain, uint32_t seed);

#endif
