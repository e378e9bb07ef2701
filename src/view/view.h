/* SPDX-License-Identifier: Apache-2.0 */
/* The camera as a set of rays. */
#ifndef MURK_VIEW_VIEW_H
#define MURK_VIEW_VIEW_H

#include "context.h"

typedef struct murk_view {
    double eye[3];
    double forward[3], right[3], up[3]; /* unit vectors */
    double half_width, half_height;     /* of the picture at distance 1, or, parallel, of it [m] */
    bool parallel;                      /* rays begin all over the eye's plane */
    int size[2];
} murk_view;

/* Fails for a camera without direction, a zero-size picture a field of view outside (0, 180)
   or a height below 0. */
murk_status murk_view_create(murk_context *context, const murk_camera *camera, murk_view *out);

#endif
