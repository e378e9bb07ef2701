/* SPDX-License-Identifier: Apache-2.0 */
/* A quantity from the voxels of one transform to those of another. */
#ifndef MURK_MEDIUM_RESAMPLE_H
#define MURK_MEDIUM_RESAMPLE_H

#include "bricks.h"
#include "context.h"

/* What holds where a grid has no active voxel. */
typedef enum murk_absence {
    /* The background is a value like any other. For what is there or not, as emission: the part of
       a voxel that no flame fills emits nothing, and the light as a whole stays the same. */
    MURK_ABSENT_IS_BACKGROUND,
    /* Nothing is known: active voxels alone count, the background holds where none is near. For
       properties of the medium, as temperature and albedo: at the rim of a fire, the mean of 1500 K
       and "no smoke here" is the temperature of nothing. */
    MURK_ABSENT_IS_UNKNOWN
} murk_absence;

typedef struct murk_resample_options {
    murk_absence absence;
    bool corner; /* voxels cover [i, i+1] of either grid's index space, not [i-1/2, i+1/2] */
} murk_resample_options;

typedef struct murk_resample_report {
    uint64_t covered; /* target voxels that an active voxel of the source has a part in */
    uint64_t invalid; /* NaN or infinite voxels of the source, taken as inactive */
} murk_resample_report;

/*
 * Makes *out, the active voxels of `target` with the values of `source`, which lies on any other
 * transform with right angles. A voxel gets the trilinear interpolant of the source at its centre;
 * where it spans more than one voxel of the source, the mean over points that are one voxel of the
 * source apart at most. So linear fields stay what they are, and a finer source keeps its mean:
 * exactly where the ratio of aligned edges is a whole number up to 4. Sources still finer are
 * averaged over 2, 4, 8, ... voxels before that, so that the cost is that of both grids' voxels.
 * Voxels of the source that are NaN or infinite become inactive in it. out->index_to_world is the
 * target's, out->background the source's. Fails when memory runs out.
 */
murk_status murk_resample(murk_context *context, murk_bricks *source, const murk_bricks *target,
                          const murk_resample_options *options, murk_bricks *out,
                          murk_resample_report *report);

#endif
