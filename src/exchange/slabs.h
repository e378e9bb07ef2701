/* SPDX-License-Identifier: Apache-2.0 */
/* The bricks of a grid in slabs across an axis, in the orders that lines cross them. */
#ifndef MURK_EXCHANGE_SLABS_H
#define MURK_EXCHANGE_SLABS_H

#include "grid.h"

/*
 * A slab is all bricks with one brick coordinate on the axis. Lines whose dominant axis it is cross
 * slab after slab; within a slab they go one way along u and one along v, so bricks ascending in
 * (u, v) stand in order for lines that travel up both, bricks in the mixed order, ascending in u
 * and descending in v, for lines that travel up u and down v, and the reverses for the others.
 */
typedef struct murk_slabs {
    int axis, u, v; /* as in murk_lattice */
    int count;
    int32_t *row;     /* brick coordinate of each slab */
    size_t *first;    /* where its bricks start; [count] is the number of bricks */
    int32_t *brick;   /* ascending in (row, u, v) */
    int32_t *mixed;   /* the same slab in mixed order, as positions in `brick` */
    uint32_t *chunks; /* of brick[i]: which chunks of its layers across the axis hold a voxel */
    size_t widest;    /* most bricks of a slab */
} murk_slabs;

/* False when memory runs out. */
bool murk_slabs_create(murk_slabs *slabs, const murk_grid *grid, int axis);
void murk_slabs_clear(murk_slabs *slabs);

/* Copies a brick from slot order (x, y, z) to layers across the axis, rows v, columns u, or adds
   such layers to it. */
void murk_slabs_layers(int axis, const float *slots, float *layers);
void murk_slabs_add(int axis, const float *layers, float *slots);

#endif
