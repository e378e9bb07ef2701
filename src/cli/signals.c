/* SPDX-License-Identifier: Apache-2.0 */
#include "signals.h"

#include "murk/murk.h"

#include <signal.h>
#include <unistd.h>

static volatile sig_atomic_t clears_bar;

/* By SA_RESETHAND the default action is back already, also for a second signal of the kind. */
static void end(int signal_number)
{
    static const char clear[] = "\r\033[K";
    murk_outputs_abandon();
    if (clears_bar && write(STDERR_FILENO, clear, sizeof clear - 1) < 0)
        clears_bar = 0;
    raise(signal_number);
}

void cli_signals_catch(bool bar)
{
    static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    struct sigaction action = {.sa_handler = end, .sa_flags = SA_RESETHAND | SA_NODEFER}, before;
    clears_bar = bar;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof ENDING / sizeof *ENDING; i++)
        if (!sigaction(ENDING[i], NULL, &before) && before.sa_handler != SIG_IGN)
            sigaction(ENDING[i], &action, NULL);
    signal(SIGXFSZ, SIG_IGN);
}
