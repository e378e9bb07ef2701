/* SPDX-License-Identifier: Apache-2.0 */
/* Prints what a VDB file holds: 01_info FILE.vdb */
#include <murk/murk.h>

#include <stdio.h>

static murk_status print_grids(const murk_volume *volume)
{
    for (size_t i = 0; i < murk_volume_grid_count(volume); i++) {
        murk_grid_info grid;
        murk_status status = murk_volume_grid_info(volume, i, &grid);
        if (status)
            return status;
        printf("%-12s %-6s %8llu voxels of %g m, ", grid.name, grid.type,
               (unsigned long long)grid.active_voxels, grid.voxel_size[0]);
        if (grid.readable)
            printf("values %.3g ... %.3g\n", grid.value_min, grid.value_max);
        else
            printf("%s\n", grid.unreadable);
    }
    return MURK_OK;
}

/* Options that are NULL stand for the defaults: the density, scaled to a visible depth. */
static murk_status print_medium(murk_context *context, const murk_volume *volume)
{
    murk_medium *medium;
    murk_medium_info info;
    murk_status status = murk_medium_from_volume(context, volume, NULL, &medium);
    if (status)
        return status;
    status = murk_medium_info_get(medium, &info);
    if (!status)
        printf("medium from %s: %llu zones, %g per m and unit, optical depth at most %.3g\n",
               murk_volume_density(volume), (unsigned long long)info.zones, info.extinction_scale,
               info.max_depth);
    murk_medium_release(medium);
    return status;
}

static murk_status run(murk_context *context, const char *path)
{
    murk_volume *volume;
    murk_status status = murk_volume_read(context, path, &volume);
    if (status)
        return status;
    status = print_grids(volume);
    if (!status)
        status = print_medium(context, volume);
    murk_volume_release(volume);
    return status;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: %s FILE.vdb\n", argv[0]);
        return 1;
    }
    murk_context *context;
    murk_status status = murk_context_create(NULL, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    status = run(context, argv[1]);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_context_release(context);
    return status != MURK_OK;
}
