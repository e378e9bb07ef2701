/* SPDX-License-Identifier: Apache-2.0 */
/* What murk says on standard error: errors, warnings, and a progress bar on a terminal. */
#ifndef CLI_TERMINAL_H
#define CLI_TERMINAL_H

#include "murk/murk.h"

struct cli_terminal {
    bool quiet, verbose;
    bool bar;        /* draw progress: standard error is a terminal, and not quiet */
    bool drawn;      /* a bar is on the line now */
    double drawn_at; /* when [s] */
};

void cli_terminal_init(struct cli_terminal *terminal, bool quiet, bool verbose);

/* "murk: " and one line; errors are printed even when quiet. */
void cli_error(struct cli_terminal *terminal, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void cli_say(struct cli_terminal *terminal, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Takes the bar off the screen. */
void cli_terminal_clear(struct cli_terminal *terminal);

/* For murk_context_options, with the terminal as user. */
murk_log_fn cli_terminal_log;
murk_progress_fn cli_terminal_progress;

/* Seconds of a monotonic clock. */
double cli_seconds(void);

#endif
