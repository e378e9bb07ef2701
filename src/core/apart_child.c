/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE /* close_range, memfd_create */
#include "apart_child.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#ifdef MURK_SANITIZED
enum { SANITIZED = 1 }; /* shadow memory is beyond any limit, and reports are wanted */
#else
enum { SANITIZED = 0 };
#endif

static void reset_signals(void)
{
    /* What a terminal sends to the whole group is the parent's to act upon. */
    static const int ignored[] = {SIGINT, SIGQUIT, SIGHUP, SIGTERM, SIGPIPE, SIGXFSZ};
    sigset_t none;
    for (int s = 1; s < NSIG; s++)
        signal(s, SIG_DFL);
    for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++)
        signal(ignored[i], SIG_IGN);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

static void close_between(int first, int last)
{
    if (first > last || !close_range((unsigned)first, (unsigned)last, 0) || errno != ENOSYS)
        return;
    for (long f = first, end = sysconf(_SC_OPEN_MAX); f <= last && f < end; f++)
        close((int)f);
}

/* Closes all but a few: the other end of a pipe must not wait for this process, too. The standard
   three lead nowhere, so that neither library nor allocator adds lines to murk's. */
static void close_others(int channel, int keep)
{
    int low = keep < channel ? keep : channel, high = keep < channel ? channel : keep;
    int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC), next = 3;
    for (int s = 0; s <= (SANITIZED ? 1 : 2); s++)
        if (nowhere >= 0 && s != low && s != high)
            dup2(nowhere, s);
    close_between(next, low - 1);
    next = low < next ? next : low + 1;
    close_between(next, high - 1);
    close_between(high < next ? next : high + 1, INT_MAX);
}

static void limit(int resource, uint64_t soft)
{
    struct rlimit now;
    if (getrlimit(resource, &now))
        return;
    if (now.rlim_max != RLIM_INFINITY && soft > now.rlim_max)
        soft = now.rlim_max;
    now.rlim_cur = soft;
    setrlimit(resource, &now);
}

/* RLIMIT_DATA and not RLIMIT_AS: that counts address space which is never used. */
static void limit_memory(uint64_t bytes)
{
    unsigned long data = 0;
    struct rlimit now;
    FILE *file = fopen("/proc/self/statm", "re");
    if (!file)
        return;
    int fields = fscanf(file, "%*u %*u %*u %*u %*u %lu", &data);
    fclose(file);
    uint64_t total = data * (uint64_t)sysconf(_SC_PAGESIZE) + bytes;
    if (fields == 1 && !getrlimit(RLIMIT_DATA, &now) && total < now.rlim_cur)
        limit(RLIMIT_DATA, total);
}

/* From now on; SIGXCPU ends the process. */
static void limit_seconds(uint64_t seconds)
{
    struct rusage used;
    if (!getrusage(RUSAGE_SELF, &used))
        limit(RLIMIT_CPU, (uint64_t)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 1 + seconds);
}

/* Answers are files in memory, and no output. */
static void lift_file_size(void)
{
    struct rlimit now;
    const struct rlimit none = {RLIM_INFINITY, RLIM_INFINITY};
    if (setrlimit(RLIMIT_FSIZE, &none) && !getrlimit(RLIMIT_FSIZE, &now)) {
        now.rlim_cur = now.rlim_max;
        setrlimit(RLIMIT_FSIZE, &now);
    }
}

/* A library that calls exit() must not run the handlers of the parent. */
static void leave(void)
{
    _exit(MURK_APART_EXIT);
}

static void confine(const murk_apart_work *work, int channel)
{
    atexit(leave);
    close_others(channel, work->keep);
    limit(RLIMIT_CORE, 0);
    lift_file_size();
    prctl(PR_SET_DUMPABLE, 0); /* a core that is piped to a program knows no limit */
    if (work->limits.memory && !SANITIZED)
        limit_memory(work->limits.memory);
    reset_signals();
}

static bool send_answer(int channel, const murk_apart_packet *packet, int file)
{
    struct iovec body = {(void *)packet, sizeof *packet};
    union {
        struct cmsghdr header;
        char space[CMSG_SPACE(sizeof file)];
    } control = {0};
    struct msghdr message = {.msg_iov = &body, .msg_iovlen = 1};
    if (!packet->status) {
        message.msg_control = &control;
        message.msg_controllen = sizeof control.space;
        control.header = (struct cmsghdr){
            .cmsg_len = CMSG_LEN(sizeof file), .cmsg_level = SOL_SOCKET, .cmsg_type = SCM_RIGHTS};
        memcpy(CMSG_DATA(&control.header), &file, sizeof file);
    }
    return sendmsg(channel, &message, MSG_NOSIGNAL) == (ssize_t)sizeof *packet;
}

static bool answer(murk_context *context, const murk_apart_work *work,
                   const murk_apart_question *question, int channel)
{
    murk_apart_packet packet = {0};
    int file = memfd_create("murk", MFD_CLOEXEC);
    if (file < 0)
        packet.status = murk_fail(context, MURK_ERROR_MEMORY, "%s: no memory for it: %s",
                                  work->where, strerror(errno));
    else
        packet.status = (int32_t)work->serve(context, work->data, question, file);
    memcpy(packet.message, context->message, sizeof packet.message);
    bool sent = send_answer(channel, &packet, file);
    if (file >= 0)
        close(file);
    return sent;
}

void murk_apart_live(murk_context *context, const murk_apart_work *work, int channel, pid_t parent)
{
    /* Words go by the answer alone: the caller's functions are for the caller's process. */
    context->log = NULL;
    context->progress = NULL;
    confine(work, channel);
    /* The signal comes when the thread that forked ends. It waits for the first answer; later ones
       may be for other threads, and then the closed channel tells. */
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(0);
    murk_apart_question question;
    while (recv(channel, &question, sizeof question, 0) == (ssize_t)sizeof question) {
        limit_seconds(work->limits.seconds);
        if (!answer(context, work, &question, channel))
            break;
        prctl(PR_SET_PDEATHSIG, 0);
    }
    _exit(0);
}
