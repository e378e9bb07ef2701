/* SPDX-License-Identifier: Apache-2.0 */
/* What murk bench prints for people. */
#include "bench.h"

#include "cases.h"
#include "columns.h"
#include "statistics.h"

#include <stdio.h>
#include <string.h>

/* A part's columns: two rows of heading, and what adds the cells of a row. */
struct layout {
    const char *title;
    const char *const *head, *const *units; /* NULL-terminated */
    unsigned left;
    void (*add)(struct cli_columns *cells, const struct cli_bench_row *row);
};

static double megabytes(const struct bench_result *result)
{
    return 1e-6 * result->peak_bytes;
}

/* ---- growth -------------------------------------------------------------------------------- */

#define GROWTH_HEAD                                                                                \
    "", "zones", "bricks", "dirs", "iter", "sweeps", "est", "setup", "light", "solve", "finish",   \
        "total", "memory", "work"
#define GROWTH_UNITS "", "", "", "", "", "", "%", "s", "s", "s", "s", "s", "B/zone", "ns"

static const char *const GROWTH[] = {GROWTH_HEAD, NULL};
static const char *const GROWTH_UNIT[] = {GROWTH_UNITS, NULL};
static const char *const GROWTH_RENDER[] = {GROWTH_HEAD, "render", NULL};
static const char *const GROWTH_RENDER_UNIT[] = {GROWTH_UNITS, "s", NULL};

static void add_growth(struct cli_columns *cells, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    cli_columns_add(cells, "%s", row->name);
    cli_columns_number(cells, 3, r->zones);
    cli_columns_number(cells, 3, r->bricks);
    cli_columns_number(cells, 3, r->directions);
    cli_columns_number(cells, 3, r->iterations);
    cli_columns_number(cells, 3, r->sweeps);
    cli_columns_number(cells, 2, 100 * r->estimate);
    cli_columns_seconds(cells, r->seconds_setup);
    cli_columns_seconds(cells, r->seconds_light);
    cli_columns_seconds(cells, r->seconds_solve);
    cli_columns_seconds(cells, r->seconds_finish);
    cli_columns_seconds(cells, r->seconds);
    cli_columns_number(cells, 3, r->bytes_per_zone);
    cli_columns_number(cells, 3, r->ns_per_crossing);
}

static void add_growth_render(struct cli_columns *cells, const struct cli_bench_row *row)
{
    add_growth(cells, row);
    cli_columns_seconds(cells, row->outcome.median.seconds_render);
}

/* One line for each medium that was measured at several sizes. */
static void print_fits(const struct cli_bench *bench)
{
    for (int medium = 0; medium < BENCH_CASE_COUNT; medium++) {
        struct cli_bench_fit fit;
        if (cli_bench_fit(bench, medium, &fit))
            printf("%s: time ~ N^%.2f, memory ~ N^%.2f\n", BENCH_CASES[medium].name, fit.time,
                   fit.memory);
    }
}

/* ---- the other parts ----------------------------------------------------------------------- */

static const char *const EMPTINESS[] = {"", "", "zones", "bricks", "dirs", "total", "memory", NULL};
static const char *const EMPTINESS_UNIT[] = {"", "", "", "", "", "s", "MB", NULL};

static void add_emptiness(struct cli_columns *cells, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    cli_columns_add(cells, "%s", row->name);
    cli_columns_add(cells, "%s", row->wide ? "8 x the box" : "alone");
    cli_columns_number(cells, 3, r->zones);
    cli_columns_number(cells, 3, r->bricks);
    cli_columns_number(cells, 3, r->directions);
    cli_columns_seconds(cells, r->seconds);
    cli_columns_number(cells, 3, megabytes(r));
}

static const char *const THREADS[] = {"", "zones", "threads", "solve", "total", "work", NULL};
static const char *const THREADS_UNIT[] = {"", "", "", "s", "s", "ns", NULL};

static void add_threads(struct cli_columns *cells, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    cli_columns_add(cells, "%s", row->name);
    cli_columns_number(cells, 3, r->zones);
    cli_columns_number(cells, 3, r->threads);
    cli_columns_seconds(cells, r->seconds_solve);
    cli_columns_seconds(cells, r->seconds);
    cli_columns_number(cells, 3, r->ns_per_crossing);
}

static const char *const ERRORS[] = {"",     "method", "zones", "asked",   "est",   "error",
                                     "95 %", "dirs",   "iter",  "packets", "total", NULL};
static const char *const ERRORS_UNIT[] = {"", "", "", "%", "%", "%", "%", "", "", "", "s", NULL};

