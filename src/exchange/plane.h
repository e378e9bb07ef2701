/* SPDX-License-Identifier: Apache-2.0 */
/* The states of the lines of one lattice while they cross the medium. */
#ifndef MURK_EXCHANGE_PLANE_H
#define MURK_EXCHANGE_PLANE_H

#include "boundary.h"

/* A page is 64 x 64 lines, in 8 x 8 tiles: larger ones were no faster and took more memory. */
enum {
    MURK_PAGE_BITS = 6,
    MURK_PAGE = 1 << MURK_PAGE_BITS,
    MURK_PAGE_LINES = MURK_PAGE * MURK_PAGE
};

/*
 * Lines are kept in pages that come into being where a brick first meets one of their lines, and
 * within a page the tiles that are met get their state from the boundary, the rest none: memory
 * follows the bricks and not the box around them, and a line keeps its state across empty space at
 * no cost.
 */
typedef struct murk_plane {
    const murk_boundary *boundary;
    const murk_incoming *incoming; /* one a band */
    int bands;
    int32_t (*place)[2];          /* page coordinates */
    float **state;                /* of each page: bands x rows v x columns u */
    uint64_t *tiles;              /* which tiles of each page have been met: bit v * 8 + u */
    size_t count, made, capacity; /* pages in use, with memory, with a place in these arrays */
    int made_bands;               /* that their memory is for */
    int32_t *bucket;              /* hash of page numbers, -1 where free */
    size_t bucket_mask;
    double entered[MURK_MOST_BANDS]; /* sums of the states as they entered */
} murk_plane;

/* The lines (u, v) ... of a brick, opened for the kernel. */
typedef struct murk_window {
    float *state;           /* of line (u, v), first band */
    ptrdiff_t stride, band; /* between rows, between bands */
    int32_t u, v;           /* the first line */
    int32_t page[2][2];     /* that it lies in: [along v][along u] from the first */
    int rows, columns;      /* of the lines asked for */
    bool copied;
    float copy[MURK_MOST_BANDS * MURK_WINDOW * 24]; /* used where the window lies across pages */
} murk_window;

/* Starts anew for one lattice; keeps the memory of earlier ones. */
bool murk_plane_reset(murk_plane *plane, const murk_boundary *boundary,
                      const murk_incoming *incoming, int bands);
void murk_plane_clear(murk_plane *plane);

/* Lines u0 ... u1, v0 ... v1, at most MURK_WINDOW each way, entered where they are new. False when
   memory runs out. */
bool murk_plane_open(murk_plane *plane, int32_t u0, int32_t u1, int32_t v0, int32_t v1,
                     murk_window *window);
void murk_plane_close(const murk_plane *plane, murk_window *window);

/* Whether no line of an open window carries more than least[] in any band. */
bool murk_window_dark(const murk_window *window, int bands, const float *least);

/* Lets all lines leave; patch_power [bands] and its arrays may be NULL. Adds what they brought in
   minus what they take along to net_power [bands]. */
void murk_plane_leave(const murk_plane *plane, double power_per_line, double *const *patch_power,
                      double *net_power);

#endif
