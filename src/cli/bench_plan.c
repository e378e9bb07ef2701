/* SPDX-License-Identifier: Apache-2.0 */
/* What murk bench is to measure. */
#include "bench.h"

#include "cases.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The largest media for emptiness and threads, for errors where no sizes are given, and for
   pairwise exchange. */
static const double MIDDLE = 1e5, SMALL = 3e3, PAIRWISE = 1e4;

/* The solution that errors are taken against. */
enum { TRUE_DIRECTIONS = 3072, TRUE_RAYS = 2 };
static const double TRUE_TOLERANCE = 0.001;

/* What is compared with it: tolerances of lines, edges of windows, and where none are given packets
   of the Monte Carlo. From MANY on a single run has to do. */
static const double ASKED[] = {0.05, 0.02, 0.01, 0.005, 0.003};
static const int WINDOWS[] = {3, 5, 9};
static const struct cli_list PACKETS = {5, {1e3, 1e4, 1e5, 1e6, 1e7}};
static const double MANY = 1e6;
enum {
    ASKED_COUNT = sizeof ASKED / sizeof *ASKED,
    WINDOW_COUNT = sizeof WINDOWS / sizeof *WINDOWS,
    ERROR_ROWS = 2 + ASKED_COUNT + WINDOW_COUNT + CLI_LIST_MOST
};

/* More rows than any list of options can ask for. */
enum { ROWS_MOST = BENCH_CASE_COUNT * (CLI_LIST_MOST + ERROR_ROWS) + 2 * ERROR_ROWS + 64 };

/* The sizes that are measured where none are given, and the largest of them for each case. */
static const struct cli_list SIZES = {5, {1e4, 3e4, 1e5, 3e5, 1e6}};
static const double MOST[BENCH_CASE_COUNT] = {1e6, 1e5, 1e5, 1e5, 3e4};

static struct cli_list sizes_of(const struct cli_bench *bench, int medium)
{
    struct cli_list sizes = bench->options->sizes;
    if (sizes.count == 0)
        for (sizes = SIZES; sizes.value[sizes.count - 1] > MOST[medium];)
            sizes.count--;
    return sizes;
}

/* The largest size that is asked for and no larger than `most`, or else the smallest. */
static double size_up_to(const struct cli_bench *bench, int medium, double most)
{
    const struct cli_list sizes = sizes_of(bench, medium);
    double size = sizes.value[0];
    for (int i = 0; i < sizes.count && sizes.value[i] <= most; i++)
        size = sizes.value[i];
    return size;
}

static bool has_case(const struct cli_bench *bench, int medium)
{
    return !bench->options->cases || bench->options->cases >> medium & 1;
}

static int first_case(const struct cli_bench *bench)
{
    int medium = 0;
    while (!has_case(bench, medium))
        medium++;
    return medium;
}

/* A new row with the options of the command line. */
static struct cli_bench_row *add(struct cli_bench *bench, enum cli_bench_part part, int medium,
                                 double size)
{
    struct cli_bench_row *row = &bench->row[bench->count++];
    *row = (struct cli_bench_row){
        .part = part,
        .medium = medium,
        .name = medium == BENCH_VOLUME ? bench->volume_name : BENCH_CASES[medium].name,
        .scene = medium == BENCH_VOLUME ? bench_scene_alone : BENCH_CASES[medium].scene,
        .size = size,
        .solve = bench->options->solve,
        .threads = bench->options->threads,
        .times = bench->options->runs};
    return row;
}

static void add_growth(struct cli_bench *bench)
{
    for (int medium = 0; medium < BENCH_CASE_COUNT; medium++) {
        const struct cli_list sizes = sizes_of(bench, medium);
        for (int i = 0; has_case(bench, medium) && i < sizes.count; i++)
            add(bench, CLI_BENCH_GROWTH, medium, sizes.value[i]);
    }
}

static void add_emptiness(struct cli_bench *bench)
{
    int medium = first_case(bench);
    double size = size_up_to(bench, medium, MIDDLE);
    add(bench, CLI_BENCH_EMPTINESS, medium, size);
    add(bench, CLI_BENCH_EMPTINESS, medium, size)->wide = true;
}

static void add_threads(struct cli_bench *bench)
{
    int medium = first_case(bench), most = bench->options->threads;
    double size = size_up_to(bench, medium, MIDDLE);
    if (most == 0)
        most = (int)sysconf(_SC_NPROCESSORS_ONLN);
    for (int threads = 1; threads < most; threads *= 2)
        add(bench, CLI_BENCH_THREADS, medium, size)->threads = threads;
    add(bench, CLI_BENCH_THREADS, medium, size)->threads = most;
}

