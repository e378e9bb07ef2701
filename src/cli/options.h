/* SPDX-License-Identifier: Apache-2.0 */
/* The options of all commands: one table drives parsing, help, errors, the manual pages and the
   completion of the shell. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "murk/murk.h"

/* Commands, as bits. */
enum cli_command {
    CLI_IMAGE = 1,
    CLI_SOLVE = 2,
    CLI_RENDER = 4,
    CLI_INFO = 8,
    CLI_BENCH = 16,
    CLI_CONTRAST = 32,
    CLI_BAKE = 64,
    /* Those that read a volume, and those that take an INPUT. */
    CLI_VOLUME = CLI_IMAGE | CLI_SOLVE | CLI_RENDER | CLI_INFO | CLI_BAKE,
    CLI_INPUT = CLI_VOLUME | CLI_CONTRAST,
    CLI_ALL = CLI_INPUT | CLI_BENCH
};

/* What murk contrast draws its curves against. */
enum cli_against {
    CLI_AGAINST_FRAME,
    CLI_AGAINST_TRANSMITTANCE,
    CLI_AGAINST_DEPTH,
    CLI_AGAINST_CL
};

/* What murk bench measures, as bits. */
enum cli_bench_part {
    CLI_BENCH_GROWTH = 1,
    CLI_BENCH_EMPTINESS = 2,
    CLI_BENCH_THREADS = 4,
    CLI_BENCH_ERROR = 8,
    CLI_BENCH_PAPER = 16
};

enum { CLI_LIST_MOST = 16 };

/* Numbers in ascending order. */
struct cli_list {
    int count;
    double value[CLI_LIST_MOST];
};

/* Numbers that are not given are NaN, sizes 0, texts NULL, choices -1. */
struct cli_options {
    const char *input;
    const char *output, *preview, *deep, *ground_radiosity;
    const char *usd;
    const char *radiosity; /* image, bake: written; render: read */
    int flipbook[2];       /* cells across and down */
    bool straight;

    const char *frames;
    bool resume;
    int jobs;

    const char *grid, *albedo, *bands, *obscurant;
    double scale, concentration, voxel_size;
    int voxels, up;
    bool strict;

    murk_solve_options solve;
    int method, solver;

    double eye[3], target[3], fov;
    int size[2], samples;
    bool no_background;
    double exposure;
    const char *show; /* a channel */
    double range[2];

    bool half, emission_coefficient, extinction_grid, albedo_grid;

    unsigned parts, cases; /* bits; 0: not given */
    struct cli_list sizes, packets;
    int runs;
    bool time_render;
    const char *volume, *curves;

    const char *target_region, *background_region; /* X,Y,WxH or the path of a mask */
    const char *plot;
    double netd, snr;
    int against; /* one of enum cli_against */

    int threads, kernel;
    double max_memory; /* bytes */
    bool json, quiet, verbose, help;
};

struct cli_option;
/* Puts the text of a value into field; false where it is no such value. */
typedef bool cli_value_fn(const char *text, void *field, const struct cli_option *option);

struct cli_option {
    const char *name;     /* "tolerance" */
    char letter;          /* of the short form, or 0 */
    unsigned commands;    /* that have it */
    const char *section;  /* of the help text */
    const char *argument; /* NULL: a flag */
    const char *help;
    cli_value_fn *value;
    size_t offset; /* in struct cli_options */
    double min, max;
    const char *const *choices; /* NULL-terminated */
    const char *files;          /* of a FILE: its usual extensions, "exr png"; NULL: any */
    const char *expected;       /* for messages: "a number > 0" */
    bool aside;                 /* outputs are the same with it and without */
};

/* The table; *count rows in the order of the help text. */
const struct cli_option *cli_option_table(size_t *count);

/* The choices of the options named after them. */
extern const char *const CLI_KERNELS[], *const CLI_BENCH_PARTS[], *const CLI_AGAINST[];

/* The option of any command that an argument such as "-o", "-ofile" or "--scale=2" names, and the
   length of its name there; NULL: none. */
const struct cli_option *cli_option_named(const char *argument, size_t *length);

/* Reads the arguments after the command's name. False with the one line in message (of size
   bytes) where they are wrong. */
bool cli_options_parse(enum cli_command command, const char *command_name, int count,
                       char *const *arguments, struct cli_options *out, char *message, size_t size);

#endif
