/* SPDX-License-Identifier: Apache-2.0 */
#include "shadow.h"

#include <float.h>
#include <math.h>

static double dot(const double x[3], const double y[3])
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/* Two unit vectors across a third. */
static void set_across(const double along[3], double across[2][3])
{
    int least = 0;
    for (int a = 1; a < 3; a++)
        least = fabs(along[a]) < fabs(along[least]) ? a : least;
    int next = (least + 1) % 3, last = (least + 2) % 3;
    double length = hypot(along[next], along[last]);
    across[0][least] = 0;
    across[0][next] = along[last] / length;
    across[0][last] = -along[next] / length;
    for (int a = 0; a < 3; a++)
        across[1][a] = along[(a + 1) % 3] * across[0][(a + 2) % 3] -
                       along[(a + 2) % 3] * across[0][(a + 1) % 3];
}

/* Where a box is seen from the sun: [low, high] on each axis of the plane. */
static void outline(const murk_shadow *shadow, const murk_box *box, double low[2], double high[2])
{
    static const double VOXEL[3] = {1, 1, 1};
    for (int c = 0; c < 2; c++) {
        low[c] = INFINITY;
        high[c] = -INFINITY;
        for (int n = 0; n < 8; n++) {
            double corner[3];
            murk_box_corner(box, VOXEL, n, corner);
            double x = dot(corner, shadow->across[c]);
            low[c] = fmin(low[c], x);
            high[c] = fmax(high[c], x);
        }
    }
}

/* Bins of about a brick's size, and no more than a few for each brick. */
static void choose_bins(murk_shadow *shadow, const murk_grid *grid, const murk_box *box)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t b = 0; b < grid->brick_count; b++) {
        double from[2], to[2];
        outline(shadow, &box[b], from, to);
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], from[c]);
            high[c] = fmax(high[c], to[c]);
        }
    }
    double most = 64 + 4 * (double)grid->brick_count;
    double edge = MURK_BRICK_EDGE / 2 * cbrt(grid->voxel[0] * grid->voxel[1] * grid->voxel[2]);
    edge = fmax(edge, sqrt((high[0] - low[0]) * (high[1] - low[1]) / most));
    edge = fmax(edge, fmax(high[0] - low[0], high[1] - low[1]) / most);
    for (int c = 0; c < 2; c++) {
        for (int a = 0; a < 3; a++)
            shadow->across[c][a] /= edge;
        shadow->low[c] = low[c] / edge - 0.01;
        shadow->bins.count[c] = (int)((high[c] - low[c]) / edge + 0.02) + 1;
    }
}

murk_status murk_shadow_create(murk_context *context, const murk_grid *grid, const murk_box *box,
                               const double travel[3], murk_shadow *out)
{
    murk_shadow shadow = {0};
    double along[3];
    murk_grid_direction_from_world(grid, travel, along);
    set_across(along, shadow.across);
    for (int a = 0; a < 3; a++) {
        double d = -along[a] / grid->voxel[a];
        shadow.towards[a] = murk_packet_direction(d);
        shadow.inverse[a] = 1 / shadow.towards[a];
        for (int c = 0; c < 2; c++)
            shadow.across[c][a] *= grid->voxel[a];
    }
    murk_bin_range *range = murk_alloc(grid->brick_count, sizeof *range);
    if (!range)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    if (grid->brick_count)
        choose_bins(&shadow, grid, box);
    for (size_t b = 0; b < grid->brick_count; b++) {
        const double slack = 0.001; /* bins, far more than rounding */
        double low[2], high[2];
        outline(&shadow, &box[b], low, high);
        range[b].brick = (int32_t)b;
        for (int c = 0; c < 2; c++)
            murk_bin_range_set(&range[b], c, low[c] - shadow.low[c] - slack,
                               high[c] - shadow.low[c] + slack, shadow.bins.count[c]);
    }
    murk_status status = murk_bins_fill(context, range, grid->brick_count, &shadow.bins);
    murk_free(range);
    if (status)
        murk_shadow_clear(&shadow);
    else
        *out = shadow;
    return status;
}

void murk_shadow_clear(murk_shadow *shadow)
{
    murk_bins_clear(&shadow->bins);
}

/* The bin that each point is seen in, -1 for none. */
static void find_bins(const murk_shadow *shadow, const double point[3][MURK_LANES],
                      const bool wanted[MURK_LANES], int bin[MURK_LANES])
{
    const double *x = shadow->across[0], *y = shadow->across[1];
    for (int l = 0; l < MURK_LANES; l++) {
        double u = point[0][l] * x[0] + point[1][l] * x[1] + point[2][l] * x[2] - shadow->low[0];
        double v = point[0][l] * y[0] + point[1][l] * y[1] + point[2][l] * y[2] - shadow->low[1];
        bool in =
            wanted[l] && u >= 0 && u < shadow->bins.count[0] && v >= 0 && v < shadow->bins.count[1];
        bin[l] = in ? (int)v * shadow->bins.count[0] + (int)u : -1;
    }
}

void murk_shadow_depth(const murk_shadow *shadow, const murk_march *march,
                       const double point[3][MURK_LANES], const bool wanted[MURK_LANES],
                       double depth[MURK_LANES])
{
    int bin[MURK_LANES];
    find_bins(shadow, point, wanted, bin);
    for (int l = 0; l < MURK_LANES; l++)
        depth[l] = 0;
    for (int first = 0; first < MURK_LANES; first++) {
        if (bin[first] < 0)
            continue;
        int here = bin[first];
        size_t list = shadow->bins.first[here], count = shadow->bins.first[here + 1] - list;
        murk_packet packet = {0};
        for (int l = 0; l < MURK_LANES; l++) {
            for (int a = 0; a < 3; a++) {
                packet.origin[a][l] = point[a][l];
                packet.direction[a][l] = shadow->towards[a];
                packet.inverse[a][l] = shadow->inverse[a];
            }
            packet.t_max[l] = bin[l] == here ? MURK_FOREVER : 0;
        }
        if (count)
            march->run(&march->medium, shadow->bins.brick + list, count, &packet, NULL);
        for (int l = first; l < MURK_LANES; l++)
            if (bin[l] == here) {
                depth[l] = packet.depth[l];
                bin[l] = -1;
            }
    }
}
