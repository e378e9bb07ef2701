/* SPDX-License-Identifier: Apache-2.0 */
/* One picture: everything that its rays need, and the light they bring. */
#ifndef MURK_RENDER_SHOT_H
#define MURK_RENDER_SHOT_H

#include "backdrop.h"
#include "curves.h"
#include "forward.h"
#include "seen.h"

typedef struct murk_shot {
    const murk_solution *solution;
    murk_view view;
    int samples; /* rays a pixel and axis */
    int block;   /* pixels along the edge of a block, whose rays fill whole packets */
    murk_march march;
    bool parts;      /* whether the parts of a sensor's signal are asked for */
    murk_march glow; /* of what zones radiate by themselves; no blocks: nothing, or all of it */
    bool all_glow;   /* light is not scattered: the path radiance is emitted */
    murk_forward peaked;
    murk_bins seen;
    bool has_backdrop;
    murk_backdrop backdrop;
    /* The view in the grid frame, in voxels. */
    double eye[3], right[3], up[3], forward[3];
} murk_shot;

/* Sums over the rays of a pixel. */
typedef struct murk_sum {
    double path, transmittance, surface[3];
    double
        distance; /* of rays with depth, along the viewing axis: where half of it is passed [m] */
    int deep;     /* number of those */
    double emitted, inherent[3], depth; /* where parts are asked for */
} murk_sum;

/* Pixels along the edge of a block at most. */
enum { MURK_BLOCK_PIXELS = 4 };

/* The view of a camera that can take a picture of a scene and its own solution. */
murk_status murk_shot_view(murk_context *context, const murk_scene *scene,
                           const murk_solution *solution, const murk_camera *camera,
                           murk_view *out);

murk_status murk_shot_create(murk_context *context, const murk_solution *solution,
                             const murk_view *view, const murk_render_options *options,
                             murk_shot *out);
void murk_shot_clear(murk_shot *shot);

/* Of the medium as it is, and of those that murk_forward_march() goes through. */
enum { MURK_SHOT_TRACES = 1 + MURK_FORWARD_TERMS };

/* The pixels of the block with the upper left pixel (left, top), rows of MURK_BLOCK_PIXELS. With
   curves, which else are NULL, also what the rays of each pixel meet on their way: that takes
   MURK_SHOT_TRACES traces, which record, else one does. False when memory runs out. */
bool murk_shot_block(const murk_shot *shot, int left, int top, murk_trace *trace,
                     murk_curves *curves, murk_sum sum[MURK_BLOCK_PIXELS * MURK_BLOCK_PIXELS]);

#endif
