/* SPDX-License-Identifier: Apache-2.0 */
#include "memory.h"

#include <malloc.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static struct {
    _Atomic uint64_t used, peak, limit;
    atomic_bool refused;       /* the limit did, not the system */
    _Atomic int64_t fail_next; /* allocations that succeed before one fails, -1: none does */
} memory = {.fail_next = -1};

void murk_memory_limit(uint64_t bytes)
{
    atomic_store(&memory.limit, bytes);
    atomic_store(&memory.refused, false);
}

uint64_t murk_memory_used(void)
{
    return atomic_load(&memory.used);
}

uint64_t murk_memory_peak(void)
{
    return atomic_load(&memory.peak);
}

void murk_memory_restart_peak(void)
{
    atomic_store(&memory.peak, atomic_load(&memory.used));
}

uint64_t murk_memory_left(void)
{
    uint64_t limit = atomic_load(&memory.limit), used = atomic_load(&memory.used);
    if (!limit)
        return UINT64_MAX;
    return used < limit ? limit - used : 0;
}

uint64_t murk_memory_refused(void)
{
    return atomic_exchange(&memory.refused, false) ? atomic_load(&memory.limit) : 0;
}

void murk_memory_fail_after(int64_t allocations)
{
    atomic_store(&memory.fail_next, allocations);
}

bool murk_memory_failed(void)
{
    return atomic_load(&memory.fail_next) < 0;
}

static bool may_take(size_t bytes)
{
    if (atomic_load_explicit(&memory.fail_next, memory_order_relaxed) >= 0 &&
        atomic_fetch_sub(&memory.fail_next, 1) == 0)
        return false;
    if (bytes <= murk_memory_left())
        return true;
    atomic_store(&memory.refused, true);
    return false;
}

/* Every array is counted as what the system made of it, so that its end needs no size. */
static void count(void *array)
{
    uint64_t bytes = malloc_usable_size(array);
    uint64_t used = atomic_fetch_add(&memory.used, bytes) + bytes;
    uint64_t peak = atomic_load(&memory.peak);
    while (used > peak && !atomic_compare_exchange_weak(&memory.peak, &peak, used))
        ;
}

/* Sets bytes to what count items take, in whole multiples of 64. */
static void *allocate(size_t items, size_t size, size_t *bytes)
{
    if (__builtin_mul_overflow(items, size, bytes) || *bytes > SIZE_MAX - 63)
        return NULL;
    *bytes = *bytes ? (*bytes + 63) / 64 * 64 : 64;
    void *array = may_take(*bytes) ? aligned_alloc(64, *bytes) : NULL;
    if (array)
        count(array);
    return array;
}

void *murk_alloc(size_t count, size_t size)
{
    size_t bytes;
    void *array = allocate(count, size, &bytes);
    if (array)
        memset(array, 0, bytes);
    return array;
}

void *murk_alloc_unset(size_t count, size_t size)
{
    size_t bytes;
    return allocate(count, size, &bytes);
}

void murk_free(void *array)
{
    if (array)
        atomic_fetch_sub(&memory.used, malloc_usable_size(array));
    free(array);
}
