/* SPDX-License-Identifier: Apache-2.0 */
/* A lattice of parallel lines aligned with the voxel lattice. */
#ifndef MURK_EXCHANGE_LATTICE_H
#define MURK_EXCHANGE_LATTICE_H

#include "grid.h"

/* What to trace: one line through every voxel face across the direction's dominant axis. */
typedef struct murk_line {
    double direction[3]; /* unit vector of travel, grid frame */
    double offset[2];    /* where in the face the line passes, [0, 1), at the middle of the grid */
    double span;         /* edge of the part of the face that the line stands for: 1, 1/2, ... */
    double weight;       /* of its direction, as a fraction of the sphere, shared by its lines */
} murk_line;

/* A piece of every line inside one layer of voxels. A line that enters the layer at voxel (u, v)
   is in voxel (u + du, v + dv) for the length given. */
typedef struct murk_segment {
    int du, dv;
    float length; /* m */
    /* Along u, v and the dominant axis, in voxels: where the segment's middle lies, from that of
       its voxel, and how far it goes. */
    float middle[3], change[3];
} murk_segment;

/* One layer of voxels: all lines cross it in the same pattern of at most three segments. Line r
   enters it at the voxel r + shift. Segments are in order of travel. */
typedef struct murk_layer {
    int32_t shift[2];
    int count;
    murk_segment segment[3];
} murk_layer;

/* The layers of all bricks with one coordinate on the dominant axis. The lines that meet a brick
   whose first voxel is (u, v) are u + first[0] ... u + last[0], and likewise along v. */
typedef struct murk_layers {
    murk_layer layer[MURK_BRICK_EDGE];
    int32_t first[2], last[2];
} murk_layers;

/* The most lines of a lattice that meet a brick, along u or v: 8, and 9 by their slope. */
enum { MURK_WINDOW = 17 };

/*
 * In cells relative to grid->lo, with c the coordinate on the dominant axis and m the middle of
 * the grid, line r is at r + offset + slope * (c - m) on the axes u and v. One line a face, so each
 * voxel is crossed by lines of the total length that its volume demands: sum of length * area = V.
 */
typedef struct murk_lattice {
    int axis, u, v; /* dominant axis; u > v in memory order: v runs over rows, u along them */
    int sign;       /* of travel along axis */
    double direction[3];
    double offset[2], slope[2], middle; /* [0] along u, [1] along v */
    double span, weight;
    double length; /* of a line within a layer [m] */
    double area;   /* perpendicular cross-section of a whole face [m^2] */
} murk_lattice;

/* Dominant axis of a direction in voxels, and the signs of travel packed in bits 0..2 for x, y, z:
   lines that agree in both can be traced side by side. */
int murk_lattice_axis(const murk_grid *grid, const double direction[3]);
int murk_lattice_signs(const double direction[3]);

void murk_lattice_lay(murk_lattice *lattice, const murk_grid *grid, const murk_line *line);

/* The layers of the bricks with the given brick coordinate on the lattice's dominant axis. */
void murk_lattice_layers(const murk_lattice *lattice, const murk_grid *grid, int32_t brick,
                         murk_layers *out);

#endif
