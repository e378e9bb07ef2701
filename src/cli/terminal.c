/* SPDX-License-Identifier: Apache-2.0 */
#include "terminal.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { BAR_WIDTH = 40, BAR_WIDTH_MIN = 8 };
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

void cli_terminal_frame(struct cli_terminal *terminal, int frame, size_t position, size_t count)
{
    snprintf(terminal->frame, sizeof terminal->frame, "frame %d: ", frame);
    snprintf(terminal->position, sizeof terminal->position, "frame %d (%zu of %zu) ", frame,
             position, count);
    terminal->error[0] = '\0';
}

void cli_terminal_frames_end(struct cli_terminal *terminal)
{
    cli_terminal_clear(terminal);
    terminal->frame[0] = terminal->position[0] = '\0';
}

void cli_terminal_clear(struct cli_terminal *terminal)
{
    if (terminal->drawn)
        fputs("\r\033[K", stderr);
    terminal->drawn = false;
}

/* In one piece, so that the lines of runs side by side do not mix. */
static void print_line(struct cli_terminal *terminal, const char *text)
{
    cli_terminal_clear(terminal);
    fprintf(stderr, "murk: %s%s\n", terminal->frame, text);
}

void cli_error(struct cli_terminal *terminal, const char *format, ...)
{
    char text[CLI_LINE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    print_line(terminal, text);
    if (!terminal->error[0])
        strcpy(terminal->error, text);
}

void cli_say(struct cli_terminal *terminal, const char *format, ...)
{
    char text[CLI_LINE_SIZE];
    va_list arguments;
    if (terminal->quiet)
        return;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    print_line(terminal, text);
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
    int width = BAR_WIDTH - (int)strlen(terminal->position); /* one line of 80 columns */
    width = width < BAR_WIDTH_MIN ? BAR_WIDTH_MIN : width;
    double part = done < 0.0 ? 0.0 : done > 1.0 ? 1.0 : done;
    int full = (int)(width * part);
    fprintf(stderr, "\r\033[K%s%-8s [", terminal->position, stage);
    for (int i = 0; i < width; i++)
        fputc(i < full ? '=' : ' ', stderr);
    fprintf(stderr, "] %3d %%", (int)(100 * part));
    fflush(stderr);
    terminal->drawn = true;
    terminal->drawn_at = now;
}
