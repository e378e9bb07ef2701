/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file core.h
 * What all of murk's headers rest on: status, context, files. murk.h includes it.
 */
#ifndef MURK_CORE_H
#define MURK_CORE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define MURK_API
#else
#define MURK_API __attribute__((visibility("default")))
#endif

#define MURK_VERSION "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------ */
/* Status                                                                                      */
/* ------------------------------------------------------------------------------------------ */

/** Name and meaning of every status, for the enumeration and murk_status_text(). */
#define MURK_STATUS_LIST(X)                                                                        \
    X(MURK_OK, "success")                                                                          \
    X(MURK_ERROR_INPUT, "bad input")                                                               \
    X(MURK_ERROR_MEMORY, "out of memory")                                                          \
    X(MURK_ERROR_IO, "the system failed to write")                                                 \
    X(MURK_ERROR_INTERNAL, "internal error")                                                       \
    X(MURK_NOT_REACHED, "tolerance not reached")

/** What a call came to. MURK_NOT_REACHED still delivers its result. */
typedef enum murk_status {
#define MURK_STATUS_ENUM(name, text) name,
    MURK_STATUS_LIST(MURK_STATUS_ENUM)
#undef MURK_STATUS_ENUM
} murk_status;

/** A short English text for a status; never NULL. */
MURK_API const char *murk_status_text(murk_status status);

/* ------------------------------------------------------------------------------------------ */
/* Context                                                                                     */
/* ------------------------------------------------------------------------------------------ */

/** Holds threads, log, progress and the last message. There is no global state but the
 *  count of memory (memory.h) and the names of unfinished outputs. */
typedef struct murk_context murk_context;

/** What a line of the log is about: something the user should know, or what is being done. */
typedef enum murk_log_level { MURK_LOG_WARNING, MURK_LOG_INFO } murk_log_level;

/** Called with one line of text, without line feed. */
typedef void murk_log_fn(void *user, murk_log_level level, const char *text);

/** Called now and then with the stage ("solve", "render", ...) and the part done in [0, 1]. */
typedef void murk_progress_fn(void *user, const char *stage, double done);

/** How a context works and what it tells; copied by murk_context_create(). */
typedef struct murk_context_options {
    int threads;                /**< 0: one per processor */
    const char *kernel;         /**< "avx512", "avx2", "portable"; NULL: the fastest this CPU has */
    murk_log_fn *log;           /**< may be NULL: silence */
    murk_progress_fn *progress; /**< may be NULL */
    void *user;                 /**< passed on to both */
} murk_context_options;

#define MURK_CONTEXT_DEFAULT                                                                       \
    {                                                                                              \
        .threads = 0, .kernel = NULL, .log = NULL, .progress = NULL, .user = NULL                  \
    }

/** Creates a context. options may be NULL. Fails when memory runs out or the kernel is unknown. */
MURK_API murk_status murk_context_create(const murk_context_options *options, murk_context **out);
/** Releases a context, after all objects made with it; NULL is nothing. */
MURK_API void murk_context_release(murk_context *context);

/** The first message of the call that failed last, or "". Valid until the next call. */
MURK_API const char *murk_context_message(const murk_context *context);

/* ------------------------------------------------------------------------------------------ */
/* Files                                                                                       */
/* ------------------------------------------------------------------------------------------ */

/** Writes a file of any other content, `size` bytes: beside the target, then renamed. Fails with
 *  MURK_ERROR_IO where that is impossible. */
MURK_API murk_status murk_file_write(murk_context *context, const char *path, const void *bytes,
                                     size_t size);

/**
 * Removes what outputs that are not complete have left in their folders, for programs that a signal
 * ends: murk installs no handlers. Async-signal-safe; the process must end after it.
 */
MURK_API void murk_outputs_abandon(void);

/** Fails as murk_file_write() would for this path, as far as that can be told before. */
MURK_API murk_status murk_file_check(murk_context *context, const char *path);

#ifdef __cplusplus
}
#endif
#endif
