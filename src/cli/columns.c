/* SPDX-License-Identifier: Apache-2.0 */
#include "columns.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool grow(struct cli_columns *columns)
{
    size_t capacity = columns->capacity ? 2 * columns->capacity : 64;
    char(*cell)[CLI_CELL_SIZE] = realloc(columns->cell, capacity * sizeof *cell);
    if (!cell)
        return false;
    columns->cell = cell;
    columns->capacity = capacity;
    return true;
}

void cli_columns_add(struct cli_columns *columns, const char *format, ...)
{
    va_list arguments;
    if (columns->count == columns->capacity && !grow(columns)) {
        columns->failed = true;
        return;
    }
    va_start(arguments, format);
    vsnprintf(columns->cell[columns->count++], CLI_CELL_SIZE, format, arguments);
    va_end(arguments);
}

void cli_columns_number(struct cli_columns *columns, int digits, double number)
{
    if (isnan(number))
        cli_columns_add(columns, "-");
    else if (fabs(number) >= pow(10, digits) && fabs(number) < 1e9)
        cli_columns_add(columns, "%.0f", number); /* whole rather than 1.2e+05 */
    else
        cli_columns_add(columns, "%.*g", digits, number);
}

void cli_columns_seconds(struct cli_columns *columns, double seconds)
{
    if (isnan(seconds))
        cli_columns_add(columns, "-");
    else
        cli_columns_add(columns, "%.*f", seconds < 10 ? 3 : seconds < 100 ? 2 : 1, seconds);
}

static void print_cell(const char *text, bool left, int width, bool last)
{
    if (!left)
        printf("%*s", width, text);
    else if (last)
        fputs(text, stdout);
    else
        printf("%-*s", width, text);
}

murk_status cli_columns_print(struct cli_columns *columns)
{
    murk_status status = columns->failed ? MURK_ERROR_MEMORY : MURK_OK;
    int *width = calloc((size_t)columns->columns, sizeof *width);
    if (!width)
        status = MURK_ERROR_MEMORY;
    for (size_t i = 0; !status && i < columns->count; i++) {
        int *most = &width[i % (size_t)columns->columns], length = (int)strlen(columns->cell[i]);
        *most = length > *most ? length : *most;
    }
    for (size_t i = 0; !status && i < columns->count; i++) {
        int c = (int)(i % (size_t)columns->columns);
        bool last = c + 1 == columns->columns;
        if (*columns->cell[i] || !last) {
            printf("%*s", c == 0 ? 0 : columns->gap, "");
            print_cell(columns->cell[i], columns->left >> c & 1, width[c], last);
        }
        if (last)
            putchar('\n');
    }
    free(width);
    free(columns->cell);
    columns->cell = NULL;
    columns->count = columns->capacity = 0;
    return status;
}
