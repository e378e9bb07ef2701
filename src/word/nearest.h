/* SPDX-License-Identifier: Apache-2.0 */
/* The known word nearest to one that is not known. */
#ifndef MURK_WORD_NEAREST_H
#define MURK_WORD_NEAREST_H

#include <stddef.h>

enum { MURK_EDIT_DISTANCE_MAX = 48 };

/* Edits (insert, delete, replace, swap neighbours; case ignored) that turn a into b; for
   words that are longer than that, the greatest distance. */
int murk_edit_distance(const char *a, const char *b);

/* The best candidate so far: start with {0}, offer every known word. */
struct murk_nearest {
    const char *word;
    int distance;
};
void murk_nearest_offer(struct murk_nearest *nearest, const char *unknown, const char *known);

#endif
