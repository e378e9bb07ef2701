/* SPDX-License-Identifier: Apache-2.0 */
/* The same medium in larger voxels. */
#ifndef MURK_MEDIUM_COARSEN_H
#define MURK_MEDIUM_COARSEN_H

#include "medium.h"

/*
 * Makes a medium whose voxels cover 2^shift voxels of this one each way, counted from the low
 * corner of its zones, so that translations change nothing. kappa_t is the mean over them, voxels
 * that are no zones included; the albedo is the mean weighted by kappa_t; there is no emission.
 * shift 0 shares the medium itself. Its input is NULL.
 */
murk_status murk_medium_coarsen(murk_context *context, const murk_medium *medium, int shift,
                                murk_medium **out);

/* For the voxels of a brick of the fine grid that are zones, the slot of the coarse voxel that
   covers them; others are undefined. */
void murk_coarse_slots(const murk_grid *fine, const murk_grid *coarse, int shift, size_t brick,
                       size_t slots[MURK_BRICK_SLOTS]);

#endif
