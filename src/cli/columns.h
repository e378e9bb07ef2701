/* SPDX-License-Identifier: Apache-2.0 */
/* Text in columns on standard output. */
#ifndef CLI_COLUMNS_H
#define CLI_COLUMNS_H

#include "murk/murk.h"

enum { CLI_CELL_SIZE = 96 };

/* Zeroed but for these three before use. */
struct cli_columns {
    int columns;
    int gap;       /* spaces between two columns */
    unsigned left; /* bits: columns of text; the others are numbers and end at the same place */
    size_t count, capacity;
    char (*cell)[CLI_CELL_SIZE]; /* row by row */
    bool failed;
};

/* Adds the next cell, cut to its size. */
void cli_columns_add(struct cli_columns *columns, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a number with so many significant digits, "-" for NaN. */
void cli_columns_number(struct cli_columns *columns, int digits, double number);

/* Adds seconds to the millisecond, or less where they are many; "-" for NaN. */
void cli_columns_seconds(struct cli_columns *columns, double seconds);

/* Prints the rows and releases them. Fails where memory ran out. */
murk_status cli_columns_print(struct cli_columns *columns);

#endif
