/* SPDX-License-Identifier: Apache-2.0 */
/* The same medium in smaller voxels. */
#ifndef MURK_MEDIUM_REFINE_H
#define MURK_MEDIUM_REFINE_H

#include "medium.h"

/* Makes a medium whose voxels are halves of this one's each way, with the same coefficients.
   Bricks are counted from that of the low corner of the zones, so that translations change nothing:
   voxel v becomes 2 (v - base) and the next, base being murk_refine_base(). */
murk_status murk_medium_refine(murk_context *context, const murk_medium *medium, murk_medium **out);

/* The first voxel of the brick in which the low corner of the zones lies. */
void murk_refine_base(const murk_grid *zones, int32_t base[3]);

/* fine holds a field on a grid of halves; sets each active voxel of a grid to the mean over the
   eight that it is made of, all of which are active there. */
void murk_refine_average(const murk_grid *fine, const float *field, const int32_t base[3],
                         const murk_grid *grid, float *out);

#endif
