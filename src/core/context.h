/* SPDX-License-Identifier: Apache-2.0 */
/* The context inside the library: errors, log, progress, memory. */
#ifndef MURK_CORE_CONTEXT_H
#define MURK_CORE_CONTEXT_H

#include "murk/murk.h"

#ifdef __cplusplus
extern "C" {
#endif

struct murk_context {
    int threads;
    const char *kernel; /* a static name, or NULL for the fastest */
    murk_log_fn *log;
    murk_progress_fn *progress;
    void *user;
    char message[1024];
    char skipped[600]; /* grids of the volume before that could not be read */
};

/* Records the message of the failure that is being returned and gives back status. Whoever detects
   an error calls it once; callers pass the status on. */
murk_status murk_fail(murk_context *context, murk_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Log one line; silent where the context has no log. */
void murk_warn(murk_context *context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void murk_note(murk_context *context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

void murk_progress(murk_context *context, const char *stage, double done);

/* Zeroed memory aligned to 64 bytes for count items of size bytes, NULL where it fails (count 0
   gives a valid pointer); release with murk_free. */
void *murk_alloc(size_t count, size_t size);
/* The same with any content: memory that is never touched costs none. */
void *murk_alloc_unset(size_t count, size_t size);
void murk_free(void *memory);
/* Puts a copy with room for `capacity` elements, zeroed behind the first `count`, in place of the
   array that *array points to, which may be NULL; array is the address of that pointer. False, and
   nothing changed, where memory fails. */
bool murk_enlarge(void *array, size_t count, size_t capacity, size_t size);

/* Extinctions, albedos and lights below 1e-30 count as 0: no path could notice them, and products
   with them would be denormal, with too few bits for an iteration to come to an end. */
static inline double murk_or_none(double value)
{
    return value < 1e-30 ? 0 : value;
}

/* Seconds of a monotonic clock. */
double murk_seconds(void);

#ifdef __cplusplus
}
#endif
#endif