/* A row of errors; the ground of the default scene is left out, since it hides the medium's part.
 */
static struct cli_bench_row *add_error(struct cli_bench *bench, int medium, double size)
{
    struct cli_bench_row *row = add(bench, CLI_BENCH_ERROR, medium, size);
    if (row->scene == bench_scene_default)
        row->scene = bench_scene_alone;
    return row;
}

static void add_pairwise(struct cli_bench *bench, int medium, double size, int window)
{
    struct cli_bench_row *row = add_error(bench, medium, size);
    row->solve.method = MURK_PAIRWISE;
    row->times = 1; /* its time is that of very many factors */
    for (int a = 0; a < 3; a++)
        row->solve.window[a] = window;
}

static void add_errors_of(struct cli_bench *bench, int medium, double size)
{
    struct cli_bench_row *row = add_error(bench, medium, size);
    row->truth = true;
    row->times = 1;
    row->solve.tolerance = TRUE_TOLERANCE;
    row->solve.directions = TRUE_DIRECTIONS;
    row->solve.rays = TRUE_RAYS;
    for (int i = 0; i < ASKED_COUNT; i++)
        add_error(bench, medium, size)->solve.tolerance = ASKED[i];
    if (size <= PAIRWISE)
        add_pairwise(bench, medium, size, 0);
    for (int i = 0; i < WINDOW_COUNT && size <= PAIRWISE; i++)
        add_pairwise(bench, medium, size, WINDOWS[i]);
    const struct cli_list given = bench->options->packets, packets = given.count ? given : PACKETS;
    for (int i = 0; i < packets.count; i++) {
        row = add_error(bench, medium, size);
        row->packets = (long)packets.value[i];
        if (packets.value[i] >= MANY)
            row->times = 1;
    }
}

/* The paper's figure 1, the cloud or else the cases that are asked for by name, and a file. */
static void add_errors(struct cli_bench *bench)
{
    const bool sizes = bench->options->sizes.count > 0;
    add_errors_of(bench, BENCH_FIGURE_1, 1e3);
    for (int medium = 0; medium < BENCH_CASE_COUNT; medium++)
        if (bench->options->cases ? has_case(bench, medium) : medium == BENCH_CLOUD)
            add_errors_of(bench, medium, sizes ? size_up_to(bench, medium, PAIRWISE) : SMALL);
    if (bench->options->volume)
        add_errors_of(bench, BENCH_VOLUME, (double)bench->volume_zones);
}

/* [BG91] section 5, by the paper's method and by lines. */
static void add_paper(struct cli_bench *bench)
{
    static const int WINDOW[3] = {10, 10, 4};
    const murk_solve_options lines = MURK_SOLVE_DEFAULT;
    murk_solve_options paper = lines; /* and its epsilon = 1e-9 */
    paper.method = MURK_PAIRWISE;
    paper.solver = MURK_GAUSS_SEIDEL;

    struct cli_bench_row *row = add(bench, CLI_BENCH_PAPER, BENCH_FIGURE_1, 1e3);
    row->solve = paper;
    row->then = "13 iterations, 73 s";
    add(bench, CLI_BENCH_PAPER, BENCH_FIGURE_1, 1e3)->solve = lines;

    memcpy(paper.window, WINDOW, sizeof paper.window);
    row = add(bench, CLI_BENCH_PAPER, BENCH_PAPER_LARGE, 1e5);
    row->solve = paper;
    row->then = "22 min 45 s an iteration";
    row = add(bench, CLI_BENCH_PAPER, BENCH_PAPER_LARGE, 1e5);
    row->solve = lines;
    row->then = "\"over a year\"";
}

murk_status cli_bench_plan(struct cli_bench *bench)
{
    unsigned parts = bench->options->parts ? bench->options->parts : ~0u;
    bench->row = calloc(ROWS_MOST, sizeof *bench->row);
    if (!bench->row)
        return MURK_ERROR_MEMORY;
    if (parts & CLI_BENCH_GROWTH)
        add_growth(bench);
    if (parts & CLI_BENCH_EMPTINESS)
        add_emptiness(bench);
    if (parts & CLI_BENCH_THREADS)
        add_threads(bench);
    if (parts & CLI_BENCH_ERROR)
        add_errors(bench);
    if (parts & CLI_BENCH_PAPER)
        add_paper(bench);
    return MURK_OK;
}
