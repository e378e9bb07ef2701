/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include "cases.h"
#include "job.h"
#include "volume.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The media that are at hand; made again only where a row wants others than the row before. */
struct media {
    int medium;
    double size;
    struct bench_voxels voxels, wide;
    float *truth; /* radiosities of the voxels, or NULL */
};

const char *cli_bench_method(const struct cli_bench_row *row)
{
    if (row->packets > 0)
        return "Monte Carlo";
    if (row->solve.method == MURK_LINES)
        return "lines";
    return row->solve.window[0] > 0 ? "pairwise, window" : "pairwise";
}

static void drop_media(struct media *media)
{
    bench_reference_release(media->truth, &media->voxels);
    bench_voxels_release(&media->voxels);
    bench_voxels_release(&media->wide);
    *media = (struct media){.medium = -1};
}

static bool make_media(struct cli_bench *bench, const struct cli_bench_row *row,
                       struct media *media)
{
    bench_make_fn *make = row->medium == BENCH_VOLUME ? NULL : BENCH_CASES[row->medium].make;
    if (media->medium != row->medium || media->size != row->size) {
        drop_media(media);
        media->medium = row->medium;
        media->size = row->size;
        if (!make) {
            media->voxels = bench->volume;
            bench->volume = (struct bench_voxels){0};
        } else if (!make(row->size, &media->voxels)) {
            return false;
        }
    }
    if (row->wide && media->wide.count == 0 &&
        (!make(row->size, &media->wide) || !bench_voxels_widen(&media->wide)))
        return false;
    if (row->truth && !media->truth)
        media->truth = bench_reference_create(&media->voxels);
    return media->truth || !row->truth;
}

static murk_status measure_row(struct cli_bench *bench, struct cli_bench_row *row,
                               struct media *media)
{
    if (!make_media(bench, row, media)) {
        cli_error(&bench->terminal, "%s of %g voxels: %s", row->name, row->size,
                  murk_status_text(MURK_ERROR_MEMORY));
        return MURK_ERROR_MEMORY;
    }
    const struct bench_run run = {
        .voxels = row->wide ? &media->wide : &media->voxels,
        .frame = &media->voxels,
        .scene = row->scene,
        .solve = row->solve,
        .packets = row->packets,
        .threads = row->threads,
        .kernel = bench->options->kernel >= 0 ? CLI_KERNELS[bench->options->kernel] : NULL,
        .render = bench->options->time_render && row->part == CLI_BENCH_GROWTH,
        .reference = row->part == CLI_BENCH_ERROR ? media->truth : NULL,
        .refer = row->truth,
    };
    murk_status status = bench_run(&run, row->times, &row->outcome);
    if (status)
        cli_error(&bench->terminal, "%s of %g voxels: %s", row->name, row->size,
                  row->outcome.message);
    return status;
}

/* Whether the row was free to reach its tolerance and did not. */
static bool missed(const struct cli_bench_row *row)
{
    return !row->outcome.median.reached && row->part != CLI_BENCH_PAPER && !row->truth;
}

static void say_missed(struct cli_bench *bench, const struct cli_bench_row *row)
{
    cli_error(&bench->terminal,
              "%s of %g voxels, %s: the tolerance of %.3g %% was not reached: the estimated error "
              "is %.3g %%",
              row->name, row->size, cli_bench_method(row), 100 * row->solve.tolerance,
              100 * row->outcome.median.estimate);
}

/* How long a row takes, roughly, next to others: for the progress bar alone. */
static double effort(const struct cli_bench_row *row)
{
    return row->size * row->times * (row->truth ? 20 : 1) *
           (row->medium == BENCH_FILAMENTS ? 10 : 1);
}

/* Measures the rows and prints each part when it is complete. */
static murk_status measure(struct cli_bench *bench)
{
    struct media media = {.medium = -1};
    murk_status status = MURK_OK;
    double done = 0, all = 0;
    bool short_of = false;
    for (size_t i = 0; i < bench->count; i++)
        all += effort(&bench->row[i]);
    for (size_t i = 0; i < bench->count && !status; i++) {
        struct cli_bench_row *row = &bench->row[i];
        cli_terminal_progress(&bench->terminal, "bench", done / all);
        status = measure_row(bench, row, &media);
        done += effort(row);
        if (status)
            break;
        if (missed(row)) {
            say_missed(bench, row);
            short_of = true;
        }
        bool last = i + 1 == bench->count || bench->row[i + 1].part != row->part;
        if (last && !bench->options->json) {
            cli_terminal_clear(&bench->terminal);
            cli_bench_table(bench, row->part);
        }
    }
    cli_terminal_clear(&bench->terminal);
    drop_media(&media);
    return !status && short_of ? MURK_NOT_REACHED : status;
}

