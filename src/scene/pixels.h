/* SPDX-License-Identifier: Apache-2.0 */
/* Images that a scene names: first channels as one value a ground patch. */
#ifndef SCENE_PIXELS_H
#define SCENE_PIXELS_H

#include "scene.h"

/* The first channel of an image in image order, from malloc. size: where it is 0 x 0 it is set to
   the image's, else the image must have it. Values must be finite and in [0, max]. */
murk_status scene_read_pixels(murk_context *context, const struct scene_description *description,
                              const char *key, const char *file, double max, int size[2],
                              float **out, char message[SCENE_MESSAGE_SIZE]);

#endif
