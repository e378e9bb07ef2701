/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange of a zone with the zones around it and with what lies outside the medium, by lines
   through the zone. */
#ifndef MURK_EXCHANGE_FACTOR_NEAR_H
#define MURK_EXCHANGE_FACTOR_NEAR_H

#include "sight.h"

/* Lines through a zone, the same for all: points in units of the zone's edges, directions. Mirror
   images on all three axes stand together. */
typedef struct murk_lines_through {
    size_t count;
    double (*point)[3], (*direction)[3];
} murk_lines_through;

/* base sets of 8 mirror images; murk_lines_through_base() spends a total on a number of zones. */
murk_status murk_lines_through_create(murk_context *context, size_t base, murk_lines_through *out);
size_t murk_lines_through_base(size_t total, size_t zones);
void murk_lines_through_clear(murk_lines_through *lines);

/* What the lines through a zone met. Offsets up to reach[] cells on each axis:
   (dx + reach[0]) * (2 reach[1] + 1) * (2 reach[2] + 1) + ... */
typedef struct murk_near {
    int reach[3];
    double *length; /* mean length in each zone [m] */
    double *caught; /* mean share of the light that it takes, over its kappa_t [m] */
    double self;    /* mean share that the zone takes of its own light */
    double chord;   /* mean of half the optical length of the chords: self in a thin zone */
    double up;      /* share that leaves upwards, or everywhere without a ground */
    double down;    /* share that meets the ground beside the patches */
    double ground;  /* share that meets any patch */
    double *patch;  /* share that meets each patch; NULL: not asked for */
} murk_near;

static inline size_t murk_near_count(const int reach[3])
{
    return (size_t)(2 * reach[0] + 1) * (size_t)(2 * reach[1] + 1) * (size_t)(2 * reach[2] + 1);
}

/* Traces the lines through the zone at cell[]; near->reach and its arrays are the caller's. */
void murk_near_trace(const murk_sight *sight, const murk_lines_through *lines,
                     const int32_t cell[3], double kappa, murk_near *near);

/* The part of what leaves a zone and a uniform box that goes upwards. */
double murk_near_upwards(const murk_sight *sight, const murk_lines_through *lines,
                         const int32_t cell[3]);

#endif
