/* SPDX-License-Identifier: Apache-2.0 */
/* A child that crashes, hangs, eats memory or leaves: one line, no zombie, no descriptor. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "apart.h"
#include "counting_context.h"
#include "leftovers.h"

#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    SQUARE,
    THREADS,
    DESCRIPTORS,
    FAIL,
    CRASH,
    ABORT,
    SPIN,
    STAND_STILL,
    ALLOCATE,
    EXIT,
    CLOSE,
    SHOUT,
    KILLED
};

static int state_of_data = 7;

static murk_status put_number(murk_context *context, int file, uint64_t number)
{
    if (write(file, &number, sizeof number) != sizeof number)
        return murk_fail(context, MURK_ERROR_IO, "it does not take numbers");
    return MURK_OK;
}

/* Memory in pieces that a limit of some megabytes must stop. */
static murk_status allocate(murk_context *context)
{
    for (int i = 0; i < 1 << 14; i++) {
        char *piece = malloc(1 << 20);
        if (!piece)
            return murk_fail(context, MURK_ERROR_MEMORY, "out of memory after %d MB", i);
        memset(piece, i, 1 << 20);
    }
    return MURK_OK;
}

static murk_status serve(murk_context *context, void *data, const murk_apart_question *question,
                         int file)
{
    uint64_t n = question->word[1];
    murk_warn(context, "words of the child");
    switch (question->word[0]) {
    case SQUARE:
        *(int *)data += 1;
        return put_number(context, file, n * n);
    case THREADS:
        return put_number(context, file, count_entries("/proc/self/task"));
    case DESCRIPTORS:
        return put_number(context, file, count_entries("/proc/self/fd"));
    case FAIL:
        return murk_fail(context, MURK_ERROR_INPUT, "number %d\nis bad", (int)n);
    case CRASH:
        *(volatile int *)n = 1;
        break;
    case ABORT:
        abort();
    case SPIN:
        for (;;)
            __asm__ volatile("");
    case STAND_STILL:
        pause();
        break;
    case ALLOCATE:
        return allocate(context);
    case EXIT:
        exit(0);
    case CLOSE:
        for (int f = 3; f < 100; f++)
            close(f);
        break;
    case SHOUT:
        printf("shouted\n");
        fflush(stdout);
        return put_number(context, file, 1);
    case KILLED:
        raise(SIGKILL);
    }
    return MURK_OK;
}

static const murk_apart_work work = {.library = "OpenVDB",
                                     .where = "smoke.vdb",
                                     .serve = serve,
                                     .data = &state_of_data,
                                     .keep = -1,
                                     .limits = {.memory = 64 << 20, .seconds = 1, .idle = 2}};

static murk_apart *start(murk_context *context)
{
    murk_apart *apart = NULL;
    assert_int_equal(murk_apart_start(context, &work, &apart), MURK_OK);
    return apart;
}

static uint64_t ask(murk_context *context, murk_apart *apart, uint64_t what, uint64_t n)
{
    const murk_apart_question question = {{what, n}};
    murk_apart_answer answer;
    uint64_t number;
    if (murk_apart_ask(context, apart, &question, &answer))
        fail_msg("%s", murk_context_message(context));
    assert_int_equal(answer.size, sizeof number);
    assert_true(murk_apart_take(&answer, &number, sizeof number));
    assert_false(murk_apart_take(&answer, &number, 1));
    murk_apart_close(&answer);
    return number;
}

static void test_answers(void **state)
{
    size_t before = count_entries("/proc/self/fd");
    murk_apart *apart = start(*state);
    for (uint64_t n = 0; n < 50; n++)
        assert_int_equal(ask(*state, apart, SQUARE, n), n * n);
    assert_int_equal(state_of_data, 7);
    assert_int_equal(warnings, 0);
    murk_apart_stop(apart);
    murk_apart_stop(NULL);
    assert_alone();
    assert_int_equal(count_entries("/proc/self/fd"), before);
}

static void *sleep_on(void *pipe_end)
{
    char byte;
    while (read(*(int *)pipe_end, &byte, 1) < 0)
        ;
    return NULL;
}

/* The child has one thread, and of all descriptors the standard ones, the channel, the answer, and
   here the folder that it counts them in. */
static void test_alone(void **state)
{
    pthread_t thread;
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    assert_int_equal(pthread_create(&thread, NULL, sleep_on, &ends[0]), 0);
    murk_apart *apart = start(*state), *second = start(*state);
    assert_int_equal(ask(*state, apart, THREADS, 0), 1);
    assert_int_equal(ask(*state, second, DESCRIPTORS, 0), 6);
    murk_apart_stop(apart);
    assert_int_equal(ask(*state, second, SQUARE, 9), 81);
    murk_apart_stop(second);
    close(ends[1]);
    pthread_join(thread, NULL);
    close(ends[0]);
    assert_alone();
}

