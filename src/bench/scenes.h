/* SPDX-License-Identifier: Apache-2.0 */
/* What the media of murk bench are lit by. */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include "voxels.h"

/* Makes the scene of a medium, and its ground, which is the caller's to release. */
typedef murk_status bench_scene_fn(murk_context *context, const murk_medium *medium,
                                   murk_scene *scene, murk_ground **ground);

/* murk_scene_default(). */
bench_scene_fn bench_scene_default;

/* The same sun and sky without a ground. */
bench_scene_fn bench_scene_alone;

/* [BG91] section 5: a sun overhead and one patch under each column of zones, of reflectance 0.3,
   and 0.6 in a square in the middle. */
bench_scene_fn bench_scene_paper;

/* The reflectance of the patch in a column and a row of nx * ny there; the same from both ends. */
float bench_paper_reflectance(int column, int row, int nx, int ny);

#endif
