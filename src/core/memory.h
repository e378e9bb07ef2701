/* SPDX-License-Identifier: Apache-2.0 */
/* The count of memory inside the library; arrays come from murk_alloc() of context.h. */
#ifndef MURK_CORE_MEMORY_H
#define MURK_CORE_MEMORY_H

#include "context.h"
#include "murk/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes that may still be taken. */
uint64_t murk_memory_left(void);

/* Fails where the limit does not leave `bytes` for what is about to be done ("solving"). */
murk_status murk_memory_check(murk_context *context, const char *what, uint64_t bytes);

/* From here on the peak is that of what follows. */
void murk_memory_restart_peak(void);

/* The limit, where it refused an array since this was asked last; else 0. */
uint64_t murk_memory_refused(void);

/* "3.1 GiB" */
enum { MURK_MEMORY_TEXT = 32 };
const char *murk_memory_text(uint64_t bytes, char text[MURK_MEMORY_TEXT]);

/* For tests: lets so many allocations succeed and the one after them fail; negative: none fails. */
void murk_memory_fail_after(int64_t allocations);
/* Whether that one has been asked for. */
bool murk_memory_failed(void);

#ifdef __cplusplus
}
#endif
#endif
