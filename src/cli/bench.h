/* SPDX-License-Identifier: Apache-2.0 */
/* murk bench: run time, memory and error on media made in memory. */
#ifndef CLI_BENCH_H
#define CLI_BENCH_H

#include "bench_panels.h"
#include "options.h"
#include "run.h"
#include "terminal.h"

/* One line of a table: what is measured, and what came out. */
struct cli_bench_row {
    enum cli_bench_part part;
    int medium; /* which of BENCH_CASES, or BENCH_VOLUME */
    const char *name;
    bench_scene_fn *scene;
    double size; /* active voxels asked for */
    bool wide;   /* in a box 8 times as large */
    bool truth;  /* the others of this medium are compared with it */
    murk_solve_options solve;
    long packets;     /* > 0: a Monte Carlo in place of the solve */
    int threads;      /* 0: all */
    int times;        /* how often it runs */
    const char *then; /* [BG91]: what it took in 1991 */
    struct bench_outcome outcome;
};

struct cli_bench {
    const struct cli_options *options;
    const char *command_line;
    struct cli_terminal terminal;
    murk_context *context;
    char processor[128];
    struct bench_voxels volume; /* what --volume names, until it is measured */
    size_t volume_zones;
    char volume_name[64];
    struct cli_panels *curves; /* what --curves names; NULL: nothing */
    struct cli_bench_row *row;
    size_t count;
};

/* Exponents of growth with the number of zones. */
struct cli_bench_fit {
    double time, memory;
};

int cli_bench(const struct cli_options *options, const char *command_line);

/* Lists in bench->row all that the options ask for, part by part. */
murk_status cli_bench_plan(struct cli_bench *bench);

/* "lines", "pairwise", "pairwise, window" or "Monte Carlo". */
const char *cli_bench_method(const struct cli_bench_row *row);

/* The fit for one of BENCH_CASES; false where there are no two sizes of it. */
bool cli_bench_fit(const struct cli_bench *bench, int medium, struct cli_bench_fit *out);

/* Prints what has been measured of a part. */
void cli_bench_table(const struct cli_bench *bench, enum cli_bench_part part);
void cli_bench_json(const struct cli_bench *bench);
murk_status cli_bench_plot(const struct cli_bench *bench, const char *path);

#endif
