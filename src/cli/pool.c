/* SPDX-License-Identifier: Apache-2.0 */
#include "pool.h"

#include "report.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    ENDS = 3,      /* of a worker: control, output, messages */
    POLL_MS = 1000 /* a worker whose ends somebody else holds open is found dead by then */
};

struct text {
    char *bytes;
    size_t size;
};

/* A worker and the frame it is on. */
struct hand {
    struct cli_worker worker; /* pid 0: none */
    bool busy;
    size_t index;
    double done; /* of the frame, in [0, 1] */
    struct text output, messages;
};

/* A frame that has ended, until those before it have. */
struct ended {
    bool ended;
    struct cli_frame_result *result; /* from malloc, as is text */
    char *text;                      /* that it printed; NULL: nothing */
    size_t size;
    int signal; /* that killed its process, or 0 */
};

struct pool {
    const struct cli_crew *crew;
    struct cli_job *job;
    struct cli_tally *tally;
    struct hand *hand;
    size_t hands;
    struct ended *frame;
    size_t next, told; /* frames given out, and told */
    size_t ended, skipped;
    double started;
    murk_status status;
};

static void run_out_of_memory(struct pool *pool)
{
    if (pool->status == MURK_OK)
        cli_error(&pool->job->terminal, "out of memory");
    pool->status = MURK_ERROR_MEMORY;
}

/* ---- what workers print -------------------------------------------------------------------- */

/* Takes what there is to read of a pipe. */
static void take_text(struct pool *pool, int pipe, struct text *text)
{
    enum { PIECE = 4096 };
    for (;;) {
        char *larger = realloc(text->bytes, text->size + PIECE);
        if (!larger) {
            run_out_of_memory(pool);
            return;
        }
        text->bytes = larger;
        ssize_t size = read(pipe, larger + text->size, PIECE);
        if (size <= 0 && !(size < 0 && errno == EINTR))
            return;
        text->size += size > 0 ? (size_t)size : 0;
    }
}

/* Passes on whole lines of messages, or all of them. */
static void pass_messages(struct pool *pool, struct text *text, bool all)
{
    size_t size = text->size;
    while (!all && size > 0 && text->bytes[size - 1] != '\n')
        size--;
    if (size == 0)
        return;
    cli_terminal_clear(&pool->job->terminal);
    fwrite(text->bytes, 1, size, stderr);
    if (text->bytes[size - 1] != '\n')
        fputc('\n', stderr);
    memmove(text->bytes, text->bytes + size, text->size - size);
    text->size -= size;
}

/* ---- in the order of frames ---------------------------------------------------------------- */

static void tell(struct pool *pool, size_t index)
{
    struct ended *ended = &pool->frame[index];
    int frame = pool->crew->frames->number[index];
    cli_terminal_clear(&pool->job->terminal);
    fwrite(ended->text, 1, ended->size, stdout);
    if (ended->signal && pool->job->options->json) {
        char text[CLI_LINE_SIZE];
        snprintf(text, sizeof text, "its process was killed by signal %d (%s)", ended->signal,
                 strsignal(ended->signal));
        cli_report_frame(frame, "failed", text);
    }
    fflush(stdout); /* for whoever follows the sequence; main() tells about errors */
    cli_tally_add(pool->tally, pool->job, frame, ended->result);
    free(ended->text);
    free(ended->result);
    ended->text = NULL;
    ended->result = NULL;
}

static void end_frame(struct pool *pool, struct hand *hand, const struct cli_frame_result *result,
                      int signal)
{
    struct ended *ended = &pool->frame[hand->index];
    ended->result = malloc(sizeof *ended->result);
    if (!ended->result) {
        run_out_of_memory(pool);
        return;
    }
    *ended->result = *result;
    ended->ended = true;
    ended->signal = signal;
    ended->text = hand->output.bytes;
    ended->size = hand->output.size;
    hand->output = (struct text){0};
    hand->busy = false;
    hand->done = 0;
    pool->ended++;
    pool->skipped += result->skipped;
    while (pool->told < pool->next && pool->frame[pool->told].ended)
        tell(pool, pool->told++);
}

/* ---- the workers --------------------------------------------------------------------------- */

static void give(struct pool *pool, struct hand *hand)
{
    if (!hand->worker.pid || hand->busy || pool->next == pool->crew->frames->count)
        return;
    hand->busy = true;
    hand->index = pool->next++;
    cli_worker_give(&hand->worker, hand->index);
}

static bool hire(struct pool *pool, struct hand *hand)
{
    int *ends = malloc(ENDS * pool->hands * sizeof *ends);
    size_t count = 0;
    for (size_t i = 0; ends && i < pool->hands; i++) {
        const struct cli_worker *worker = &pool->hand[i].worker;
        if (!worker->pid)
            continue;
        ends[count++] = worker->control;
        ends[count++] = worker->output;
        ends[count++] = worker->messages;
    }
    bool started = ends && cli_worker_start(pool->crew, ends, count, &hand->worker);
    free(ends);
    return started;
}

static void dismiss(struct hand *hand)
{
    close(hand->worker.control);
    close(hand->worker.output);
    close(hand->worker.messages);
    hand->worker = (struct cli_worker){0};
    free(hand->output.bytes);
    free(hand->messages.bytes);
    hand->output = hand->messages = (struct text){0};
}

static void say_killed(struct pool *pool, const struct hand *hand, int signal)
{
    struct cli_terminal *terminal = &pool->job->terminal;
    cli_terminal_frame(terminal, pool->crew->frames->number[hand->index]);
    cli_error(terminal, "its process was killed by signal %d (%s)%s", signal, strsignal(signal),
              signal == SIGKILL ? "; if memory ran out, fewer --jobs need less" : "");
    cli_terminal_frames_end(terminal);
}

