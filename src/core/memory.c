/* SPDX-License-Identifier: Apache-2.0 */
#include "memory.h"

#include <malloc.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Counters order no other memory, so all of them are relaxed. Between threads an array may be had
   that passes the limit by what others take at that moment. */
static struct {
    _Atomic uint64_t used, peak, limit;
    atomic_bool refused;       /* the limit did, not the system */
    _Atomic int64_t fail_next; /* allocations that succeed before one fails, -1: none does */
} memory = {.fail_next = -1};

static uint64_t get(const _Atomic uint64_t *of)
{
    return atomic_load_explicit(of, memory_order_relaxed);
}

static void set(_Atomic uint64_t *of, uint64_t value)
{
    atomic_store_explicit(of, value, memory_order_relaxed);
}

void murk_memory_limit(uint64_t bytes)
{
    set(&memory.limit, bytes);
    atomic_store_explicit(&memory.refused, false, memory_order_relaxed);
}

uint64_t murk_memory_used(void)
{
    return get(&memory.used);
}

uint64_t murk_memory_peak(void)
{
    return get(&memory.peak);
}

void murk_memory_restart_peak(void)
{
    set(&memory.peak, get(&memory.used));
}

uint64_t murk_memory_left(void)
{
    uint64_t limit = get(&memory.limit), used = get(&memory.used);
    if (!limit)
        return UINT64_MAX;
    return used < limit ? limit - used : 0;
}

uint64_t murk_memory_refused(void)
{
    return atomic_exchange_explicit(&memory.refused, false, memory_order_relaxed)
               ? get(&memory.limit)
               : 0;
}

void murk_memory_fail_after(int64_t allocations)
{
    atomic_store_explicit(&memory.fail_next, allocations, memory_order_relaxed);
}

bool murk_memory_failed(void)
{
    return atomic_load_explicit(&memory.fail_next, memory_order_relaxed) < 0;
}

static bool may_take(size_t bytes)
{
    if (atomic_load_explicit(&memory.fail_next, memory_order_relaxed) >= 0 &&
        atomic_fetch_sub_explicit(&memory.fail_next, 1, memory_order_relaxed) == 0)
        return false;
    if (bytes <= murk_memory_left())
        return true;
    atomic_store_explicit(&memory.refused, true, memory_order_relaxed);
    return false;
}

/* Every array is counted as what the system made of it, so that its end needs no size. */
static void count(void *array)
{
    uint64_t bytes = malloc_usable_size(array);
    uint64_t used = atomic_fetch_add_explicit(&memory.used, bytes, memory_order_relaxed) + bytes;
    uint64_t peak = get(&memory.peak);
    while (used > peak &&
           !atomic_compare_exchange_weak_explicit(&memory.peak, &peak, used, memory_order_relaxed,
                                                  memory_order_relaxed))
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
        atomic_fetch_sub_explicit(&memory.used, malloc_usable_size(array), memory_order_relaxed);
    free(array);
}

bool murk_enlarge(void *array, size_t count, size_t capacity, size_t size)
{
    void *larger = murk_alloc(capacity, size), *old;
    if (!larger)
        return false;
    memcpy(&old, array, sizeof old);
    if (count)
        memcpy(larger, old, count * size);
    murk_free(old);
    memcpy(array, &larger, sizeof larger);
    return true;
}
