/* SPDX-License-Identifier: Apache-2.0 */
#include "seen.h"

#include <math.h>
#include <stdlib.h>

/* The view in the grid frame [m]. */
typedef struct frame {
    double eye[3], right[3], up[3], forward[3], half[2];
    bool parallel;
    int size[2];
} frame;

/* A brick, and how many bricks along the axes it is from the eye: with every brick that a ray
   enters it gets one further, so ascending distances are front to back for all rays. */
typedef struct ranked {
    int64_t distance;
    int32_t brick;
} ranked;

static int compare(const void *a, const void *b)
{
    const ranked *x = a, *y = b;
    return x->distance != y->distance ? (x->distance > y->distance) - (x->distance < y->distance)
                                      : (x->brick > y->brick) - (x->brick < y->brick);
}

/* The same along rays that all go one way, from no eye. */
static int64_t ahead(const int32_t brick[3], const double forward[3])
{
    int64_t distance = 0;
    for (int a = 0; a < 3; a++)
        distance += forward[a] < 0 ? -(int64_t)brick[a] : brick[a];
    return distance;
}

static void rank(const murk_grid *grid, const frame *view, ranked *order)
{
    int64_t at[3];
    for (int a = 0; a < 3; a++) {
        double cell = floor((view->eye[a] / grid->voxel[a] + grid->lo[a]) / MURK_BRICK_EDGE);
        at[a] = (int64_t)fmin(fmax(cell, INT32_MIN), INT32_MAX);
    }
    for (size_t b = 0; b < grid->brick_count; b++) {
        order[b] = (ranked){.brick = (int32_t)b};
        for (int a = 0; a < 3; a++)
            order[b].distance += llabs(grid->brick[b][a] - at[a]);
        if (view->parallel)
            order[b].distance = ahead(grid->brick[b], view->forward);
    }
    qsort(order, grid->brick_count, sizeof *order, compare);
}

static double dot(const double x[3], const double y[3])
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/* The bins that a brick's box covers; false where that is none. */
static bool cover(const frame *view, const murk_grid *grid, const murk_box *box, const int count[2],
                  murk_bin_range *range)
{
    const double slack = 0.01; /* pixels, far more than rounding */
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    double nearest = grid->voxel[0] * 1e-6;
    bool in_front = true, beside[4] = {true, true, true, true}, behind = true;
    for (int n = 0; n < 8; n++) {
        double corner[3];
        murk_box_corner(box, grid->voxel, n, corner);
        for (int a = 0; a < 3; a++)
            corner[a] -= view->eye[a];
        const double side[2] = {dot(corner, view->right), -dot(corner, view->up)};
        double z = dot(corner, view->forward);
        behind = behind && z <= 0;
        in_front = in_front && z > nearest;
        double reach = view->parallel ? 1 : z;
        for (int c = 0; c < 2; c++) {
            double edge = 1.01 * reach * view->half[c];
            beside[2 * c] = beside[2 * c] && side[c] < -edge;
            beside[2 * c + 1] = beside[2 * c + 1] && side[c] > edge;
            double pixel = (side[c] / (reach * view->half[c]) + 1) / 2 * view->size[c];
            low[c] = fmin(low[c], pixel - slack);
            high[c] = fmax(high[c], pixel + slack);
        }
    }
    if (behind || beside[0] || beside[1] || beside[2] || beside[3])
        return false;
    for (int c = 0; c < 2; c++) {
        range->low[c] = 0;
        range->high[c] = count[c] - 1;
        if (in_front)
            murk_bin_range_set(range, c, low[c] / MURK_BIN_PIXELS, high[c] / MURK_BIN_PIXELS,
                               count[c]);
    }
    return range->low[0] <= range->high[0] && range->low[1] <= range->high[1];
}

murk_status murk_seen(murk_context *context, const murk_grid *grid, const murk_box *box,
                      const murk_view *view, murk_bins *bins)
{
    frame in_grid = {.half = {view->half_width, view->half_height},
                     .parallel = view->parallel,
                     .size = {view->size[0], view->size[1]}};
    murk_grid_from_world(grid, view->eye, in_grid.eye);
    murk_grid_direction_from_world(grid, view->right, in_grid.right);
    murk_grid_direction_from_world(grid, view->up, in_grid.up);
    murk_grid_direction_from_world(grid, view->forward, in_grid.forward);
    for (int c = 0; c < 2; c++)
        bins->count[c] = (view->size[c] + MURK_BIN_PIXELS - 1) / MURK_BIN_PIXELS;
    ranked *order = murk_alloc(grid->brick_count, sizeof *order);
    murk_bin_range *range = murk_alloc(grid->brick_count, sizeof *range);
    murk_status status;
    if (order && range) {
        size_t count = 0;
        rank(grid, &in_grid, order);
        for (size_t i = 0; i < grid->brick_count; i++) {
            range[count].brick = order[i].brick;
            count += cover(&in_grid, grid, &box[order[i].brick], bins->count, &range[count]);
        }
        status = murk_bins_fill(context, range, count, bins);
    } else {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    }
    murk_free(order);
    murk_free(range);
    return status;
}
