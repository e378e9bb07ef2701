/* SPDX-License-Identifier: Apache-2.0 */
/* What murk bench prints for programs. */
#include "bench.h"

#include "cases.h"
#include "report.h"

#include <math.h>

static json_t *row_json(const struct cli_bench_row *row)
{
    const struct bench_result *r = &row->outcome.median;
    const int *window = row->solve.window;
    json_t *object = json_object();
    json_object_set_new(object, "case", json_string(row->name));
    json_object_set_new(object, "size", cli_json_number(row->size));
    json_object_set_new(object, "method", json_string(cli_bench_method(row)));
    json_object_set_new(
        object, "solver",
        json_string(row->solve.solver == MURK_GAUSS_SEIDEL ? "gauss-seidel" : "cg"));
    json_object_set_new(object, "runs", json_integer(row->times));
    json_object_set_new(object, "kernel", json_string(row->outcome.kernel));
    if (row->part == CLI_BENCH_EMPTINESS)
        json_object_set_new(object, "wide", json_boolean(row->wide));
    if (row->part == CLI_BENCH_ERROR)
        json_object_set_new(object, "reference", json_boolean(row->truth));
    if (row->part == CLI_BENCH_PAPER || row->part == CLI_BENCH_ERROR)
        json_object_set_new(object, "window",
                            window[0] ? json_pack("[i,i,i]", window[0], window[1], window[2])
                                      : json_null());
    if (row->part == CLI_BENCH_PAPER)
        json_object_set_new(object, "paper", cli_json_text(row->then));
#define SET_NUMBER(name) json_object_set_new(object, #name, cli_json_number(r->name));
    BENCH_RESULT_LIST(SET_NUMBER)
#undef SET_NUMBER
    return object;
}

static json_t *fits_json(const struct cli_bench *bench)
{
    json_t *fits = json_object();
    for (int medium = 0; medium < BENCH_CASE_COUNT; medium++) {
        struct cli_bench_fit fit;
        if (cli_bench_fit(bench, medium, &fit))
            json_object_set_new(fits, BENCH_CASES[medium].name,
                                json_pack("{s:o,s:o}", "seconds", cli_json_number(fit.time),
                                          "peak_bytes", cli_json_number(fit.memory)));
    }
    return fits;
}

void cli_bench_json(const struct cli_bench *bench)
{
    json_t *object = json_object();
    json_object_set_new(object, "murk", json_string(MURK_VERSION));
    json_object_set_new(object, "command", cli_json_text(bench->command_line));
    json_object_set_new(object, "processor", json_string(bench->processor));
    for (int p = 0; CLI_BENCH_PARTS[p]; p++) {
        json_t *rows = json_array();
        for (size_t i = 0; i < bench->count; i++)
            if (bench->row[i].part == (enum cli_bench_part)(1 << p))
                json_array_append_new(rows, row_json(&bench->row[i]));
        json_object_set_new(object, CLI_BENCH_PARTS[p], rows);
    }
    json_object_set_new(object, "exponents", fits_json(bench));
    cli_print_json(object);
}
