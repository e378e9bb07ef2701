/* SPDX-License-Identifier: Apache-2.0 */
/* The ground inside the library: a plane of rectangular patches on a tensor grid. */
#ifndef MURK_SURFACE_GROUND_H
#define MURK_SURFACE_GROUND_H

#include "context.h"

#include <string.h>

/*
 * Horizontal coordinates (a, b): (x, y) for up = z, (x, z) for up = y. Patch (ia, ib) is
 * [a[ia], a[ia+1]] x [b[ib], b[ib+1]], number ib * count[0] + ia. The user's patches are the
 * interior; where horizon is set, margin columns and rows of growing patches surround them and
 * beyond those the ground is undisturbed by the medium.
 */
struct murk_ground {
    int references;
    murk_up up;
    double height;
    bool horizon;
    int interior[2];     /* nx, ny as the user gave them */
    int margin;          /* patches added on every side */
    int count[2];        /* interior + 2 * margin */
    double *edge[2];     /* count + 1 coordinates [m] */
    double per_metre[2]; /* interior patches per metre */
    double *margin_edge; /* margin + 1 outer edges of the margin's patches, in interior patches */
    uint16_t *margin_start; /* by the leading bits of a distance: see murk_ground_column() */
    size_t patch_count;
    float *reflectance; /* rho per patch */
    float *emission;    /* E of the patch itself [W/m^2], not scaled by emissivity */
    double mean_reflectance, mean_emission;
};

enum { MURK_GROUND_HORIZON = -1, MURK_GROUND_NOTHING = -2 };

/* Column of the patch at t on axis c (0: a, 1: b), in interior patches from the first, or -1
   outside. In the margin the exponent and two bits of 1 + the distance find the patch, or the one
   before it: widths grow faster than these steps. */
static inline int murk_ground_column(const murk_ground *ground, int c, double t)
{
    int n = ground->interior[c], margin = ground->margin;
    if (t >= 0 && t < n)
        return margin + (int)t;
    double d = t < 0 ? -t : t - n;
    if (!margin || !(d < ground->margin_edge[margin]))
        return -1;
    float distance = (float)(d + 1);
    uint32_t bits;
    memcpy(&bits, &distance, sizeof bits);
    int i = ground->margin_start[(bits >> 21) - (127u << 2)];
    i += i + 1 < margin && d >= ground->margin_edge[i + 1];
    return t < 0 ? margin - 1 - i : margin + n + i;
}

/* The same at a world coordinate [m]. */
static inline int murk_ground_column_at(const murk_ground *ground, int c, double x)
{
    return murk_ground_column(ground, c,
                              (x - ground->edge[c][ground->margin]) * ground->per_metre[c]);
}

/* Patch number at (a, b); outside: MURK_GROUND_HORIZON or, without horizon, MURK_GROUND_NOTHING. */
static inline int64_t murk_ground_patch(const murk_ground *ground, double a, double b)
{
    int ia = murk_ground_column_at(ground, 0, a), ib = murk_ground_column_at(ground, 1, b);
    if (ia < 0 || ib < 0)
        return ground->horizon ? MURK_GROUND_HORIZON : MURK_GROUND_NOTHING;
    return (int64_t)ib * ground->count[0] + ia;
}

/* Root of the sum over the user's patches of area times the square of b, relative to that of a; 0
   without ground. */
double murk_ground_difference(const murk_ground *ground, const float *a, const float *b);

double murk_ground_area(const murk_ground *ground, size_t patch);
/* Number of the patch at column ia, row ib of the user's interior. */
size_t murk_ground_interior(const murk_ground *ground, int ia, int ib);

/* World axis number (0, 1, 2) of up and of b for either choice of up; a is always 0. */
static inline int murk_axis_up(murk_up up)
{
    return up == MURK_UP_Z ? 2 : 1;
}

static inline int murk_axis_b(murk_up up)
{
    return up == MURK_UP_Z ? 1 : 2;
}

/* Row of an image of the interior that shows the patches of row ib: row 0 is the far edge, that is
   the largest y, or the smallest z where y is up. */
int murk_ground_row(const murk_ground *ground, int ib);

/* The same of a ground, and of a. */
int murk_ground_axis_a(const murk_ground *ground);
int murk_ground_axis_b(const murk_ground *ground);
int murk_ground_axis_up(const murk_ground *ground);

murk_ground *murk_ground_share(const murk_ground *ground);

#endif
