/* SPDX-License-Identifier: Apache-2.0 */
/* The parent's side: makes the child, asks it, and says in words how it ended. */
#define _GNU_SOURCE /* MSG_CMSG_CLOEXEC */
#include "apart_child.h"

#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

struct murk_apart {
    murk_apart_work work;
    pthread_mutex_t lock; /* around a question and its answer */
    pid_t pid;            /* 0: ended, ... */
    int channel;
    murk_status end; /* ... with this status and ... */
    char reason[400];
};

enum { PATIENCE = 10000 }; /* ms that a process may take to die */

static pid_t start_child(murk_context *context, const murk_apart_work *work, const int ends[2])
{
    sigset_t all, before;
    pid_t parent = getpid();
    sigfillset(&all);
    /* No handler of the caller's may run in the child. */
    pthread_sigmask(SIG_SETMASK, &all, &before);
    pid_t pid = fork();
    if (!pid) {
        close(ends[0]);
        murk_apart_live(context, work, ends[1], parent);
    }
    int reason = errno;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return pid;
}

murk_status murk_apart_start(murk_context *context, const murk_apart_work *work, murk_apart **out)
{
    int ends[2];
    murk_apart *apart = murk_alloc(1, sizeof *apart);
    if (!apart)
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", work->where);
    apart->work = *work;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends)) {
        murk_fail(context, MURK_ERROR_MEMORY, "%s: no channel to read it by: %s", work->where,
                  strerror(errno));
        murk_free(apart);
        return MURK_ERROR_MEMORY;
    }
    apart->channel = ends[0];
    apart->pid = start_child(context, work, ends);
    close(ends[1]);
    if (apart->pid < 0) {
        murk_fail(context, MURK_ERROR_MEMORY, "%s: no process to read it in: %s", work->where,
                  strerror(errno));
        close(apart->channel);
        murk_free(apart);
        return MURK_ERROR_MEMORY;
    }
    pthread_mutex_init(&apart->lock, NULL);
    *out = apart;
    return MURK_OK;
}

static pid_t wait_for(pid_t pid, int *how, int options)
{
    pid_t got;
    do
        got = waitpid(pid, how, options);
    while (got < 0 && errno == EINTR);
    return got;
}

/* Gives how the child ended, as waitpid() has it, or -1 where the host has waited for it already:
   then its number may be another's by now. Patience, in milliseconds, lets one that is dying tell
   its own reason. */
static int end_child(murk_apart *apart, int patience)
{
    const struct timespec millisecond = {.tv_nsec = 1000000};
    int how = -1;
    pid_t got;
    close(apart->channel);
    while (!(got = wait_for(apart->pid, &how, WNOHANG)) && patience-- > 0)
        nanosleep(&millisecond, NULL);
    if (!got) {
        kill(apart->pid, SIGKILL);
        got = wait_for(apart->pid, &how, 0);
    }
    apart->pid = 0;
    return got < 0 ? -1 : how;
}

void murk_apart_stop(murk_apart *apart)
{
    if (!apart)
        return;
    if (apart->pid)
        end_child(apart, 0);
    pthread_mutex_destroy(&apart->lock);
    murk_free(apart);
}

/* Notes how a child ended that had to answer. */
static void note_end(murk_apart *apart, int how)
{
    const murk_apart_work *work = &apart->work;
    char what[200];
    apart->end = MURK_ERROR_INPUT;
    if (how >= 0 && WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL) {
        apart->end = MURK_ERROR_MEMORY;
        snprintf(apart->reason, sizeof apart->reason,
                 "the process that read it was killed; is there enough memory?");
        return;
    }
    if (how >= 0 && WIFSIGNALED(how) && WTERMSIG(how) == SIGXCPU)
        snprintf(what, sizeof what, "took more than %llu s of processor time",
                 (unsigned long long)work->limits.seconds);
    else if (how >= 0 && WIFSIGNALED(how))
        snprintf(what, sizeof what, "crashed (%s)", strsignal(WTERMSIG(how)));
    else
        snprintf(what, sizeof what, "gave up");
    snprintf(apart->reason, sizeof apart->reason,
             "%s %s on it; the file is damaged: write or copy it again", work->library, what);
}

static void note_standstill(murk_apart *apart)
{
    apart->end = MURK_ERROR_INPUT;
    snprintf(apart->reason, sizeof apart->reason,
             "nothing has happened for %llu s while %s read it; copy the file to another disk, or "
             "write it again",
             (unsigned long long)apart->work.limits.idle, apart->work.library);
}

