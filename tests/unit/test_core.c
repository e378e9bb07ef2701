/* SPDX-License-Identifier: Apache-2.0 */
/* Context, messages and memory. */
#include "check.h"
#include "context.h"
#include "kernel.h"

#include <limits.h>

static void memory(void **state)
{
    (void)state;
    for (size_t count = 0; count < 200; count += 7) {
        unsigned char *bytes = murk_alloc(count, 3);
        assert_non_null(bytes);
        assert_int_equal((uintptr_t)bytes % 64, 0);
        for (size_t i = 0; i < 3 * count; i++)
            assert_int_equal(bytes[i], 0);
        memset(bytes, 0xFF, 3 * count); /* so that the next one is not zero by chance */
        murk_free(bytes);
    }
    murk_free(NULL);
    assert_null(murk_alloc(SIZE_MAX / 2, 3)); /* the product overflows */
    assert_null(murk_alloc(SIZE_MAX, 1));     /* and so does rounding up to 64 */
}

static void messages(void **state)
{
    (void)state;
    murk_context *context = check_context(1, NULL);
    assert_string_equal(murk_context_message(context), "");
    assert_int_equal(murk_fail(context, MURK_ERROR_IO, "%s: %d", "plume.vdb", 7), MURK_ERROR_IO);
    assert_string_equal(murk_context_message(context), "plume.vdb: 7");
    static char longer[5000];
    memset(longer, 'x', sizeof longer - 1);
    murk_fail(context, MURK_ERROR_INPUT, "%s", longer);
    assert_int_equal(strlen(murk_context_message(context)), sizeof context->message - 1);
    murk_context_release(context);
    murk_context_release(NULL);
}

static void texts(void **state)
{
    (void)state;
#define CHECK_TEXT(name, text) assert_string_equal(murk_status_text(name), text);
    MURK_STATUS_LIST(CHECK_TEXT)
#undef CHECK_TEXT
    assert_non_null(murk_status_text((murk_status)1000));
}

/* An unknown kernel fails by the time it is asked for, and leaves no context behind. */
static void kernels(void **state)
{
    (void)state;
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    options.kernel = "sse9";
    murk_context *context = NULL;
    assert_int_equal(murk_context_create(&options, &context), MURK_ERROR_INPUT);
    assert_null(context);
    context = check_context(1, "portable");
    murk_kernel_fn *kernel = NULL;
    const char *name = NULL;
    assert_int_equal(murk_kernel_choose(context, &kernel, &name), MURK_OK);
    assert_string_equal(name, "portable");
    murk_context_release(context);
    context = check_context(0, NULL);
    assert_true(context->threads >= 1);
    murk_context_release(context);
}

typedef struct heard {
    int infos, warnings, progress;
    char last[64];
    double done;
} heard;

static void hear(void *user, murk_log_level level, const char *text)
{
    heard *h = user;
    h->infos += level == MURK_LOG_INFO;
    h->warnings += level == MURK_LOG_WARNING;
    snprintf(h->last, sizeof h->last, "%s", text);
}

static void watch(void *user, const char *stage, double done)
{
    heard *h = user;
    h->progress += !strcmp(stage, "solve");
    h->done = done;
}

static void callbacks(void **state)
{
    (void)state;
    heard h = {0};
    const murk_context_options options = {.threads = 1, .log = hear, .progress = watch, .user = &h};
    murk_context *context = NULL;
    assert_int_equal(murk_context_create(&options, &context), MURK_OK);
    murk_warn(context, "%d voxels", 3);
    assert_string_equal(h.last, "3 voxels");
    murk_note(context, "note");
    murk_progress(context, "solve", 0.5);
    assert_int_equal(h.warnings, 1);
    assert_int_equal(h.infos, 1);
    assert_int_equal(h.progress, 1);
    assert_within(h.done, 0.5, 0);
    murk_context_release(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory),  cmocka_unit_test(messages),  cmocka_unit_test(texts),
        cmocka_unit_test(kernels), cmocka_unit_test(callbacks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