static void add_error(struct cli_columns *cells, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    cli_columns_add(cells, "%s", row->name);
    if (row->solve.window[0] > 0)
        cli_columns_add(cells, "pairwise, %dx%dx%d", row->solve.window[0], row->solve.window[1],
                        row->solve.window[2]);
    else
        cli_columns_add(cells, "%s", row->truth ? "reference" : cli_bench_method(row));
    cli_columns_number(cells, 3, r->zones);
    cli_columns_number(cells, 3, row->truth ? NAN : 100 * r->tolerance);
    cli_columns_number(cells, 2, 100 * r->estimate);
    cli_columns_number(cells, 2, 100 * r->error);
    cli_columns_number(cells, 2, 100 * r->error_95);
    cli_columns_number(cells, 3, r->directions > 0 ? r->directions : NAN);
    cli_columns_number(cells, 3, r->iterations);
    cli_columns_number(cells, 3, r->packets);
    cli_columns_seconds(cells, r->seconds);
}

static const char *const PAPER[] = {"",      "method", "eq. (18), (19)", "iter", "setup",
                                    "solve", "total",  "in 1991",        NULL};
static const char *const PAPER_UNIT[] = {"", "", "multiplications", "", "s", "s", "s", "", NULL};

static void add_paper(struct cli_columns *cells, const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    const int *window = row->solve.window;
    if (window[0] > 0)
        cli_columns_add(cells, "%s, %dx%dx%d", row->name, window[0], window[1], window[2]);
    else
        cli_columns_add(cells, "%s", row->name);
    cli_columns_add(cells, "%s", cli_bench_method(row));
    cli_columns_add(cells, "%.2g", r->multiplications);
    cli_columns_number(cells, 3, r->iterations);
    cli_columns_seconds(cells, r->seconds_setup);
    cli_columns_seconds(cells, r->seconds_solve);
    cli_columns_seconds(cells, r->seconds);
    cli_columns_add(cells, "%s", row->then ? row->then : "");
}

/* Time and memory of the last row of a part over the first. */
static void print_ratio(const struct cli_bench *bench, enum cli_bench_part part)
{
    const struct bench_result *first = NULL, *last = NULL;
    for (size_t i = 0; i < bench->count; i++)
        if (bench->row[i].part == part) {
            last = &bench->row[i].outcome.median;
            first = first ? first : last;
        }
    if (part == CLI_BENCH_THREADS)
        printf("%.3g threads: %.2f times as fast\n", last->threads, first->seconds / last->seconds);
    else
        printf("8 times the volume: time %+.1f %%, memory %+.1f %%\n",
               100 * (last->seconds / first->seconds - 1),
               100 * (last->peak_bytes / first->peak_bytes - 1));
}

/* ---- all ----------------------------------------------------------------------------------- */

static struct layout layout_of(const struct cli_bench *bench, enum cli_bench_part part)
{
    bool render = bench->options->time_render;
    switch (part) {
    case CLI_BENCH_GROWTH:
        return (struct layout){"Growth with the number of zones N (work: ns a zone, direction and "
                               "core)",
                               render ? GROWTH_RENDER : GROWTH,
                               render ? GROWTH_RENDER_UNIT : GROWTH_UNIT, 1,
                               render ? add_growth_render : add_growth};
    case CLI_BENCH_EMPTINESS:
        return (struct layout){"Growth with emptiness", EMPTINESS, EMPTINESS_UNIT, 3,
                               add_emptiness};
    case CLI_BENCH_THREADS:
        return (struct layout){"Threads", THREADS, THREADS_UNIT, 1, add_threads};
    case CLI_BENCH_ERROR:
        return (struct layout){"Run time against error (relative, against the reference)", ERRORS,
                               ERRORS_UNIT, 3, add_error};
    default:
        return (struct layout){"The cases of Borel & Gerstl 1991", PAPER, PAPER_UNIT, 131,
                               add_paper};
    }
}

void cli_bench_table(const struct cli_bench *bench, enum cli_bench_part part)
{
    const struct layout layout = layout_of(bench, part);
    struct cli_columns cells = {.gap = part == CLI_BENCH_GROWTH ? 1 : 2, .left = layout.left};
    while (layout.head[cells.columns])
        cells.columns++;
    for (int c = 0; c < cells.columns; c++)
        cli_columns_add(&cells, "%s", layout.head[c]);
    for (int c = 0; c < cells.columns; c++)
        cli_columns_add(&cells, "%s", layout.units[c]);
    for (size_t i = 0; i < bench->count; i++)
        if (bench->row[i].part == part)
            layout.add(&cells, &bench->row[i]);
    printf("%s\n", layout.title);
    cli_columns_print(&cells);
    if (part == CLI_BENCH_GROWTH)
        print_fits(bench);
    if (part == CLI_BENCH_EMPTINESS || part == CLI_BENCH_THREADS)
        print_ratio(bench, part);
    putchar('\n');
    fflush(stdout);
}