static bool used_seconds(pid_t pid, struct timespec *out)
{
    clockid_t clock;
    return !clock_getcpuclockid(pid, &clock) && !clock_gettime(clock, out);
}

/* Waits for an answer or the child's end; false where the child stands still. Rounds are counted
   and not the clock, which runs on while both processes are stopped. */
static bool await(murk_apart *apart)
{
    struct pollfd ready = {.fd = apart->channel, .events = POLLIN};
    struct timespec before = {0}, now;
    for (uint64_t idle = 0; idle < apart->work.limits.idle; idle++) {
        int got = poll(&ready, 1, 1000);
        if (got > 0)
            return true;
        if (got < 0 && errno != EINTR)
            return true; /* receiving will fail as well */
        bool moved = used_seconds(apart->pid, &now) &&
                     (now.tv_sec != before.tv_sec || now.tv_nsec != before.tv_nsec);
        if (got < 0 || moved)
            idle = 0;
        if (moved)
            before = now;
    }
    return false;
}

/* Receives a packet, and its file or -1; false where the child is gone. */
static bool receive(int channel, murk_apart_packet *packet, int *file)
{
    struct iovec body = {packet, sizeof *packet};
    union {
        struct cmsghdr header;
        char space[CMSG_SPACE(sizeof *file)];
    } control = {0};
    struct msghdr message = {.msg_iov = &body,
                             .msg_iovlen = 1,
                             .msg_control = &control,
                             .msg_controllen = sizeof control.space};
    ssize_t size;
    do
        size = recvmsg(channel, &message, MSG_CMSG_CLOEXEC);
    while (size < 0 && errno == EINTR);
    const struct cmsghdr *header = CMSG_FIRSTHDR(&message);
    *file = -1;
    if (header && header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS &&
        header->cmsg_len == CMSG_LEN(sizeof *file))
        memcpy(file, CMSG_DATA(header), sizeof *file);
    return size == (ssize_t)sizeof *packet;
}

/* What a damaged child says is used as it is, but for what would spoil the line. */
static murk_status pass_on(murk_context *context, murk_apart_packet *packet)
{
    bool known = packet->status > MURK_OK && packet->status <= MURK_ERROR_INTERNAL;
    packet->message[sizeof packet->message - 1] = 0;
    for (char *p = packet->message; *p; p++)
        if ((unsigned char)*p < ' ')
            *p = ' ';
    return murk_fail(context, known ? (murk_status)packet->status : MURK_ERROR_INTERNAL, "%s",
                     packet->message);
}

static murk_status ask(murk_context *context, murk_apart *apart,
                       const murk_apart_question *question, murk_apart_answer *out)
{
    murk_apart_packet packet;
    murk_apart_answer answer = {.file = -1};
    struct stat info;
    bool stands = false, got = false;
    if (apart->pid) {
        send(apart->channel, question, sizeof *question, MSG_NOSIGNAL);
        stands = !await(apart);
        got = !stands && receive(apart->channel, &packet, &answer.file);
        got = got && (packet.status || (answer.file >= 0 && !fstat(answer.file, &info)));
        if (stands) {
            end_child(apart, 0);
            note_standstill(apart);
        } else if (!got)
            note_end(apart, end_child(apart, PATIENCE));
    }
    if (got && !packet.status) {
        answer.size = (uint64_t)info.st_size;
        *out = answer;
        return MURK_OK;
    }
    if (answer.file >= 0)
        close(answer.file);
    if (got)
        return pass_on(context, &packet);
    return murk_fail(context, apart->end, "%s: %s", apart->work.where, apart->reason);
}

murk_status murk_apart_ask(murk_context *context, murk_apart *apart,
                           const murk_apart_question *question, murk_apart_answer *out)
{
    pthread_mutex_lock(&apart->lock);
    murk_status status = ask(context, apart, question, out);
    pthread_mutex_unlock(&apart->lock);
    return status;
}

bool murk_apart_take(murk_apart_answer *answer, void *out, size_t size)
{
    if (size > answer->size - answer->taken)
        return false;
    for (size_t done = 0; done < size;) {
        ssize_t got =
            pread(answer->file, (char *)out + done, size - done, (off_t)(answer->taken + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        done += (size_t)got;
    }
    answer->taken += size;
    return true;
}

void murk_apart_close(murk_apart_answer *answer)
{
    close(answer->file);
    answer->file = -1;
}
