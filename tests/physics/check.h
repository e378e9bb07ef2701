/* SPDX-License-Identifier: Apache-2.0 */
/* What the tests share: assertions with a tolerance, reproducible random numbers, small scenes. */
#ifndef CHECK_H
#define CHECK_H

/* cmocka.h needs these four before it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "murk/murk.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* |value - wanted| <= tolerance; false for NaN. */
#define assert_within(value, wanted, tolerance)                                                    \
    do {                                                                                           \
        double value_ = (value), wanted_ = (wanted), tolerance_ = (tolerance);                     \
        if (!(fabs(value_ - wanted_) <= tolerance_))                                               \
            fail_msg("%s is %.9g, not %.9g within %.3g", #value, value_, wanted_, tolerance_);     \
    } while (0)

#define assert_at_most(value, limit)                                                               \
    do {                                                                                           \
        double value_ = (value), limit_ = (limit);                                                 \
        if (!(value_ <= limit_))                                                                   \
            fail_msg("%s is %.6g, above %.6g", #value, value_, limit_);                            \
    } while (0)

/* xorshift64* (Marsaglia 2003, Vigna 2016): the same numbers on every machine. state is not 0. */
static inline double check_random(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (double)(*state * 0x2545F4914F6CDD1Du >> 11) * 0x1p-53;
}

/* A uniformly distributed unit vector. */
static inline void check_direction(uint64_t *state, double out[3])
{
    double z = 2 * check_random(state) - 1, angle = 2 * M_PI * check_random(state);
    out[0] = sqrt(1 - z * z) * cos(angle);
    out[1] = sqrt(1 - z * z) * sin(angle);
    out[2] = z;
}

static inline murk_context *check_context(int threads, const char *kernel)
{
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    murk_context *context = NULL;
    options.threads = threads;
    options.kernel = kernel;
    assert_int_equal(murk_context_create(&options, &context), MURK_OK);
    return context;
}

/* For a group of tests that share a context. */
static inline int open_context(void **state)
{
    *state = check_context(1, NULL);
    return 0;
}

static inline int close_context(void **state)
{
    murk_context_release(*state);
    return 0;
}

static inline size_t check_count(const murk_array *array)
{
    return (size_t)array->size[0] * (size_t)array->size[1] * (size_t)array->size[2];
}

/* Position of a voxel in the arrays of a murk_array. */
static inline size_t check_at(const murk_array *array, int32_t i, int32_t j, int32_t k)
{
    return ((size_t)i * (size_t)array->size[1] + (size_t)j) * (size_t)array->size[2] + (size_t)k;
}

/* A scene of an array of voxels over a ground, and its solution. */
struct world {
    murk_context *context;
    murk_medium *medium;
    murk_ground *ground;
    murk_scene scene;
    murk_solution *solution;
    murk_array array; /* borrowed pointers */
};

/* ground NULL: none. Sun and sky of w->scene are the caller's to set afterwards. */
static inline void world_open(struct world *w, int threads, const murk_array *array,
                              const murk_ground_options *ground)
{
    memset(w, 0, sizeof *w);
    w->array = *array;
    w->context = check_context(threads, NULL);
    if (murk_medium_from_array(w->context, array, &w->medium) ||
        (ground && murk_ground_create(w->context, ground, &w->ground)))
        fail_msg("%s", murk_context_message(w->context));
    w->scene = (murk_scene){.medium = w->medium, .ground = w->ground};
}

/* Where directions are given the tolerance drives the iteration alone, so missing it is no failure;
   else the solution has to be within it. */
static inline void world_solve(struct world *w, const murk_solve_options *options)
{
    murk_solution_release(w->solution);
    w->solution = NULL;
    murk_status status = murk_solve(w->context, &w->scene, options, &w->solution);
    if (status && !(status == MURK_NOT_REACHED && options && options->directions))
        fail_msg("%s", murk_context_message(w->context));
}

static inline void world_close(struct world *w)
{
    murk_solution_release(w->solution);
    murk_ground_release(w->ground);
    murk_medium_release(w->medium);
    murk_context_release(w->context);
}

static inline double world_b(const struct world *w, int32_t i, int32_t j, int32_t k)
{
    return murk_solution_radiosity(w->solution, (const int32_t[3]){i, j, k});
}

#endif
