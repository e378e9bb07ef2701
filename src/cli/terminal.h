/* SPDX-License-Identifier: Apache-2.0 */
/* What murk says on standard error: errors, warnings, and a progress bar on a terminal. */
#ifndef CLI_TERMINAL_H
#define CLI_TERMINAL_H

#include "murk/murk.h"

enum { CLI_LINE_SIZE = 2048 };

struct cli_terminal {
    bool quiet, verbose;
    bool bar;                /* draw progress: standard error is a terminal, and not quiet */
    bool drawn;              /* a bar is on the line now */
    double drawn_at;         /* when [s] */
    char frame[24];          /* "frame 12: ", before every message; empty outside of a sequence */
    murk_progress_fn *relay; /* takes progress instead of the bar; or NULL */
    void *relay_user;
    char error[CLI_LINE_SIZE]; /* the first error since cli_terminal_frame() */
};

void cli_terminal_init(struct cli_terminal *terminal, bool quiet, bool verbose);

/* "murk: " and one line; errors are printed even when quiet. */
void cli_error(struct cli_terminal *terminal, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void cli_say(struct cli_terminal *terminal, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Says that what follows is about a frame. */
void cli_terminal_frame(struct cli_terminal *terminal, int frame);
/* Says that it is about the sequence again. */
void cli_terminal_frames_end(struct cli_terminal *terminal);

/* Hands progress on to relay, as often as `shown`, the terminal that has a bar, is drawn. */
void cli_terminal_relay(struct cli_terminal *terminal, const struct cli_terminal *shown,
                        murk_progress_fn *relay, void *user);

/* Draws the bar of a sequence of `count` frames, of which some have ended; of the frames to work
   on, as many are worked and left (parts counted), after some seconds. */
void cli_terminal_sequence(struct cli_terminal *terminal, size_t ended, size_t count, double worked,
                           double left, double seconds);

/* Takes the bar off the screen. */
void cli_terminal_clear(struct cli_terminal *terminal);

/* For murk_context_options, with the terminal as user. */
murk_log_fn cli_terminal_log;
murk_progress_fn cli_terminal_progress;

/* Seconds of a monotonic clock. */
double cli_seconds(void);

#endif
