/* SPDX-License-Identifier: Apache-2.0 */
/* Sparse bricks of voxels: where the zones are, and how to find them. */
#ifndef MURK_GRID_GRID_H
#define MURK_GRID_GRID_H

#include "bricks.h"
#include "context.h"

enum { MURK_NO_BRICK = -1 };

/*
 * Values on a grid ("fields") are arrays of brick_count * 512 floats in the slot order of
 * bricks.h; slots that are not active hold 0.
 *
 * Grid frame: metres along the three index axes, from the low corner of voxel (0, 0, 0) + lo.
 * A voxel's cell is [i, i + 1] - lo in units of voxel[]; everything that traces rays works there,
 * so that translations and the orientation of the grid in the world change nothing.
 */
typedef struct murk_grid {
    size_t brick_count;
    int32_t (*brick)[3]; /* ascending in (x, y, z) */
    uint64_t (*mask)[8]; /* active voxels, as in murk_bricks */
    size_t
        *zone_first; /* number of the first active voxel of a brick; [brick_count] is the total */
    size_t zone_count;
    int32_t lo[3], hi[3]; /* box of the active voxels, hi exclusive; lo == hi where empty */
    double voxel[3];      /* edge lengths of a voxel [m] */
    double axis[3][3];    /* axis[a]: unit vector in the world along index axis a */
    double corner[3];     /* world position of the grid frame's origin */
    double volume;        /* of a voxel [m^3] */
    double middle[3];     /* of the box in cells from lo: lattices of lines are laid out about it */
    int32_t *bucket;      /* hash table of brick numbers, MURK_NO_BRICK where free */
    size_t bucket_mask;
} murk_grid;

/* Makes a grid of the bricks' topology, copied; they must ascend in (x, y, z), and those without an
   active voxel are dropped. corner: cells are [i, i+1] rather than [i-1/2, i+1/2] about the
   transform's index. Fails for a transform that is singular or not at right angles. */
murk_status murk_grid_create(murk_context *context, const murk_bricks *bricks, bool corner,
                             murk_grid **out);
void murk_grid_release(murk_grid *grid);

/* The active voxels and all within `margin` (<= 8) of them in any of the 26 directions. */
murk_status murk_grid_dilate(murk_context *context, const murk_grid *grid, int margin,
                             murk_grid **out);

/* Brick number at brick coordinates, or MURK_NO_BRICK. */
int32_t murk_grid_find(const murk_grid *grid, int32_t x, int32_t y, int32_t z);

static inline bool murk_grid_active(const murk_grid *grid, size_t brick, int slot)
{
    return grid->mask[brick][slot >> 6] >> (slot & 63) & 1;
}

/* Slot number brick*512 + slot of a voxel, or -1 where its brick does not exist. */
int64_t murk_grid_slot(const murk_grid *grid, int32_t i, int32_t j, int32_t k);

/* Slot number of the voxel one step (1 or -1) from another along an axis, or -1 likewise. */
int64_t murk_grid_beside(const murk_grid *grid, size_t slot, int axis, int step);

/* Whether two grids have the same active voxels in the same places of the world. */
bool murk_grid_same(const murk_grid *a, const murk_grid *b);

/* World <-> grid frame. Directions are turned, not scaled. */
void murk_grid_to_world(const murk_grid *grid, const double frame[3], double world[3]);
void murk_grid_from_world(const murk_grid *grid, const double world[3], double frame[3]);
void murk_grid_direction_to_world(const murk_grid *grid, const double frame[3], double world[3]);
void murk_grid_direction_from_world(const murk_grid *grid, const double world[3], double frame[3]);

#endif
