/* SPDX-License-Identifier: Apache-2.0 */
/* What rays of a block have met up to each depth, where it is recorded. */
#ifndef MURK_RENDER_CURVES_H
#define MURK_RENDER_CURVES_H

#include "packet.h"

/* A ray's way through one voxel; z is the distance along the viewing axis [m]. The extinction is
   constant between. */
typedef struct murk_stretch {
    float from, to;
    float depth; /* optical, of this way alone */
    float path;  /* up to its end, as that of the packet */
    double tau;  /* likewise */
} murk_stretch;

/* One ray's stretches are stretch[first] ... stretch[first + count - 1], front to back. */
typedef struct murk_curve {
    size_t first, count;
} murk_curve;

typedef struct murk_curves {
    murk_stretch *stretch;
    size_t count, capacity;
    murk_curve *curve; /* rays_most for each pixel of a block */
    int *rays;         /* of each pixel so far */
    int pixels, rays_most;
    double *back; /* where the farthest ray of a pixel ends; MURK_FOREVER: where none does */
} murk_curves;

bool murk_curves_create(int pixels, int rays_most, murk_curves *out);
void murk_curves_clear(murk_curves *curves);

/* Makes room for another block. */
void murk_curves_restart(murk_curves *curves);

/* Adds the ray of a lane to a pixel: its trace with the path, the cosine of its angle to the
   viewing axis, and its end [m along the ray]. False when memory runs out. */
bool murk_curves_add(murk_curves *curves, int pixel, const murk_trace *trace, int lane,
                     double cosine, double end);

/* Transmittance and path of a ray up to z. */
void murk_curves_at(const murk_curves *curves, const murk_curve *curve, double z, double *tau,
                    double *path);

#endif
