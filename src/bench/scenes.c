/* SPDX-License-Identifier: Apache-2.0 */
#include "scenes.h"

#include <math.h>
#include <stdlib.h>

murk_status bench_scene_default(murk_context *context, const murk_medium *medium, murk_scene *scene,
                                murk_ground **ground)
{
    return murk_scene_default(context, medium, MURK_UP_Z, scene, ground);
}

murk_status bench_scene_alone(murk_context *context, const murk_medium *medium, murk_scene *scene,
                              murk_ground **ground)
{
    murk_status status = murk_scene_default(context, medium, MURK_UP_Z, scene, ground);
    if (!status)
        murk_ground_release(*ground);
    scene->ground = *ground = NULL;
    return status;
}

float bench_paper_reflectance(int column, int row, int nx, int ny)
{
    int x = 10 * column / nx, y = 10 * row / ny;
    return y >= 3 && y <= 6 && x >= 3 && x <= 6 ? 0.6f : 0.3f;
}

murk_status bench_scene_paper(murk_context *context, const murk_medium *medium, murk_scene *scene,
                              murk_ground **ground)
{
    murk_medium_info info;
    murk_ground_options options = MURK_GROUND_DEFAULT;
    murk_status status = murk_medium_info_get(medium, &info);
    if (status)
        return status;
    for (int c = 0; c < 2; c++) {
        options.extent_min[c] = info.box_min[c];
        options.extent_max[c] = info.box_max[c];
        options.patches[c] = (int)round((info.box_max[c] - info.box_min[c]) / info.voxel_size[c]);
    }
    int nx = options.patches[0], ny = options.patches[1];
    float *reflectance = malloc((size_t)nx * (size_t)ny * sizeof *reflectance);
    if (!reflectance)
        return MURK_ERROR_MEMORY;
    for (int row = 0; row < ny; row++)
        for (int i = 0; i < nx; i++)
            reflectance[row * nx + i] = bench_paper_reflectance(i, row, nx, ny);
    options.reflectance_image = reflectance;
    options.horizon = false;
    status = murk_ground_create(context, &options, ground);
    free(reflectance);
    if (!status)
        *scene = (murk_scene){.medium = medium, .ground = *ground, .sun = {{0, 0, -1}, 1}};
    return status;
}
