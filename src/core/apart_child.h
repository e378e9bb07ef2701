/* SPDX-License-Identifier: Apache-2.0 */
/* Between the two ends of apart.h: the child's life, and what goes over the channel. */
#ifndef MURK_CORE_APART_CHILD_H
#define MURK_CORE_APART_CHILD_H

#include "apart.h"

#include <sys/types.h>

/* One packet; the file of the answer comes along where the status is MURK_OK. */
typedef struct murk_apart_packet {
    int32_t status;
    char message[sizeof((murk_context *)0)->message];
} murk_apart_packet;

/* How the child ends where the library calls exit(). */
enum { MURK_APART_EXIT = 97 };

/* Lives in the child, with all signals blocked until it is confined. */
_Noreturn void murk_apart_live(murk_context *context, const murk_apart_work *work, int channel,
                               pid_t parent);

#endif
