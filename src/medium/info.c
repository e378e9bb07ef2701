/* SPDX-License-Identifier: Apache-2.0 */
#include "medium.h"

#include <math.h>
#include <string.h>

/* Optical depth along the shortest index axis, one sum a column of voxels. */
static void find_depth(const murk_medium *medium, murk_medium_info *info)
{
    const murk_grid *grid = medium->grid;
    int axis = 0;
    int64_t size[3];
    for (int a = 0; a < 3; a++) {
        size[a] = (int64_t)grid->hi[a] - grid->lo[a];
        if ((double)size[a] * grid->voxel[a] < (double)size[axis] * grid->voxel[axis])
            axis = a;
    }
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (size[u] * size[v] > (int64_t)1 << 28)
        return; /* columns that would not fit: far-flung voxels */
    double *column = murk_alloc((size_t)(size[u] * size[v]), sizeof *column);
    if (!column)
        return;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            const int in[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
            float k = medium->kappa_t[b * MURK_BRICK_SLOTS + (size_t)slot];
            if (!(k > 0))
                continue;
            int64_t i = (int64_t)grid->brick[b][u] * 8 + in[u] - grid->lo[u];
            int64_t j = (int64_t)grid->brick[b][v] * 8 + in[v] - grid->lo[v];
            column[j * size[u] + i] += k * grid->voxel[axis];
        }
    size_t used = 0;
    for (int64_t i = 0; i < size[u] * size[v]; i++) {
        used += column[i] > 0;
        info->mean_depth += column[i];
        info->max_depth = fmax(info->max_depth, column[i]);
    }
    if (used)
        info->mean_depth /= (double)used;
    murk_free(column);
}

murk_status murk_medium_info_get(const murk_medium *medium, murk_medium_info *out)
{
    const murk_grid *grid = medium->grid;
    murk_medium_info info = {.zones = grid->zone_count,
                             .bricks = grid->brick_count,
                             .input_voxels = medium->input->zone_count,
                             .invalid_voxels = medium->invalid_voxels,
                             .extinction_scale = medium->extinction_scale};
    memcpy(info.voxel_size, grid->voxel, sizeof info.voxel_size);
    for (int c = 0; c < 8; c++) {
        double frame[3], world[3];
        for (int a = 0; a < 3; a++)
            frame[a] = c >> a & 1 ? ((double)grid->hi[a] - grid->lo[a]) * grid->voxel[a] : 0;
        murk_grid_to_world(grid, frame, world);
        for (int a = 0; a < 3; a++) {
            info.box_min[a] = c ? fmin(info.box_min[a], world[a]) : world[a];
            info.box_max[a] = c ? fmax(info.box_max[a], world[a]) : world[a];
        }
    }
    for (size_t i = 0; i < grid->brick_count * MURK_BRICK_SLOTS; i++)
        info.kappa_t_max = fmax(info.kappa_t_max, medium->kappa_t[i]);
    if (grid->brick_count)
        find_depth(medium, &info);
    *out = info;
    return MURK_OK;
}
