/* SPDX-License-Identifier: Apache-2.0 */
/* Lines of sight: optical depths through a medium, and where lines meet the ground. */
#ifndef MURK_EXCHANGE_SIGHT_H
#define MURK_EXCHANGE_SIGHT_H

#include "ground.h"
#include "medium.h"

/* All vectors in the grid frame [m]. */
typedef struct murk_sight {
    const murk_grid *grid;
    const float *kappa_t;
    const murk_ground *ground; /* or NULL */
    double box[3];             /* the zones lie in [0, box] */
    double kappa_uniform;      /* where the zones fill the box with one kappa_t; else 0 */
    double kappa_max;
    double a[3], b[3], up[3]; /* unit vectors of the ground's coordinates */
    double origin[3];         /* the frame's origin in (a, b, height above the ground) */
    double clearance;         /* height of the box above the ground; negative: it is cut */
} murk_sight;

void murk_sight_init(murk_sight *sight, const murk_medium *medium, const murk_ground *ground);

/* Optical depth of [BG91] eq. (6) for t0 <= t <= t1 along a line. */
double murk_sight_depth(const murk_sight *sight, const double origin[3], const double direction[3],
                        double t0, double t1);

/* A point in the ground's coordinates (a, b, height). */
void murk_sight_project(const murk_sight *sight, const double point[3], double out[3]);

/* Range of t in which a line is in the box [lo, hi]; false where it misses. */
bool murk_box_chord(const double lo[3], const double hi[3], const double origin[3],
                    const double direction[3], double t[2]);

/* (1 - exp(-x)) / x: what escapes of the light emitted along a chord of optical length x. */
double murk_chord_escape(double x);

#endif
