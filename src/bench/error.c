/* SPDX-License-Identifier: Apache-2.0 */
#include "error.h"

#include "statistics.h"

#include <math.h>
#include <stdlib.h>

void bench_error_take(const murk_solution *solution, const struct bench_voxels *voxels,
                      float *radiosity)
{
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++) {
        int32_t index[3];
        if (voxels->kappa_t[i] == 0)
            continue;
        bench_voxels_index(voxels, i, index);
        radiosity[i] = (float)murk_solution_radiosity(solution, index);
    }
}

murk_status bench_error_find(const float *radiosity, const struct bench_voxels *voxels,
                             const float *reference, double *error, double *error_95)
{
    double *relative = malloc(voxels->count * BENCH_SLOTS * sizeof *relative);
    double difference = 0, size = 0;
    size_t zones = 0;
    if (!relative)
        return MURK_ERROR_MEMORY;
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++) {
        double kappa_t = voxels->kappa_t[i], b = reference[i];
        if (kappa_t == 0)
            continue;
        double off = radiosity[i] - b;
        difference += kappa_t * off * off;
        size += kappa_t * b * b;
        relative[zones++] = fabs(off) / b;
    }
    *error = sqrt(difference / size);
    *error_95 = bench_quantile(relative, zones, 0.95);
    free(relative);
    return MURK_OK;
}
