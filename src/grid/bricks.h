/* SPDX-License-Identifier: Apache-2.0 */
/* Plain arrays of 8x8x8 bricks: how voxel values pass between OpenVDB and the rest. */
#ifndef MURK_GRID_BRICKS_H
#define MURK_GRID_BRICKS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { MURK_BRICK_EDGE = 8, MURK_BRICK_SLOTS = 512 };

/*
 * Brick b covers voxels 8*brick[b][a] ... 8*brick[b][a] + 7 on each axis a. Voxel (x, y, z) of a
 * brick is slot x*64 + y*8 + z (OpenVDB's own leaf order); it is active where bit y*8 + z of
 * mask[b][x] is set. values[b*512 + slot]; inactive slots hold 0.
 * world = index_to_world (row-major 4x4) * (i, j, k, 1), (i, j, k) the centre of a voxel.
 */
typedef struct murk_bricks {
    size_t count;
    int32_t (*brick)[3];
    uint64_t (*mask)[8];
    float *values; /* may be NULL where only the topology matters */
    float background;
    double index_to_world[16];
} murk_bricks;

/* Sets index_to_world for voxels along the axes of the world; origin is the low corner of voxel
   (0, 0, 0). */
void murk_bricks_place(murk_bricks *bricks, const double voxel_size[3], const double origin[3]);

/* Frees the arrays (each from murk_alloc) and clears the struct. */
void murk_bricks_clear(murk_bricks *bricks);

/* Orders int32_t[3] coordinates, or structs that begin with them, as qsort() and bsearch() ask:
   ascending in (x, y, z). */
int murk_brick_compare(const void *a, const void *b);

#ifdef __cplusplus
}
#endif
#endif
