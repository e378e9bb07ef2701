/* SPDX-License-Identifier: Apache-2.0 */
/* The diffusion limit of the exchange (EQUATIONS.md, "Preconditioner"): voxels and cells of them.
 */
#ifndef MURK_SOLVE_DIFFUSION_H
#define MURK_SOLVE_DIFFUSION_H

#include "medium.h"

#include <math.h>

/* Areas and powers are in units of V^(2/3), so that a cubic voxel has faces of 1. */
typedef struct murk_voxel_shape {
    float edge[3]; /* of a voxel [m] */
    float area[3]; /* of its faces across each axis */
    float weight;  /* 4 kappa V is weight * kappa */
} murk_voxel_shape;

murk_voxel_shape murk_voxel_shape_of(const murk_grid *grid);

/*
 * Resistance between the middle of a voxel and its face, per area. tau / (8/3 + 2 tau g) with
 * g = tau / (3 + tau): 3/8 tau is diffusion; g is what neighbouring zones exchange beyond that
 * because their sources are flat, and leaves 1/2 to an opaque one. Optical depths below 1e-3 count
 * as that, to keep the matrix' contrast at bay: a thousand such voxels still hinder nothing.
 */
static inline float murk_half_resistance(float tau)
{
    float t = 0.5f * (tau + 1e-3f + fabsf(tau - 1e-3f)); /* the larger, without a branch */
    return 0.5f - (4 - 5 / 3.0f * t) / (8 + t * (8 / 3.0f + 2 * t));
}

/* Half resistance of what lies beyond the bricks: Marshak's condition of a vacuum. */
static const float MURK_VACUUM = 0.5f;

/* W = 4 kappa V / albedo of a zone, of which 1 - albedo is what it takes for good of its own light.
   A black zone, in which x is 0, counts as one that is almost black. */
static inline float murk_zone_weight(const murk_voxel_shape *shape, float kappa_t, float albedo)
{
    return shape->weight * kappa_t / (albedo + 1e-6f);
}

/*
 * A matrix over cells in bricks, symmetric and positive definite:
 *     (C x)_i = sink_i x_i + sum over the six faces of face (x_i - x_j),
 * x_j = 0 beyond a face without a neighbour. Faces stand along x [edge + 1][edge][edge], then along
 * y [edge][edge + 1][edge], then along z [edge][edge][edge + 1]; one between bricks is in both.
 */
typedef struct murk_diffusion {
    size_t brick_count;
    int edge;                /* a brick has edge^3 cells: 4, 2 or 1 */
    int32_t (*brick)[3];     /* coordinates from the lowest one, ascending */
    int32_t (*neighbour)[6]; /* at -x, +x, -y, +y, -z, +z, or MURK_NO_BRICK */
    float *face;             /* brick_count * murk_diffusion_faces(edge) */
    float *sink;             /* brick_count * murk_diffusion_cells(edge) */
} murk_diffusion;

static inline size_t murk_diffusion_faces(int edge)
{
    return 3 * (size_t)((edge + 1) * edge * edge);
}

static inline size_t murk_diffusion_cells(int edge)
{
    return (size_t)(edge * edge * edge);
}

/* Where a face or cell of an axis lies: along the axis, and the two others in ascending order. */
typedef struct murk_layout {
    size_t first, along, u, v;
} murk_layout;

murk_layout murk_face_layout(int axis, int edge);
murk_layout murk_cell_layout(int axis, int edge);

/* The matrix on cells of 2 x 2 x 2 voxels of a medium, whether zones or not. */
murk_status murk_diffusion_create(murk_context *context, const murk_medium *medium,
                                  murk_diffusion *out);

/*
 * The matrix on twice as large cells. Within bricks *parent is NULL; bricks of one cell are put
 * together by 2 x 2 x 2 where there are that many, and *parent, the caller's to free, tells the
 * brick of out that each has become part of.
 */
murk_status murk_diffusion_coarsen(murk_context *context, const murk_diffusion *fine,
                                   murk_diffusion *out, int32_t **parent);

void murk_diffusion_clear(murk_diffusion *diffusion);

/* 1 / C_ii of every cell. */
void murk_diffusion_invert_diagonal(const murk_diffusion *diffusion, float *inverse);

/* r = b - C x in the cells of one brick; b and x hold all cells, r those of the brick. */
void murk_diffusion_residual(const murk_diffusion *diffusion, size_t brick, const float *b,
                             const float *x, float *r);

#endif
