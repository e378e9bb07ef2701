/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks of voxels twice as long. */
#ifndef MURK_MEDIUM_HALVE_H
#define MURK_MEDIUM_HALVE_H

#include "bricks.h"
#include "context.h"

/* The means over 2 voxels along each of the axes that are named: voxel 2i and 2i + 1 become i. Of
   voxels that are not active the background counts where fill is set, else nothing; a mean is
   active where any of its voxels is. index_to_world of *out is not set. Fails when memory runs
   out. */
murk_status murk_bricks_halve(murk_context *context, const murk_bricks *bricks, const bool axes[3],
                              bool fill, murk_bricks *out);

#endif
