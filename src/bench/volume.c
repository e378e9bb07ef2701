/* SPDX-License-Identifier: Apache-2.0 */
#include "volume.h"

#include "cases.h"

#include <stdlib.h>
#include <string.h>

/* Lights a medium that scatters nothing and emits its own extinction E = kappa_t: this is its
   radiosity then. */
static murk_status solve_extinction(murk_context *context, const murk_volume *volume, double scale,
                                    murk_solution **out)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    murk_medium *medium = NULL;
    options.extinction.scale = scale;
    options.albedo.value = 0;
    options.emission = (murk_quantity){murk_volume_density(volume), scale, 0};
    murk_status status = murk_medium_from_volume(context, volume, &options, &medium);
    const murk_scene scene = {.medium = medium};
    if (!status)
        status = murk_solve(context, &scene, NULL, out);
    murk_medium_release(medium);
    return status;
}

static murk_status take(const murk_solution *solution, struct bench_voxels *out)
{
    size_t count = 0;
    murk_status status = murk_solution_voxels(solution, 0, NULL, NULL, &count);
    int32_t *index = malloc(count * 3 * sizeof *index);
    float *kappa_t = malloc(count * sizeof *kappa_t);
    if (!index || !kappa_t)
        status = MURK_ERROR_MEMORY;
    if (!status)
        status = murk_solution_voxels(solution, count, index, kappa_t, &count);
    for (size_t n = 0; n < count && !status; n++) {
        const int32_t *at = index + 3 * n;
        float *value = kappa_t[n] > 0 ? bench_voxels_at(out, at[0], at[1], at[2]) : NULL;
        if (value)
            *value = kappa_t[n];
        else if (kappa_t[n] > 0)
            status = MURK_ERROR_MEMORY;
    }
    free(index);
    free(kappa_t);
    return status;
}

murk_status bench_volume_read(murk_context *context, const char *path, struct bench_voxels *out)
{
    murk_volume *volume = NULL;
    murk_medium *medium = NULL;
    murk_solution *solution = NULL;
    murk_medium_info info;
    murk_status status = murk_volume_read(context, path, &volume);
    if (!status)
        status = murk_medium_from_volume(context, volume, NULL, &medium);
    if (!status)
        status = murk_medium_info_get(medium, &info);
    if (!status)
        status = solve_extinction(context, volume, info.extinction_scale, &solution);
    if (!status)
        status = take(solution, out);
    if (!status) {
        memcpy(out->voxel_size, info.voxel_size, sizeof out->voxel_size);
        out->albedo = BENCH_ALBEDO;
    }
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_volume_release(volume);
    return status;
}