/* Sees to a worker that has ended. */
static void bury(struct pool *pool, struct hand *hand, int how)
{
    const struct cli_frame_result failed = {.status = MURK_ERROR_INTERNAL};
    take_text(pool, hand->worker.output, &hand->output);
    take_text(pool, hand->worker.messages, &hand->messages);
    pass_messages(pool, &hand->messages, true);
    if (hand->busy) {
        int signal = WIFSIGNALED(how) ? WTERMSIG(how) : SIGTERM;
        say_killed(pool, hand, signal);
        end_frame(pool, hand, &failed, signal);
    }
    dismiss(hand);
}

static void take_note(struct pool *pool, struct hand *hand, const struct cli_worker_note *note)
{
    if (!note->finished) { /* pictures come second, and stand for half of the frame */
        hand->done = 0.5 * note->done + (strcmp(note->stage, "render") ? 0.0 : 0.5);
        return;
    }
    take_text(pool, hand->worker.output, &hand->output);
    take_text(pool, hand->worker.messages, &hand->messages);
    pass_messages(pool, &hand->messages, true);
    end_frame(pool, hand, &note->result, 0);
}

/* Takes the notes that have come; false when the worker has closed its end. */
static bool take_notes(struct pool *pool, struct hand *hand)
{
    struct cli_worker_note note;
    ssize_t size;
    while ((size = recv(hand->worker.control, &note, sizeof note, MSG_DONTWAIT)) ==
           (ssize_t)sizeof note)
        take_note(pool, hand, &note);
    return size < 0 && (errno == EAGAIN || errno == EINTR);
}

static void attend(struct pool *pool, struct hand *hand)
{
    int how = 0;
    take_text(pool, hand->worker.output, &hand->output);
    take_text(pool, hand->worker.messages, &hand->messages);
    pass_messages(pool, &hand->messages, false);
    bool open = take_notes(pool, hand);
    if (waitpid(hand->worker.pid, &how, open ? WNOHANG : 0) != 0)
        bury(pool, hand, how);
}

static void wait_for_workers(struct pool *pool, struct pollfd *ends)
{
    size_t count = 0;
    for (size_t i = 0; i < pool->hands; i++) {
        const struct cli_worker *worker = &pool->hand[i].worker;
        if (!worker->pid)
            continue;
        ends[count++] = (struct pollfd){.fd = worker->control, .events = POLLIN};
        ends[count++] = (struct pollfd){.fd = worker->output, .events = POLLIN};
        ends[count++] = (struct pollfd){.fd = worker->messages, .events = POLLIN};
    }
    poll(ends, count, POLL_MS);
}

static void show_progress(struct pool *pool)
{
    double worked = (double)(pool->ended - pool->skipped), left;
    for (size_t i = 0; i < pool->hands; i++)
        worked += pool->hand[i].busy ? pool->hand[i].done : 0.0;
    left = (double)(pool->crew->frames->count - pool->skipped) - worked;
    cli_terminal_sequence(&pool->job->terminal, pool->ended, pool->crew->frames->count, worked,
                          left, cli_seconds() - pool->started);
}

/* Has a worker on every frame that can have one; how many are at work. */
static size_t staff(struct pool *pool)
{
    size_t busy = 0;
    for (size_t i = 0; i < pool->hands; i++) {
        struct hand *hand = &pool->hand[i];
        bool wanted = pool->status == MURK_OK && pool->next < pool->crew->frames->count;
        if (wanted && (hand->worker.pid || hire(pool, hand)))
            give(pool, hand);
        busy += hand->busy;
    }
    return busy;
}

static void run(struct pool *pool, struct pollfd *ends)
{
    while (staff(pool) > 0) {
        show_progress(pool);
        wait_for_workers(pool, ends);
        for (size_t i = 0; i < pool->hands; i++)
            if (pool->hand[i].worker.pid)
                attend(pool, &pool->hand[i]);
    }
    if (pool->status == MURK_OK && pool->next < pool->crew->frames->count) {
        cli_error(&pool->job->terminal, "cannot start a process for frame %d: %s",
                  pool->crew->frames->number[pool->next], strerror(errno));
        pool->status = MURK_ERROR_INTERNAL;
    }
}

static void close_pool(struct pool *pool)
{
    for (size_t i = 0; i < pool->hands; i++) {
        pid_t pid = pool->hand[i].worker.pid;
        if (!pid)
            continue;
        dismiss(&pool->hand[i]);
        waitpid(pid, NULL, 0);
    }
    for (size_t i = pool->told; pool->frame && i < pool->next; i++) {
        free(pool->frame[i].text);
        free(pool->frame[i].result);
    }
}

murk_status cli_pool_run(const struct cli_crew *crew, size_t count, struct cli_job *job,
                         struct cli_tally *tally)
{
    struct pool pool = {.crew = crew,
                        .job = job,
                        .tally = tally,
                        .hand = calloc(count, sizeof *pool.hand),
                        .hands = count,
                        .frame = calloc(crew->frames->count, sizeof *pool.frame),
                        .started = cli_seconds()};
    struct pollfd *ends = malloc(ENDS * count * sizeof *ends);
    if (pool.hand && pool.frame && ends)
        run(&pool, ends);
    else
        run_out_of_memory(&pool);
    if (pool.hand)
        close_pool(&pool);
    cli_terminal_clear(&job->terminal);
    free(pool.hand);
    free(pool.frame);
    free(ends);
    return pool.status;
}
