/* SPDX-License-Identifier: Apache-2.0 */
/* The states of the lines of one lattice while they cross the medium. */
#ifndef MURK_EXCHANGE_PLANE_H
#define MURK_EXCHANGE_PLANE_H

#include "boundary.h"

/* A page is 64 x 64 lines, in 8 x 8 tiles of 8 x 8. */
enum { MURK_PAGE = 64, MURK_PAGE_LINES = MURK_PAGE * MURK_PAGE, MURK_TILE = 8 };

/*
 * Lines are kept in pages that come into being where a brick first meets one of their lines: memory
 * follows the bricks and not the box around them, and a line keeps its state across empty space at
 * no cost. Within a page the tiles that are met get their state from the boundary, the rest none.
 */
typedef struct murk_plane {
    const murk_boundary *boundary;
    const murk_incoming *incoming;
    int32_t (*place)[2]; /* page coordinates */
    uint64_t *tiles;     /* which tiles of a page have been met: bit v * 8 + u */
    float *state;        /* MURK_PAGE_LINES a page */
    size_t count, capacity;
    int32_t *bucket; /* hash of page numbers, -1 where free */
    size_t bucket_mask;
    double entered; /* sum of the states as they entered */
} murk_plane;

/* A window of lines (u, v) ... of at most MURK_WINDOW each way, opened for the kernel. */
typedef struct murk_window {
    float *state;     /* of line (u, v) */
    ptrdiff_t stride; /* between rows */
    int32_t u, v;     /* where the copy starts */
    int rows, runs;
    bool copied;
    float copy[MURK_WINDOW * 24]; /* used where the window lies across pages */
} murk_window;

/* Starts anew for one lattice; keeps the memory of earlier ones. */
bool murk_plane_reset(murk_plane *plane, const murk_boundary *boundary,
                      const murk_incoming *incoming);
void murk_plane_clear(murk_plane *plane);

/* Opens lines u0 ... u1, v0 ... v1 (both included); false when memory runs out. Every window is
   closed before the next is opened. */
bool murk_plane_open(murk_plane *plane, int32_t u0, int32_t u1, int32_t v0, int32_t v1,
                     murk_window *window);
void murk_plane_close(murk_plane *plane, murk_window *window);

/* Lets the lines end: adds to the patches as murk_boundary_leave() does (patch_power may be NULL),
   and returns the sum of power_per_line * (I_in - I_out). */
double murk_plane_leave(const murk_plane *plane, double power_per_line, double *patch_power);

#endif
