/* SPDX-License-Identifier: Apache-2.0 */
/* Radiosity laid out for trilinear interpolation without a look-up across bricks. */
#ifndef MURK_RENDER_BLOCKS_H
#define MURK_RENDER_BLOCKS_H

#include "solution.h"

/* A brick of zones with one voxel around it. */
enum { MURK_BLOCK_EDGE = 10, MURK_BLOCK_SLOTS = 1000 };

/* One block per brick of the medium's grid; free with murk_free(), NULL when memory runs out. */
float *murk_blocks_create(murk_context *context, const murk_solution *solution);

/* Whether any zone radiates by itself what a float could tell from the brightest zone's light. */
bool murk_blocks_any_glow(const murk_solution *solution);

/* The same of (1 - albedo) E, the part of B that zones radiate by themselves. */
float *murk_blocks_glow(murk_context *context, const murk_solution *solution);

#endif
