/* SPDX-License-Identifier: Apache-2.0 */
#include "audience.h"

#include "view.h"
#include "walk.h"

#include <math.h>

/* Below this part of the bricks left out, tracing all of them costs no more than a little. */
static const double WORTH = 0.1;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Corner n (of 8) of a brick in the grid frame [m]. */
static void corner_of(const murk_grid *grid, const int32_t brick[3], int n, double out[3])
{
    for (int a = 0; a < 3; a++)
        out[a] = grid->voxel[a] * ((double)brick[a] * MURK_BRICK_EDGE - grid->lo[a] +
                                   MURK_BRICK_EDGE * (n >> a & 1));
}

/* Whether any part of a brick may lie in the picture: not all corners behind, or beyond one edge.
 */
static bool in_view(const murk_view *view, const murk_grid *grid, const int32_t brick[3])
{
    int outside[5] = {0};
    for (int n = 0; n < 8; n++) {
        double corner[3], world[3];
        corner_of(grid, brick, n, corner);
        murk_grid_to_world(grid, corner, world);
        for (int c = 0; c < 3; c++)
            world[c] -= view->eye[c];
        double ahead = dot(world, view->forward);
        double x = dot(world, view->right), y = dot(world, view->up);
        outside[0] += ahead <= 0;
        outside[1] += x > ahead * view->half_width;
        outside[2] += -x > ahead * view->half_width;
        outside[3] += y > ahead * view->half_height;
        outside[4] += -y > ahead * view->half_height;
    }
    for (int side = 0; side < 5; side++)
        if (outside[side] == 8)
            return false;
    return true;
}

/* The largest transmittance from the eye to the corners and the middle of a brick. */
static double transmittance(const murk_solution *solution, const double eye[3],
                            const int32_t brick[3])
{
    double least = INFINITY;
    for (int n = 0; n < 9; n++) {
        double to[3], far[3];
        corner_of(solution->grid, brick, n & 7, to);
        if (n == 8) {
            corner_of(solution->grid, brick, 7, far);
            for (int a = 0; a < 3; a++)
                to[a] = (to[a] + far[a]) / 2;
        }
        /* The medium's frame begins at the corner of the zones, the solution's at its margin's. */
        const murk_grid *zones = solution->medium->grid;
        double direction[3], from[3], length = 0;
        for (int a = 0; a < 3; a++) {
            double apart = zones->voxel[a] * ((double)solution->grid->lo[a] - zones->lo[a]);
            from[a] = eye[a] + apart;
            direction[a] = to[a] + apart - from[a];
            length = hypot(length, direction[a]);
        }
        if (!(length > 0))
            return 1;
        for (int a = 0; a < 3; a++)
            direction[a] /= length;
        least = fmin(least,
                     murk_walk_depth(zones, solution->medium->kappa_t, from, direction, 0, length));
    }
    return exp(-least);
}

static double brightness(const murk_solution *solution, size_t brick)
{
    float most = 0;
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
        most = fmaxf(most, solution->radiosity[brick * MURK_BRICK_SLOTS + (size_t)slot]);
    return most;
}

murk_status murk_audience(murk_context *context, const murk_solution *solution,
                          const murk_camera *camera, double tolerance, murk_region *out)
{
    const murk_grid *grid = solution->grid;
    murk_view view;
    murk_status status = murk_view_create(context, camera, &view);
    if (status)
        return status;
    if (view.parallel) { /* such a picture is taken to hold all of a medium */
        *out = (murk_region){.limited = false};
        return MURK_OK;
    }
    float *light = murk_alloc(grid->brick_count, sizeof *light);
    if (!light)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu bricks",
                         grid->brick_count);
    double eye[3], brightest = 0;
    murk_grid_from_world(grid, view.eye, eye);
#pragma omp parallel for num_threads(context->threads) schedule(dynamic, 16)                       \
    reduction(max                                                                                  \
              : brightest)
    for (size_t b = 0; b < grid->brick_count; b++) {
        if (in_view(&view, grid, grid->brick[b]))
            light[b] =
                (float)(brightness(solution, b) * transmittance(solution, eye, grid->brick[b]));
        brightest = fmax(brightest, light[b]);
    }
    murk_region region = {.limited = true};
    for (int a = 0; a < 3; a++) {
        region.low[a] = INT32_MAX;
        region.high[a] = INT32_MIN;
    }
    size_t left_out = 0;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int a = 0; light[b] > 1e-3 * tolerance * brightest && a < 3; a++) {
            int32_t at = grid->brick[b][a];
            region.low[a] = at - 1 < region.low[a] ? at - 1 : region.low[a];
            region.high[a] = at + 1 > region.high[a] ? at + 1 : region.high[a];
        }
    for (size_t b = 0; b < grid->brick_count; b++)
        left_out += !murk_region_has(&region, grid->brick[b]);
    region.limited = brightest > 0 && (double)left_out > WORTH * (double)grid->brick_count;
    murk_free(light);
    *out = region;
    return MURK_OK;
}