/* What stands in a buffer of the parent must not come out twice, and nothing of the child's. */
static void test_quiet(void **state)
{
    int ends[2], kept = dup(STDOUT_FILENO);
    char text[100] = "";
    assert_int_equal(pipe(ends), 0);
    fflush(stdout);
    dup2(ends[1], STDOUT_FILENO);
    printf("once\n");
    murk_apart *apart = start(*state);
    ask(*state, apart, SHOUT, 0);
    murk_apart_stop(apart);
    fflush(stdout);
    dup2(kept, STDOUT_FILENO);
    close(kept);
    close(ends[1]);
    ssize_t size = read(ends[0], text, sizeof text - 1);
    close(ends[0]);
    assert_int_equal(size, 5);
    assert_string_equal(text, "once\n");
}

static void assert_end(murk_context *context, uint64_t what, uint64_t n, murk_status status,
                       const char *part)
{
    size_t before = count_entries("/proc/self/fd");
    const murk_apart_question question = {{what, n}}, another = {{SQUARE, 3}};
    murk_apart_answer answer = {.file = -5};
    murk_apart *apart = start(context);
    for (int again = 0; again < 2; again++) {
        assert_int_equal(murk_apart_ask(context, apart, again ? &another : &question, &answer),
                         status);
        assert_int_equal(answer.file, -5);
        const char *message = murk_context_message(context);
        if (strncmp(message, "smoke.vdb: ", 11) || !strstr(message, part) || strchr(message, '\n'))
            fail_msg("\"%s\" does not name \"%s\" on one line", message, part);
    }
    murk_apart_stop(apart);
    assert_alone();
    assert_int_equal(count_entries("/proc/self/fd"), before);
}

static void test_ends(void **state)
{
    assert_end(*state, ABORT, 0, MURK_ERROR_INPUT, "OpenVDB crashed (Aborted) on it");
    assert_end(*state, CRASH, 0, MURK_ERROR_INPUT, "OpenVDB crashed (Segmentation fault) on it");
    assert_end(*state, SPIN, 0, MURK_ERROR_INPUT, "took more than 1 s of processor time");
    assert_end(*state, STAND_STILL, 0, MURK_ERROR_INPUT, "nothing has happened for 2 s");
    assert_end(*state, EXIT, 0, MURK_ERROR_INPUT, "OpenVDB gave up on it");
    assert_end(*state, CLOSE, 0, MURK_ERROR_INPUT, "OpenVDB gave up on it");
    assert_end(*state, KILLED, 0, MURK_ERROR_MEMORY, "was killed");
}

/* A failure that the child can tell is no end of it. */
static void test_failures(void **state)
{
    const murk_apart_question bad = {{FAIL, 13}}, greedy = {{ALLOCATE}};
    murk_apart_answer answer;
    murk_apart *apart = start(*state);
    assert_int_equal(murk_apart_ask(*state, apart, &bad, &answer), MURK_ERROR_INPUT);
    assert_string_equal(murk_context_message(*state), "number 13 is bad");
    assert_int_equal(ask(*state, apart, SQUARE, 4), 16);
#ifndef MURK_SANITIZED
    assert_int_equal(murk_apart_ask(*state, apart, &greedy, &answer), MURK_ERROR_MEMORY);
    assert_non_null(strstr(murk_context_message(*state), "out of memory after"));
#else
    (void)greedy;
#endif
    murk_apart_stop(apart);
    assert_alone();
}

/* A host that ignores the end of its children, or waits for all of them. */
static void test_hosts(void **state)
{
    const murk_apart_question crash = {{CRASH}};
    murk_apart_answer answer;
    signal(SIGCHLD, SIG_IGN);
    murk_apart *apart = start(*state);
    assert_int_equal(ask(*state, apart, SQUARE, 4), 16);
    assert_int_equal(murk_apart_ask(*state, apart, &crash, &answer), MURK_ERROR_INPUT);
    murk_apart_stop(apart);
    signal(SIGCHLD, SIG_DFL);
    assert_alone();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_answers),  cmocka_unit_test(test_alone),
        cmocka_unit_test(test_quiet),    cmocka_unit_test(test_ends),
        cmocka_unit_test(test_failures), cmocka_unit_test(test_hosts),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
