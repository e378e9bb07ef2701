/* SPDX-License-Identifier: Apache-2.0 */
/* The camera and the lights of a USD stage. */
#ifndef CLI_USD_LIGHT_H
#define CLI_USD_LIGHT_H

#include "scene.h"

#include <stdio.h>

/* Writes the prim of a camera that murk_camera_check() takes. */
void cli_usd_camera(FILE *stream, const murk_camera *camera);

/* Writes the prims of sun and sky where they are not dark: for other things in the stage, since the
   radiosity holds their light already. */
void cli_usd_lights(FILE *stream, const struct scene *scene);

#endif
