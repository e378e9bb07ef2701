/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Work on bytes that nobody vouches for, in a child process: a library that crashes, hangs or takes
 * all memory over a damaged file does so there, and the caller gets a status and one line.
 *
 * The child is a copy of the process at murk_apart_start(), without its other threads and
 * descriptors. It answers questions until it is stopped or its parent ends.
 */
#ifndef MURK_CORE_APART_H
#define MURK_CORE_APART_H

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct murk_apart_limits {
    uint64_t memory;  /* bytes beyond those of the process; 0: any. Not under sanitizers. */
    uint64_t seconds; /* of processor time for an answer, so that a slow disk is no offence */
    uint64_t idle;    /* seconds that it may stand still, without any processor time */
} murk_apart_limits;

typedef struct murk_apart_question {
    uint64_t word[3]; /* their meaning is between the caller and serve() */
} murk_apart_question;

/* Answers a question, in the child: fails by murk_fail(), or leaves its result in the file, which
   is empty, in memory, and takes write() and mmap(). What else it changes stays in the child. */
typedef murk_status murk_apart_serve(murk_context *context, void *data,
                                     const murk_apart_question *question, int file);

typedef struct murk_apart_work {
    const char *library; /* for messages: who may fail, ... */
    const char *where;   /* ... and on what; both must outlive the child */
    murk_apart_serve *serve;
    void *data;
    int keep; /* the one descriptor that serve() needs, or -1 */
    murk_apart_limits limits;
} murk_apart_work;

typedef struct murk_apart murk_apart;

/* Makes the child. */
murk_status murk_apart_start(murk_context *context, const murk_apart_work *work, murk_apart **out);

/* Ends and forgets the child, at once; NULL is allowed. */
void murk_apart_stop(murk_apart *apart);

/* What serve() left in its file; close it with murk_apart_close(). */
typedef struct murk_apart_answer {
    int file;
    uint64_t size, taken; /* bytes */
} murk_apart_answer;

/* Has the child answer. Fails as serve() does; with MURK_ERROR_INPUT where the child did not live
   to answer, MURK_ERROR_MEMORY where it was killed from outside. Several threads may ask. */
murk_status murk_apart_ask(murk_context *context, murk_apart *apart,
                           const murk_apart_question *question, murk_apart_answer *out);

/* Copies the next bytes of the answer; false where there are fewer. */
bool murk_apart_take(murk_apart_answer *answer, void *out, size_t size);
void murk_apart_close(murk_apart_answer *answer);

#ifdef __cplusplus
}
#endif
#endif
