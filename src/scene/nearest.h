/* SPDX-License-Identifier: Apache-2.0 */
/* The known word nearest to one that is not known. */
#ifndef SCENE_NEAREST_H
#define SCENE_NEAREST_H

#include <stddef.h>

/* Edits (insert, delete, replace, swap neighbours; case ignored) that turn a into b. */
int scene_edit_distance(const char *a, const char *b);

/* The best candidate so far: start with {0}, offer every known word. */
struct scene_nearest {
    const char *word;
    int distance;
};
void scene_nearest_offer(struct scene_nearest *nearest, const char *unknown, const char *known);

#endif
