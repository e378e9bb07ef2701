/* SPDX-License-Identifier: Apache-2.0 */
#include "pool.h"

#include "ordered.h"

#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    ENDS = 3,      /* of a worker: control, output, messages */
    POLL_MS = 1000 /* a worker whose ends somebody else holds open is found dead by then */
};

/* A worker and the frame it is on. */
struct hand {
    struct cli_worker worker; /* pid 0: none */
    bool busy;
    size_t index;
    double done; /* of the frame, in [0, 1] */
    struct cli_text output, messages;
};

struct pool {
    const struct cli_crew *crew;
    struct cli_job *job;
    struct hand *hand;
    size_t hands;
    size_t next; /* to be given out */
    struct cli_ordered ordered;
    double started;
    murk_status status;
};

static void run_out_of_memory(struct pool *pool)
{
    if (pool->status == MURK_OK)
        cli_error(&pool->job->terminal, "out of memory");
    pool->status = MURK_ERROR_MEMORY;
}

/* ---- what workers tell --------------------------------------------------------------------- */

static void take_texts(struct pool *pool, struct hand *hand)
{
    if (!cli_text_take(&hand->output, hand->worker.output) ||
        !cli_text_take(&hand->messages, hand->worker.messages))
        run_out_of_memory(pool);
}

static void end_frame(struct pool *pool, struct hand *hand, const struct cli_frame_result *result,
                      int how)
{
    hand->busy = false;
    hand->done = 0;
    if (!cli_ordered_end(&pool->ordered, hand->index, result, how, &hand->output, &hand->messages))
        run_out_of_memory(pool);
}

static void take_note(struct pool *pool, struct hand *hand, const struct cli_worker_note *note)
{
    if (!note->finished) { /* pictures come second, and stand for half of the frame */
        hand->done = 0.5 * note->done + (strcmp(note->stage, "render") ? 0.0 : 0.5);
        return;
    }
    take_texts(pool, hand);
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

/* ---- the workers --------------------------------------------------------------------------- */

static void dismiss(struct hand *hand)
{
    close(hand->worker.control);
    close(hand->worker.output);
    close(hand->worker.messages);
    hand->worker = (struct cli_worker){0};
    free(hand->output.bytes);
    free(hand->messages.bytes);
    hand->output = hand->messages = (struct cli_text){0};
}

/* Sees to a worker that has ended. */
static void bury(struct pool *pool, struct hand *hand, int how)
{
    const struct cli_frame_result failed = {.status = MURK_ERROR_INTERNAL};
    take_texts(pool, hand);
    if (hand->busy)
        end_frame(pool, hand, &failed, how ? how : W_EXITCODE(EXIT_FAILURE, 0));
    dismiss(hand);
}

static void attend(struct pool *pool, struct hand *hand)
{
    int how = 0;
    take_texts(pool, hand);
    if (hand->busy && hand->index == pool->ordered.told)
        cli_ordered_messages(&pool->ordered, &hand->messages);
    bool open = take_notes(pool, hand);
    if (waitpid(hand->worker.pid, &how, open ? WNOHANG : 0) != 0)
        bury(pool, hand, how);
}

/* Lists the ends of all workers; gives their number. */
static size_t list_ends(const struct pool *pool, struct pollfd *ends)
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
    return count;
}

/* Has a worker on every frame that can have one; how many are at work. */
static size_t staff(struct pool *pool, struct pollfd *ends)
{
    size_t busy = 0;
    for (size_t i = 0; i < pool->hands; i++) {
        struct hand *hand = &pool->hand[i];
        bool wanted =
            !hand->busy && pool->status == MURK_OK && pool->next < pool->crew->frames->count;
        if (wanted && (hand->worker.pid ||
                       cli_worker_start(pool->crew, ends, list_ends(pool, ends), &hand->worker))) {
            hand->busy = true;
            hand->index = pool->next++;
            cli_worker_give(&hand->worker, hand->index);
        }
        busy += hand->busy;
    }
    return busy;
}

/* ---- the sequence -------------------------------------------------------------------------- */

static void show_progress(struct pool *pool)
{
    const struct cli_ordered *ordered = &pool->ordered;
    size_t count = pool->crew->frames->count;
    double worked = (double)(ordered->ended - ordered->skipped);
    for (size_t i = 0; i < pool->hands; i++)
        worked += pool->hand[i].busy ? pool->hand[i].done : 0.0;
    cli_terminal_sequence(&pool->job->terminal, ordered->ended, count, worked,
                          (double)(count - ordered->skipped) - worked,
                          cli_seconds() - pool->started);
}

static void run(struct pool *pool, struct pollfd *ends)
{
    while (staff(pool, ends) > 0) {
        show_progress(pool);
        poll(ends, list_ends(pool, ends), POLL_MS);
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
    free(pool->hand);
}

murk_status cli_pool_run(const struct cli_crew *crew, size_t count, struct cli_job *job,
                         struct cli_tally *tally)
{
    struct pool pool = {.crew = crew,
                        .job = job,
                        .hand = calloc(count, sizeof *pool.hand),
                        .hands = count,
                        .started = cli_seconds()};
    struct pollfd *ends = malloc(ENDS * count * sizeof *ends);
    bool room = cli_ordered_start(&pool.ordered, job, crew->frames, tally);
    if (room && pool.hand && ends)
        run(&pool, ends);
    else
        run_out_of_memory(&pool);
    if (pool.hand)
        close_pool(&pool);
    cli_terminal_clear(&job->terminal);
    cli_ordered_release(&pool.ordered);
    free(ends);
    return cli_worse(pool.status, pool.ordered.output_status);
}
