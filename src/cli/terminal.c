/* SPDX-License-Identifier: Apache-2.0 */
#include "terminal.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { BAR_WIDTH = 40 };
static const double REDRAW_SECONDS = 0.1;

double cli_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void cli_terminal_init(struct cli_terminal *terminal, bool quiet, bool verbose)
{
    *terminal = (struct cli_terminal){
        .quiet = quiet, .verbose = verbose, .bar = !quiet && isatty(STDERR_FILENO)};
}

void cli_terminal_clear(struct cli_terminal *terminal)
{
    if (terminal->drawn)
        fputs("\r\033[K", stderr);
    terminal->drawn = false;
}

/* In one piece, so that the lines of runs side by side do not mix. */
static void print_line(struct cli_terminal *terminal, const char *format, va_list arguments)
{
    char text[2048];
    vsnprintf(text, sizeof text, format, arguments);
    cli_terminal_clear(terminal);
    fprintf(stderr, "murk: %s\n", text);
}

void cli_error(struct cli_terminal *terminal, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_line(terminal, format, arguments);
    va_end(arguments);
}

void cli_say(struct cli_terminal *terminal, const char *format, ...)
{
    va_list arguments;
    if (terminal->quiet)
        return;
    va_start(arguments, format);
    print_line(terminal, format, arguments);
    va_end(arguments);
}

void cli_terminal_log(void *user, murk_log_level level, const char *text)
{
    struct cli_terminal *terminal = user;
    if (level == MURK_LOG_WARNING)
        cli_say(terminal, "warning: %s", text);
    else if (terminal->verbose)
        cli_say(terminal, "%s", text);
}

void cli_terminal_progress(void *user, const char *stage, double done)
{
    struct cli_terminal *terminal = user;
    double now = cli_seconds();
    if (!terminal->bar || (terminal->drawn && now - terminal->drawn_at < REDRAW_SECONDS))
        return;
    int full = (int)(BAR_WIDTH * (done < 0.0 ? 0.0 : done > 1.0 ? 1.0 : done));
    fprintf(stderr, "\r\033[K%-8s [", stage);
    for (int i = 0; i < BAR_WIDTH; i++)
        fputc(i < full ? '=' : ' ', stderr);
    fprintf(stderr, "] %3d %%", full * 100 / BAR_WIDTH);
    fflush(stderr);
    terminal->drawn = true;
    terminal->drawn_at = now;
}
