/* SPDX-License-Identifier: Apache-2.0 */
#include "terminal.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { BAR_WIDTH = 32 };
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

void cli_terminal_relay(struct cli_terminal *terminal, const struct cli_terminal *shown,
                        murk_progress_fn *relay, void *user)
{
    terminal->bar = shown->bar;
    terminal->relay = relay;
    terminal->relay_user = user;
}

void cli_terminal_frame(struct cli_terminal *terminal, int frame)
{
    snprintf(terminal->frame, sizeof terminal->frame, "frame %d: ", frame);
    terminal->error[0] = '\0';
}

void cli_terminal_frames_end(struct cli_terminal *terminal)
{
    cli_terminal_clear(terminal);
    terminal->frame[0] = '\0';
}

void cli_terminal_clear(struct cli_terminal *terminal)
{
    if (terminal->drawn)
        fputs("\r\033[K", stderr);
    terminal->drawn = false;
}

/* In one piece, so that the lines of runs side by side do not mix; one line, and no commands to the
   terminal, whatever files and grids are called. */
static void print_line(struct cli_terminal *terminal, const char *text)
{
    char line[CLI_LINE_SIZE];
    snprintf(line, sizeof line, "%s", text);
    for (char *c = line; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            *c = '?';
    cli_terminal_clear(terminal);
    fprintf(stderr, "murk: %s%s\n", terminal->frame, line);
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

/* Whether there is a bar, and it is time for a new one. */
static bool is_due(struct cli_terminal *terminal)
{
    double now = cli_seconds();
    bool told = terminal->drawn || terminal->relay;
    if (!terminal->bar || (told && now - terminal->drawn_at < REDRAW_SECONDS))
        return false;
    terminal->drawn_at = now;
    return true;
}

static void draw(struct cli_terminal *terminal, const char *label, double done, const char *behind)
{
    double part = done < 0.0 ? 0.0 : done > 1.0 ? 1.0 : done;
    int full = (int)(BAR_WIDTH * part);
    fprintf(stderr, "\r\033[K%s [", label);
    for (int i = 0; i < BAR_WIDTH; i++)
        fputc(i < full ? '=' : ' ', stderr);
    fprintf(stderr, "] %3d %%%s", (int)(100 * part), behind);
    fflush(stderr);
    terminal->drawn = true;
}

void cli_terminal_progress(void *user, const char *stage, double done)
{
    struct cli_terminal *terminal = user;
    char label[16];
    if (!is_due(terminal))
        return;
    if (terminal->relay) {
        terminal->relay(terminal->relay_user, stage, done);
        return;
    }
    snprintf(label, sizeof label, "%-8s", stage);
    draw(terminal, label, done, "");
}

void cli_terminal_sequence(struct cli_terminal *terminal, size_t ended, size_t count, double worked,
                           double left, double seconds)
{
    const double enough = 0.1; /* of a frame, to foretell from */
    char label[64], behind[64] = "";
    if (!is_due(terminal))
        return;
    double to_go = worked > enough ? seconds * left / worked : 0.0;
    if (to_go > 5400)
        snprintf(behind, sizeof behind, ", %.1f h to go", to_go / 3600);
    else if (to_go > 90)
        snprintf(behind, sizeof behind, ", %.0f min to go", to_go / 60);
    else if (worked > enough)
        snprintf(behind, sizeof behind, ", %.0f s to go", ceil(to_go));
    snprintf(label, sizeof label, "%zu of %zu frames", ended, count);
    draw(terminal, label, worked / (worked + left), behind);
}
