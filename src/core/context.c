/* SPDX-License-Identifier: Apache-2.0 */
#include "context.h"

#include "memory.h"

#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

const char *murk_status_text(murk_status status)
{
    switch (status) {
#define MURK_STATUS_CASE(name, text)                                                               \
    case name:                                                                                     \
        return text;
        MURK_STATUS_LIST(MURK_STATUS_CASE)
#undef MURK_STATUS_CASE
    }
    return "unknown status";
}

murk_status murk_context_create(const murk_context_options *options, murk_context **out)
{
    static const char *const kernels[] = {"avx512", "avx2", "portable"};
    murk_context *context = murk_alloc(1, sizeof *context);
    if (!context)
        return MURK_ERROR_MEMORY;
    const murk_context_options defaults = MURK_CONTEXT_DEFAULT;
    if (!options)
        options = &defaults;
    context->threads = options->threads > 0 ? options->threads : omp_get_num_procs();
    context->log = options->log;
    context->progress = options->progress;
    context->user = options->user;
    if (options->kernel) {
        for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++)
            if (!strcmp(options->kernel, kernels[i]))
                context->kernel = kernels[i];
        if (!context->kernel) {
            murk_free(context);
            return MURK_ERROR_INPUT;
        }
    }
    *out = context;
    return MURK_OK;
}

void murk_context_release(murk_context *context)
{
    murk_free(context);
}

const char *murk_context_message(const murk_context *context)
{
    return context->message;
}

murk_status murk_fail(murk_context *context, murk_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(context->message, sizeof context->message, format, arguments);
    va_end(arguments);
    uint64_t limit = status == MURK_ERROR_MEMORY ? murk_memory_refused() : 0;
    if (limit) {
        char text[MURK_MEMORY_TEXT];
        size_t end = strlen(context->message);
        snprintf(context->message + end, sizeof context->message - end,
                 ": the memory limit is %s; use a larger one", murk_memory_text(limit, text));
    }
    return status;
}

static void log_line(murk_context *context, murk_log_level level, const char *format,
                     va_list arguments)
{
    char text[1024];
    if (!context->log)
        return;
    vsnprintf(text, sizeof text, format, arguments);
    context->log(context->user, level, text);
}

void murk_warn(murk_context *context, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    log_line(context, MURK_LOG_WARNING, format, arguments);
    va_end(arguments);
}

void murk_note(murk_context *context, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    log_line(context, MURK_LOG_INFO, format, arguments);
    va_end(arguments);
}

void murk_progress(murk_context *context, const char *stage, double done)
{
    if (context->progress)
        context->progress(context->user, stage, done);
}

double murk_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
