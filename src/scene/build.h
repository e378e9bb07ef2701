/* SPDX-License-Identifier: Apache-2.0 */
/* The parts of scene_build(), each for one band. All give a murk_status, with the one line in
   message where it is not MURK_OK. */
#ifndef SCENE_BUILD_H
#define SCENE_BUILD_H

#include "scene.h"

/* Passes on the context's message with the scene's file, the band and the key (may be NULL) in
   front, which the library cannot know. */
murk_status scene_pass_on(murk_context *context, murk_status status,
                          const struct scene_description *description, const char *key,
                          char message[SCENE_MESSAGE_SIZE]);

/* The same place for a message of one's own; MURK_ERROR_INPUT. */
murk_status scene_refuse(const struct scene_description *description, const char *key,
                         const char *text, char message[SCENE_MESSAGE_SIZE]);

/* The medium of the band, and its mass extinction coefficient. */
murk_status scene_build_medium(murk_context *context, const struct scene_description *description,
                               const murk_volume *volume, struct scene_band *band,
                               char message[SCENE_MESSAGE_SIZE]);

/* Whether anything shines by what a description itself says. */
bool scene_has_light(const struct scene_description *description);

/* Sun and sky: those of the description, or of murk_scene_default() where nothing is lit, with its
   ground where the description names none. */
murk_status scene_build_light(murk_context *context, const struct scene_description *description,
                              bool lit, struct scene_band *band, char message[SCENE_MESSAGE_SIZE]);

/* The ground that the description names, if it does. */
murk_status scene_build_ground(murk_context *context, const struct scene_description *description,
                               struct scene_band *band, char message[SCENE_MESSAGE_SIZE]);

#endif
