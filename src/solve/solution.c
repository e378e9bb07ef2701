/* SPDX-License-Identifier: Apache-2.0 */
#include "solution.h"

#include "beam.h"

#include <math.h>
#include <string.h>

/* Consumers interpolate at the rim of the medium: two voxels beyond it carry light too. */
enum { MARGIN = 2 };

/* The ground lies below the medium: no zone has its centre under it. */
static murk_status check_ground(murk_context *context, const murk_scene *scene)
{
    const murk_grid *grid = scene->medium->grid;
    if (!scene->ground || !grid->brick_count)
        return MURK_OK;
    int up = murk_ground_axis_up(scene->ground);
    double per_voxel[3], origin = grid->corner[up], lowest = INFINITY, voxel = 0;
    for (int a = 0; a < 3; a++) {
        per_voxel[a] = grid->axis[a][up] * grid->voxel[a];
        origin += per_voxel[a] * (0.5 - grid->lo[a]);
        voxel = fmax(voxel, fabs(per_voxel[a]));
    }
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            if (!murk_grid_active(grid, b, slot))
                continue;
            const int in[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
            double height = origin;
            for (int a = 0; a < 3; a++)
                height += per_voxel[a] * ((double)grid->brick[b][a] * MURK_BRICK_EDGE + in[a]);
            lowest = fmin(lowest, height);
        }
    if (lowest < scene->ground->height - 0.01 * voxel)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "ground.height: %g is inside the medium, whose lowest zone is at %g; "
                         "put the ground there or below",
                         scene->ground->height, lowest);
    return MURK_OK;
}

static murk_status check_scene(murk_context *context, const murk_scene *scene)
{
    if (!scene->medium)
        return murk_fail(context, MURK_ERROR_INPUT, "scene: no medium");
    murk_status below = check_ground(context, scene);
    if (below)
        return below;
    if (!(scene->sky_radiance >= 0) || !isfinite(scene->sky_radiance))
        return murk_fail(context, MURK_ERROR_INPUT, "sky.radiance: %g is not a finite number >= 0",
                         scene->sky_radiance);
    if (!(scene->sun.irradiance >= 0) || !isfinite(scene->sun.irradiance))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "sun.irradiance: %g is not a finite number >= 0", scene->sun.irradiance);
    double length =
        hypot(hypot(scene->sun.direction[0], scene->sun.direction[1]), scene->sun.direction[2]);
    if (scene->sun.irradiance > 0 && !(length > 0 && isfinite(length)))
        return murk_fail(context, MURK_ERROR_INPUT, "sun.direction: a vector of length 0");
    if (scene->ground && scene->sun.irradiance > 0 &&
        murk_beam_on_ground(scene->ground, &scene->sun) == 0)
        murk_warn(context, "sun.direction: the sun stands below the ground's horizon and lights "
                           "nothing; direction is the way the light travels, so down");
    return MURK_OK;
}

murk_status murk_solution_create(murk_context *context, const murk_scene *scene, int halvings,
                                 murk_solution **out)
{
    murk_status status = halvings ? MURK_OK : check_scene(context, scene);
    if (status)
        return status;
    murk_solution *solution = murk_alloc(1, sizeof *solution);
    if (!solution)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    solution->context = context;
    solution->medium = murk_medium_share(scene->medium);
    solution->ground = murk_ground_share(scene->ground);
    solution->sun = scene->sun;
    solution->sun.irradiance = murk_or_none(scene->sun.irradiance);
    solution->sky_radiance = murk_or_none(scene->sky_radiance);
    const murk_ground *ground = scene->ground;
    if (ground)
        solution->horizon =
            ground->mean_emission +
            ground->mean_reflectance *
                (murk_beam_on_ground(ground, &solution->sun) + M_PI * solution->sky_radiance);
    status = murk_grid_dilate(context, scene->medium->input, MARGIN << halvings, &solution->grid);
    if (!status) {
        /* The same lines cross the zones here as on the medium's own grid. */
        const murk_grid *zones = scene->medium->grid;
        for (int a = 0; a < 3 && zones->brick_count; a++)
            solution->grid->middle[a] =
                zones->middle[a] + ((double)zones->lo[a] - solution->grid->lo[a]);
        size_t patches = ground ? ground->patch_count : 0;
        solution->radiosity =
            murk_alloc(solution->grid->brick_count * MURK_BRICK_SLOTS, sizeof(float));
        solution->patch = murk_alloc(patches, sizeof(float));
        solution->patch_diffuse = murk_alloc(patches, sizeof(float));
        if (!solution->radiosity || !solution->patch || !solution->patch_diffuse)
            status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu voxels",
                               solution->grid->zone_count);
    }
    if (status) {
        murk_solution_release(solution);
        return status;
    }
    murk_report *report = &solution->report;
    report->zones = scene->medium->grid->zone_count;
    report->bricks = scene->medium->grid->brick_count;
    report->patches = ground ? ground->patch_count : 0;
    report->threads = context->threads;
    *out = solution;
    return MURK_OK;
}

void murk_solution_release(murk_solution *solution)
{
    if (!solution)
        return;
    murk_medium_release((murk_medium *)solution->medium);
    murk_ground_release((murk_ground *)solution->ground);
    murk_grid_release(solution->grid);
    murk_free(solution->radiosity);
    murk_free(solution->patch);
    murk_free(solution->patch_diffuse);
    murk_free(solution);
}

const murk_report *murk_solution_report(const murk_solution *solution)
{
    return &solution->report;
}

double murk_solution_radiosity(const murk_solution *solution, const int32_t index[3])
{
    int64_t slot = murk_grid_slot(solution->grid, index[0], index[1], index[2]);
    if (slot < 0 || !murk_grid_active(solution->grid, (size_t)slot / MURK_BRICK_SLOTS,
                                      (int)(slot % MURK_BRICK_SLOTS)))
        return NAN;
    return solution->radiosity[slot];
}

murk_status murk_solution_voxels(const murk_solution *solution, size_t capacity, int32_t *index,
                                 float *radiosity, size_t *count)
{
    const murk_grid *grid = solution->grid;
    size_t n = 0;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS && n < capacity; slot++) {
            if (!murk_grid_active(grid, b, slot))
                continue;
            const int in[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
            for (int a = 0; index && a < 3; a++)
                index[3 * n + (size_t)a] = grid->brick[b][a] * MURK_BRICK_EDGE + in[a];
            if (radiosity)
                radiosity[n] = solution->radiosity[b * MURK_BRICK_SLOTS + (size_t)slot];
            n++;
        }
    *count = grid->zone_count;
    return MURK_OK;
}

murk_status murk_solution_ground(const murk_solution *solution, float *radiosity)
{
    const murk_ground *ground = solution->ground;
    if (!ground)
        return murk_fail(solution->context, MURK_ERROR_INPUT,
                         "ground: the scene has none, so it has no radiosity; add one");
    int nx = ground->interior[0], ny = ground->interior[1];
    for (int ib = 0; ib < ny; ib++)
        for (int ia = 0; ia < nx; ia++) {
            int row = murk_ground_row(ground, ib);
            radiosity[row * nx + ia] = solution->patch[murk_ground_interior(ground, ia, ib)];
        }
    return MURK_OK;
}
