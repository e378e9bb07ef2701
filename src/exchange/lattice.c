/* SPDX-License-Identifier: Apache-2.0 */
#include "lattice.h"

#include <math.h>

int murk_lattice_axis(const murk_grid *grid, const double direction[3])
{
    int axis = 0;
    for (int a = 1; a < 3; a++)
        if (fabs(direction[a]) / grid->voxel[a] > fabs(direction[axis]) / grid->voxel[axis])
            axis = a;
    return axis;
}

int murk_lattice_signs(const double direction[3])
{
    return (direction[0] > 0) | (direction[1] > 0) << 1 | (direction[2] > 0) << 2;
}

/* Where in the layer (0 at entry, 1 at exit) the line crosses the face between two cells: beyond 1
   when it does not. `from` is the position in the entry cell, `change` its change to the exit. */
static double crossing(double from, double change)
{
    if (change > 0)
        return (1 - from) / change;
    if (change < 0)
        return from / -change;
    return 2;
}

/* A segment from t0 to t1 in the layer, d voxels from that of the entry. */
static murk_segment lay_segment(const double from[2], const double change[2], int sign,
                                const int d[2], double t0, double t1, double length)
{
    double middle = (t0 + t1) / 2;
    murk_segment segment = {.du = d[0], .dv = d[1], .length = (float)((t1 - t0) * length)};
    for (int c = 0; c < 2; c++) {
        segment.middle[c] = (float)(from[c] + change[c] * middle - d[c] - 0.5);
        segment.change[c] = (float)(change[c] * (t1 - t0));
    }
    segment.middle[2] = (float)(sign * (middle - 0.5));
    segment.change[2] = (float)(sign * (t1 - t0));
    return segment;
}

static void lay_layer(murk_layer *layer, const double entry[2], const double change[2], int sign,
                      double length)
{
    double at[2], from[2];
    int step[2];
    for (int c = 0; c < 2; c++) {
        double cell = floor(entry[c]);
        layer->shift[c] = (int32_t)cell;
        from[c] = entry[c] - cell;
        at[c] = crossing(from[c], change[c]);
        step[c] = change[c] > 0 ? 1 : -1;
    }
    double t = 0;
    int d[2] = {0, 0};
    layer->count = 0;
    for (;;) {
        int c = at[0] <= at[1] ? 0 : 1;
        double next = at[c] < 1 ? at[c] : 1;
        if (next > t) {
            layer->segment[layer->count++] = lay_segment(from, change, sign, d, t, next, length);
            t = next;
        }
        if (!(at[c] < 1))
            return;
        d[c] = step[c];
        at[c] = 2; /* |slope| <= 1: a layer holds one crossing an axis */
    }
}

void murk_lattice_lay(murk_lattice *lattice, const murk_grid *grid, const murk_line *line)
{
    int axis = murk_lattice_axis(grid, line->direction);
    lattice->axis = axis;
    lattice->u = axis == 2 ? 1 : 2;
    lattice->v = axis == 0 ? 1 : 0;
    lattice->sign = line->direction[axis] > 0 ? 1 : -1;
    lattice->span = line->span;
    lattice->weight = line->weight;
    lattice->middle = grid->middle[axis];
    lattice->length = grid->voxel[axis] / fabs(line->direction[axis]);
    lattice->area = grid->volume / lattice->length;
    const int axes[2] = {lattice->u, lattice->v};
    for (int a = 0; a < 3; a++)
        lattice->direction[a] = line->direction[a];
    for (int c = 0; c < 2; c++) {
        lattice->offset[c] = line->offset[c];
        lattice->slope[c] = line->direction[axes[c]] / grid->voxel[axes[c]] /
                            (line->direction[axis] / grid->voxel[axis]);
    }
}

void murk_lattice_layers(const murk_lattice *lattice, const murk_grid *grid, int32_t brick,
                         murk_layers *out)
{
    for (int c = 0; c < 2; c++) {
        out->first[c] = INT32_MAX;
        out->last[c] = INT32_MIN;
    }
    for (int32_t k = 0; k < MURK_BRICK_EDGE; k++) {
        double c_in =
            (double)brick * MURK_BRICK_EDGE + k - grid->lo[lattice->axis] + (lattice->sign < 0);
        double entry[2], change[2];
        for (int c = 0; c < 2; c++) {
            entry[c] = lattice->offset[c] + lattice->slope[c] * (c_in - lattice->middle);
            change[c] = lattice->slope[c] * lattice->sign;
        }
        lay_layer(&out->layer[k], entry, change, lattice->sign, lattice->length);
        for (int s = 0; s < out->layer[k].count; s++) {
            const murk_segment *segment = &out->layer[k].segment[s];
            const int d[2] = {segment->du, segment->dv};
            for (int c = 0; c < 2; c++) {
                int32_t at = out->layer[k].shift[c] + d[c];
                out->first[c] = -at < out->first[c] ? -at : out->first[c];
                out->last[c] = MURK_BRICK_EDGE - 1 - at > out->last[c] ? MURK_BRICK_EDGE - 1 - at
                                                                       : out->last[c];
            }
        }
    }
}
