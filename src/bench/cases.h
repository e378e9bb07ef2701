/* SPDX-License-Identifier: Apache-2.0 */
/* The media that murk bench makes, of any number of active voxels. */
#ifndef BENCH_CASES_H
#define BENCH_CASES_H

#include "scenes.h"

/* The rows of BENCH_CASES; the paper's two media come after those of any size. Then there is what
   was read from a file. */
enum {
    BENCH_CLOUD,
    BENCH_BOX,
    BENCH_PLUME,
    BENCH_CHECKERBOARD,
    BENCH_FILAMENTS,
    BENCH_CASE_COUNT,
    BENCH_FIGURE_1 = BENCH_CASE_COUNT,
    BENCH_PAPER_LARGE,
    BENCH_VOLUME
};

#define BENCH_ALBEDO 0.9 /* of all but the paper's */

/* Makes about `count` active voxels, the same on each call. False when memory runs out; *out is to
   be released all the same. */
typedef bool bench_make_fn(double count, struct bench_voxels *out);

bench_make_fn bench_make_cloud;     /* fractal, 10 optical depths at most */
bench_make_fn bench_make_box;       /* homogeneous, 8 optical depths */
bench_make_fn bench_make_plume;     /* a turbulent column, 5 optical depths across at most */
bench_make_fn bench_make_checkers;  /* a box whose every second brick is empty, 4 on average */
bench_make_fn bench_make_filaments; /* thin curves in 1000^3 voxels, 0.3 a voxel */
/* [BG91] section 5, whatever the count: figure 1 with 10 x 10 x 10 zones, and 100 x 100 x 10. */
bench_make_fn bench_make_figure_1;
bench_make_fn bench_make_paper_large;

struct bench_case {
    const char *name;
    bench_make_fn *make;
    bench_scene_fn *scene;
};

extern const struct bench_case BENCH_CASES[];
/* The names of those of any size, NULL-terminated. */
extern const char *const BENCH_CASE_NAMES[BENCH_CASE_COUNT + 1];

#endif
