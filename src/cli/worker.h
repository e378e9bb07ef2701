/* SPDX-License-Identifier: Apache-2.0 */
/* A process that runs frames for another. */
#ifndef CLI_WORKER_H
#define CLI_WORKER_H

#include "frame.h"
#include "frames.h"

#include <poll.h>
#include <sys/types.h>

/* What a worker tells now and then of its frame, and at its end. */
struct cli_worker_note {
    bool finished;
    char stage[16]; /* until then: "solve", ... */
    double done;    /* of the stage, in [0, 1] */
    struct cli_frame_result result;
};

/* What all workers of a sequence have in common. */
struct cli_crew {
    const struct cli_job *job; /* of the process that starts them: command and options */
    const struct cli_steps *steps;
    const struct cli_frames *frames;
    int threads; /* of each worker */
    int jobs;    /* workers at most: they share --max-memory */
};

/* The ends that the starting process holds. */
struct cli_worker {
    pid_t pid;
    int control;          /* takes the index of a frame, a size_t; gives notes */
    int output, messages; /* its standard output and error; neither blocks */
};

/*
 * Starts a worker; ends[] are all those ends that the starting process has, whose files the worker
 * closes. The starting process must not have begun any threads. The worker ends when control is
 * closed, and when the process that started it ends. False where the system cannot.
 */
bool cli_worker_start(const struct cli_crew *crew, const struct pollfd *ends, size_t end_count,
                      struct cli_worker *out);

/* Gives a worker the frame at an index; one that is no more is found out otherwise. */
void cli_worker_give(const struct cli_worker *worker, size_t index);

#endif
