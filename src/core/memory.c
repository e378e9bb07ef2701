/* SPDX-License-Identifier: Apache-2.0 */
#include "context.h"

#include <stdlib.h>
#include <string.h>

/* Sets bytes to what count items take, in whole multiples of 64. */
static void *allocate(size_t count, size_t size, size_t *bytes)
{
    if (__builtin_mul_overflow(count, size, bytes) || *bytes > SIZE_MAX - 63)
        return NULL;
    *bytes = *bytes ? (*bytes + 63) / 64 * 64 : 64;
    return aligned_alloc(64, *bytes);
}

void *murk_alloc(size_t count, size_t size)
{
    size_t bytes;
    void *memory = allocate(count, size, &bytes);
    if (memory)
        memset(memory, 0, bytes);
    return memory;
}

void *murk_alloc_unset(size_t count, size_t size)
{
    size_t bytes;
    return allocate(count, size, &bytes);
}

void murk_free(void *memory)
{
    free(memory);
}
