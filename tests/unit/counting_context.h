/* SPDX-License-Identifier: Apache-2.0 */
/* The context of a group of tests, as their setup and teardown; counts warnings. */
#ifndef TESTS_COUNTING_CONTEXT_H
#define TESTS_COUNTING_CONTEXT_H

#include "murk/murk.h"

static int warnings;

static void count_warnings(void *user, murk_log_level level, const char *text)
{
    (void)user;
    (void)text;
    warnings += level == MURK_LOG_WARNING;
}

static int make_context(void **state)
{
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    options.log = count_warnings;
    murk_context *context = NULL;
    murk_status status = murk_context_create(&options, &context);
    *state = context;
    return status;
}

static int drop_context(void **state)
{
    murk_context_release(*state);
    return 0;
}

#endif
