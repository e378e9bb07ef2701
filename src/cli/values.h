/* SPDX-License-Identifier: Apache-2.0 */
/* The texts of option values. */
#ifndef CLI_VALUES_H
#define CLI_VALUES_H

#include "options.h"

cli_value_fn cli_value_flag;    /* bool; text is NULL */
cli_value_fn cli_value_text;    /* const char *, not empty */
cli_value_fn cli_value_number;  /* double in [min, max] */
cli_value_fn cli_value_percent; /* double in (0, 1): "1%" or "0.01" */
cli_value_fn cli_value_bytes;   /* double >= 1: "512M" or "2GiB", in powers of 1024 */
cli_value_fn cli_value_count;   /* int in [min, max] */
cli_value_fn cli_value_vector;  /* double[3]: "1,2,3" */
cli_value_fn cli_value_range;   /* double[2], the first below the second: "280:320" */
cli_value_fn cli_value_size;    /* int[2]: "640x480", each in [min, max] */
cli_value_fn cli_value_window;  /* int[3]: "10x10x4" */
cli_value_fn cli_value_list;    /* struct cli_list, each in [min, max]: "1e4,1e5" */
cli_value_fn cli_value_set;     /* unsigned: bits of the choices named: "growth,error" */
cli_value_fn cli_value_choice;  /* int: which of the choices */

#endif
