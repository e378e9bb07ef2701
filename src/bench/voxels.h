/* SPDX-License-Identifier: Apache-2.0 */
/* A medium while it is being made: bricks in a hash table, voxel by voxel. */
#ifndef BENCH_VOXELS_H
#define BENCH_VOXELS_H

#include "murk/murk.h"

enum { BENCH_EDGE = 8, BENCH_SLOTS = 512 };

/* Zeroed before use; bricks and values as in murk_brick_array. */
struct bench_voxels {
    size_t count, capacity; /* of bricks */
    int32_t *brick;
    float *kappa_t;
    size_t *bucket; /* brick number + 1, or 0 */
    size_t bucket_count;
    double voxel_size[3];
    double albedo;
};

void bench_voxels_release(struct bench_voxels *voxels);

/* The 512 values of a brick, which is made where there is none; NULL when memory runs out. Valid
   until the next brick is made. */
float *bench_voxels_brick(struct bench_voxels *voxels, int32_t x, int32_t y, int32_t z);

/* The value of one voxel, likewise. */
float *bench_voxels_at(struct bench_voxels *voxels, int32_t i, int32_t j, int32_t k);

/* The voxel that value i of kappa_t belongs to. */
void bench_voxels_index(const struct bench_voxels *voxels, size_t i, int32_t index[3]);

/* Voxels that are not 0. */
size_t bench_voxels_active(const struct bench_voxels *voxels);

/* The box of the voxels that are not 0, hi exclusive. There has to be one. */
void bench_voxels_box(const struct bench_voxels *voxels, int32_t lo[3], int32_t hi[3]);

/* Keeps about `count` voxels, those with the largest values: each becomes what it is above the
   threshold, plus `rim`; the others become 0. Bricks without any are dropped. */
bool bench_voxels_keep(struct bench_voxels *voxels, size_t count, double rim);

/* Multiplies kappa_t so that the deepest column along an axis has this optical depth. */
bool bench_voxels_set_depth(struct bench_voxels *voxels, int axis, double depth);

/* Adds two clusters of 8 voxels that double the box on each axis: to both sides in x and y, upwards
   in z. */
bool bench_voxels_widen(struct bench_voxels *voxels);

/* The medium of the voxels. */
murk_status bench_voxels_medium(murk_context *context, const struct bench_voxels *voxels,
                                murk_medium **out);

#endif
