/* SPDX-License-Identifier: Apache-2.0 */
/* The error of radiosities against others. */
#ifndef BENCH_ERROR_H
#define BENCH_ERROR_H

#include "voxels.h"

/* The radiosity of every zone, one float for each value of voxels->kappa_t. */
void bench_error_take(const murk_solution *solution, const struct bench_voxels *voxels,
                      float *radiosity);

/* The kappa_t-weighted relative L2 norm of the difference over the zones, and the 95th percentile
   of the relative difference of a zone. */
murk_status bench_error_find(const float *radiosity, const struct bench_voxels *voxels,
                             const float *reference, double *error, double *error_95);

#endif
