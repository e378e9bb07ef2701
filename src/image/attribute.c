/* SPDX-License-Identifier: Apache-2.0 */
/* Texts that an image carries by name. */
#include "context.h"
#include "image.h"

#include <string.h>

static char *copy(const char *text)
{
    size_t size = strlen(text) + 1;
    char *result = murk_alloc(size, 1);
    return result ? memcpy(result, text, size) : NULL;
}

/* Where the attribute of a name is linked in, or would be. */
static murk_attribute **find(murk_image *image, const char *name)
{
    murk_attribute **at = &image->attributes;
    while (*at && strcmp((*at)->name, name))
        at = &(*at)->next;
    return at;
}

void murk_attributes_release(murk_attribute *first)
{
    while (first) {
        murk_attribute *next = first->next;
        murk_free(first->name);
        murk_free(first->text);
        murk_free(first);
        first = next;
    }
}

murk_status murk_image_set_attribute(murk_image *image, const char *name, const char *text)
{
    if (!*name)
        return MURK_ERROR_INPUT;
    murk_attribute **at = find(image, name), *added = NULL;
    char *copied = copy(text);
    if (!*at && (added = murk_alloc(1, sizeof *added)))
        added->name = copy(name);
    if (!copied || (!*at && (!added || !added->name))) {
        murk_free(copied);
        murk_attributes_release(added);
        return MURK_ERROR_MEMORY;
    }
    if (added)
        *at = added;
    murk_free((*at)->text);
    (*at)->text = copied;
    return MURK_OK;
}

const char *murk_image_attribute(const murk_image *image, const char *name)
{
    for (const murk_attribute *a = image->attributes; a; a = a->next)
        if (!strcmp(a->name, name))
            return a->text;
    return NULL;
}
