/* SPDX-License-Identifier: Apache-2.0 */
/* A solution back from the VDB that holds its radiosity. */
#include "band_volume.h"
#include "murk/bands.h"
#include "solution.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Copies the values of voxels that the solution has. NaN, infinite and negative ones become 0 and
   are counted. covered: one bit a voxel of the solution's grid that the bricks hold. */
static size_t copy_values(const murk_bricks *bricks, murk_solution *solution,
                          uint64_t (*covered)[8])
{
    size_t invalid = 0;
    for (size_t b = 0; b < bricks->count; b++) {
        const int32_t *c = bricks->brick[b];
        int32_t to = murk_grid_find(solution->grid, c[0], c[1], c[2]);
        if (to == MURK_NO_BRICK)
            continue;
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            float value = bricks->values[b * MURK_BRICK_SLOTS + (size_t)slot];
            bool held = bricks->mask[b][slot >> 6] >> (slot & 63) & 1;
            if (!held || !murk_grid_active(solution->grid, (size_t)to, slot))
                continue;
            if (!(value >= 0 && isfinite(value))) {
                value = 0;
                invalid++;
            }
            solution->radiosity[(size_t)to * MURK_BRICK_SLOTS + (size_t)slot] = value;
            covered[to][slot >> 6] |= (uint64_t)1 << (slot & 63);
        }
    }
    return invalid;
}

static size_t count_uncovered(const murk_solution *solution, uint64_t (*covered)[8])
{
    const murk_grid *zones = solution->medium->grid;
    size_t missing = 0;
    for (size_t b = 0; b < zones->brick_count; b++) {
        const int32_t *c = zones->brick[b];
        int32_t in = murk_grid_find(solution->grid, c[0], c[1], c[2]);
        for (int x = 0; x < 8; x++) {
            uint64_t have = in == MURK_NO_BRICK ? 0 : covered[in][x];
            missing += (size_t)__builtin_popcountll(zones->mask[b][x] & ~have);
        }
    }
    return missing;
}

/* name may be NULL. */
static murk_status take_radiosity(murk_context *context, const murk_volume *volume,
                                  const char *name, murk_solution *solution)
{
    murk_bricks bricks = {0};
    size_t index;
    int component;
    const char *path = murk_vdb_path(volume->vdb);
    murk_status status = murk_volume_find_band(context, volume, name, &index, &component);
    if (!status)
        status = murk_vdb_bricks(context, volume->vdb, index, component, &bricks);
    if (status)
        return status;
    char grid[300];
    snprintf(grid, sizeof grid, "%.200s%s%.50s", murk_vdb_info(volume->vdb, index)->name,
             name ? ", band " : "", name ? name : "");
    uint64_t(*covered)[8] = murk_alloc(solution->grid->brick_count, sizeof *covered);
    if (covered) {
        size_t invalid = copy_values(&bricks, solution, covered);
        size_t missing = count_uncovered(solution, covered);
        if (missing)
            status = murk_fail(context, MURK_ERROR_INPUT,
                               "%s, grid %s: %zu of the medium's %zu zones are missing; "
                               "solve this medium again",
                               path, grid, missing, solution->medium->grid->zone_count);
        else if (invalid)
            murk_warn(context,
                      "%s, grid %s: %zu voxels are NaN, infinite or negative: treated as 0", path,
                      grid, invalid);
    } else
        status = murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    murk_free(covered);
    murk_bricks_clear(&bricks);
    return status;
}

/* Fails where the file says that it was solved with another g: a solution is that of the medium
   with kappa_s (1 - g). */
static murk_status check_asymmetry(murk_context *context, const murk_volume *volume,
                                   const char *name, const murk_medium *medium)
{
    char key[64];
    snprintf(key, sizeof key, "asymmetry_%s", name ? name : "");
    double solved = murk_vdb_asymmetry_of(volume->vdb, key);
    if (isnan(solved))
        solved = murk_vdb_asymmetry_of(volume->vdb, "asymmetry");
    if (!(fabs(solved - medium->asymmetry) > 1e-6)) /* nor where the file does not say */
        return MURK_OK;
    return murk_fail(context, MURK_ERROR_INPUT,
                     "%s%s%s: solved with asymmetry %g, but that of the medium is %g; solve this "
                     "medium again",
                     murk_vdb_path(volume->vdb), name ? ", band " : "", name ? name : "", solved,
                     medium->asymmetry);
}

murk_status murk_solution_from_volume_band(murk_context *context, const murk_scene *scene,
                                           const murk_volume *volume, const char *name,
                                           murk_solution **out)
{
    murk_solution *solution = NULL;
    murk_status status = murk_solution_create(context, scene, 0, &solution);
    if (status)
        return status;
    status = check_asymmetry(context, volume, name, solution->medium);
    if (!status)
        status = take_radiosity(context, volume, name, solution);
    if (!status)
        status = murk_solution_light_ground(context, solution);
    if (status)
        murk_solution_release(solution);
    else
        *out = solution;
    return status;
}

murk_status murk_solution_from_volume(murk_context *context, const murk_scene *scene,
                                      const murk_volume *volume, murk_solution **out)
{
    return murk_solution_from_volume_band(context, scene, volume, NULL, out);
}