/* The processor's name where the system tells it. */
static void find_processor(char out[128])
{
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "r");
    strcpy(out, "unknown processor");
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "model name : %127[^\n]", out) == 1)
            break;
    if (file)
        fclose(file);
}

static void print_heading(const struct cli_bench *bench)
{
    printf("murk %s on %s, %ld processors; ", MURK_VERSION, bench->processor,
           sysconf(_SC_NPROCESSORS_ONLN));
    if (bench->options->runs > 1)
        printf("medians of %d runs\n\n", bench->options->runs);
    else
        printf("single runs\n\n");
}

/* Reads what --volume names. */
static murk_status read_volume(struct cli_bench *bench)
{
    const char *path = bench->options->volume;
    if (!path)
        return MURK_OK;
    murk_status status = bench_volume_read(bench->context, path, &bench->volume);
    bench->volume_zones = bench_voxels_active(&bench->volume);
    if (status) {
        cli_error(&bench->terminal, "%s", murk_context_message(bench->context));
    } else if (bench->volume_zones == 0) {
        cli_error(&bench->terminal, "%s: no voxel has an extinction; there is nothing to measure",
                  path);
        status = MURK_ERROR_INPUT;
    }
    const char *file = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    snprintf(bench->volume_name, sizeof bench->volume_name, "%.*s", (int)strcspn(file, "."), file);
    return status;
}

/* Reads what --curves names, before anything is measured. */
static murk_status read_curves(struct cli_bench *bench)
{
    const char *path = bench->options->curves;
    if (!path)
        return MURK_OK;
    bench->curves = calloc(1, sizeof *bench->curves);
    return bench->curves ? cli_panels_read(bench->curves, path, &bench->terminal)
                         : MURK_ERROR_MEMORY;
}

static murk_status check_output(struct cli_bench *bench)
{
    const char *path = bench->options->output;
    if (!path)
        return MURK_OK;
    if (!strcmp(path, "-") || cli_has_extension(path, ".vdb")) {
        cli_error(&bench->terminal, "-o %s: the plot is an image; name a .png file", path);
        return MURK_ERROR_INPUT;
    }
    murk_status status = murk_output_check(bench->context, path);
    if (status)
        cli_error(&bench->terminal, "%s", murk_context_message(bench->context));
    return status;
}

static murk_status write_plot(struct cli_bench *bench)
{
    murk_status status = cli_bench_plot(bench, bench->options->output);
    if (status)
        cli_error(&bench->terminal, "%s", murk_context_message(bench->context));
    else
        cli_say(&bench->terminal, "plot in %s", bench->options->output);
    return status;
}

int cli_bench(const struct cli_options *options, const char *command_line)
{
    struct cli_bench bench = {.options = options, .command_line = command_line};
    cli_terminal_init(&bench.terminal, options->quiet, options->verbose);
    murk_context_options context = MURK_CONTEXT_DEFAULT;
    context.log = cli_terminal_log;
    context.user = &bench.terminal;
    context.threads = 1; /* runs are forked, and threads do not come along */
    murk_status status = murk_context_create(&context, &bench.context);
    if (!status)
        status = check_output(&bench);
    if (!status)
        status = read_volume(&bench);
    if (!status)
        status = read_curves(&bench);
    if (!status && (status = cli_bench_plan(&bench)))
        cli_error(&bench.terminal, "%s", murk_status_text(status));
    find_processor(bench.processor);
    if (!status && !options->json)
        print_heading(&bench);
    if (!status)
        status = measure(&bench);
    if (!cli_job_failed(status) && options->json)
        cli_bench_json(&bench);
    if (!cli_job_failed(status) && options->output) {
        murk_status written = write_plot(&bench);
        status = written ? written : status;
    }
    bench_voxels_release(&bench.volume);
    free(bench.curves);
    free(bench.row);
    murk_context_release(bench.context);
    return cli_exit_status(status);
}
