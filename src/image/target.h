/* SPDX-License-Identifier: Apache-2.0 */
/* Files that are complete or not there: written beside the target, then renamed. */
#ifndef MURK_IMAGE_TARGET_H
#define MURK_IMAGE_TARGET_H

#include "murk/murk.h"

typedef struct murk_target {
    const char *path; /* of the caller */
    char *temporary;  /* beside it, with the same extension */
} murk_target;

/* Fails as murk_target_open() would, as far as that can be known without writing. */
murk_status murk_target_check(murk_context *context, const char *path);

/* Makes the temporary file, empty, so that the system's own reason is known if it refuses. */
murk_status murk_target_open(murk_context *context, const char *path, murk_target *target);

/* Ends a target: where status is MURK_OK the temporary becomes the file, else it is removed.
   Returns status, or MURK_ERROR_IO where the renaming fails. */
murk_status murk_target_close(murk_context *context, murk_target *target, murk_status status);

#endif
