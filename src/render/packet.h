/* SPDX-License-Identifier: Apache-2.0 */
/* Rays that go through the medium side by side. */
#ifndef MURK_RENDER_PACKET_H
#define MURK_RENDER_PACKET_H

#include "context.h"

#include <math.h>

enum { MURK_LANES = 16 };

/* t_max of a ray that does not end. */
#define MURK_FOREVER 1e30

/* Rays in the grid frame, in voxels, and what they met; t in metres from the origin. */
typedef struct murk_packet {
    double origin[3][MURK_LANES], direction[3][MURK_LANES];
    double inverse[3][MURK_LANES]; /* 1 / direction, finite */
    double t_max[MURK_LANES];      /* the end, finite; 0 for a lane that has no ray */
    double depth[MURK_LANES];      /* optical depth */
    double tau[MURK_LANES];  /* transmittance so far; stays where it cannot be seen any more */
    double path[MURK_LANES]; /* sum of tau (1 - e^{-x}) B [W/m^2] */
} murk_packet;

/* A component of a direction, such that its inverse is finite as a float too. */
static inline double murk_packet_direction(double d)
{
    return fabs(d) > 1e-30 ? d : 1e-30;
}

/* What a packet passed, step by step; one per thread. */
typedef struct murk_passed {
    float t[MURK_LANES], depth[MURK_LANES]; /* at the end of the step */
    float kappa_t[MURK_LANES];
} murk_passed;

typedef struct murk_trace {
    murk_passed *passed;
    float (*path)[MURK_LANES]; /* the packet's path there; NULL where it is not recorded */
    size_t count, capacity;
    bool records; /* the path too */
} murk_trace;

#endif
