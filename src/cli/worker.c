/* SPDX-License-Identifier: Apache-2.0 */
#include "worker.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

/* ---- in the worker ------------------------------------------------------------------------- */

static void tell_progress(void *user, const char *stage, double done)
{
    struct cli_worker_note note = {.done = done};
    snprintf(note.stage, sizeof note.stage, "%s", stage);
    send(*(const int *)user, &note, sizeof note, MSG_NOSIGNAL);
}

static void run_frames(const struct cli_crew *crew, int control)
{
    struct cli_options options = *crew->job->options;
    struct cli_job job;
    size_t index;
    options.threads = crew->threads;
    options.max_memory /= crew->jobs; /* each its share; NaN, what is not given, stays so */
    murk_status status = cli_job_start(&job, &options, crew->job->command, crew->job->command_line);
    cli_terminal_relay(&job.terminal, &crew->job->terminal, tell_progress, &control);
    while (recv(control, &index, sizeof index, 0) == (ssize_t)sizeof index) {
        const int *frame = &crew->frames->number[index];
        struct cli_worker_note note = {.finished = true, .result.status = status};
        cli_terminal_frame(&job.terminal, *frame);
        if (status == MURK_OK)
            cli_frame_run(&job, frame, crew->steps, &note.result);
        fflush(stdout); /* before the note, so that what the frame printed is there by then */
        send(control, &note, sizeof note, MSG_NOSIGNAL);
    }
}

/* ---- from process to process --------------------------------------------------------------- */

struct channels {
    int control[2], output[2], messages[2]; /* [0] is the starting process's end */
};

static void close_end(const struct channels *channels, int end)
{
    close(channels->control[end]);
    close(channels->output[end]);
    close(channels->messages[end]);
}

static bool open_channels(struct channels *out)
{
    if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, out->control))
        return false;
    if (!pipe(out->output)) {
        if (!pipe(out->messages)) {
            fcntl(out->output[0], F_SETFL, O_NONBLOCK);
            fcntl(out->messages[0], F_SETFL, O_NONBLOCK);
            return true;
        }
        close(out->output[0]);
        close(out->output[1]);
    }
    close(out->control[0]);
    close(out->control[1]);
    return false;
}

static _Noreturn void be_worker(const struct cli_crew *crew, const struct channels *channels,
                                pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
        _exit(EXIT_FAILURE);
    dup2(channels->output[1], STDOUT_FILENO);
    dup2(channels->messages[1], STDERR_FILENO);
    close(channels->output[1]);
    close(channels->messages[1]);
    run_frames(crew, channels->control[1]);
    _exit(EXIT_SUCCESS); /* what the starting process has to clean up is not for its copy */
}

bool cli_worker_start(const struct cli_crew *crew, const struct pollfd *ends, size_t end_count,
                      struct cli_worker *out)
{
    struct channels channels;
    pid_t parent = getpid();
    if (!open_channels(&channels))
        return false;
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        for (size_t i = 0; i < end_count; i++)
            close(ends[i].fd);
        close_end(&channels, 0);
        be_worker(crew, &channels, parent);
    }
    close_end(&channels, 1);
    if (pid < 0) {
        close_end(&channels, 0);
        return false;
    }
    *out = (struct cli_worker){pid, channels.control[0], channels.output[0], channels.messages[0]};
    return true;
}

void cli_worker_give(const struct cli_worker *worker, size_t index)
{
    send(worker->control, &index, sizeof index, MSG_NOSIGNAL);
}
