/* SPDX-License-Identifier: Apache-2.0 */
/* The objects of a scene file, for tables of keys of struct scene_description. */
#ifndef SCENE_PARSE_H
#define SCENE_PARSE_H

#include "keys.h"

#include <math.h>

#define COUNT(table) (sizeof(table) / sizeof *(table))
#define FIELD(name)  .offset = offsetof(struct scene_description, name)
#define WHOLE        .offset = 0
#define NOT_NEGATIVE .min = 0.0, .max = INFINITY, .range = "a number >= 0"
#define POSITIVE     .min = 0.0, .max = INFINITY, .open = true, .range = "a positive number"
#define KELVIN       .min = 0.0, .max = 1e8, .open = true, .range = "a temperature in kelvin"

/* Each takes the description itself as its field. */
scene_read_fn scene_read_medium, scene_read_sun, scene_read_sky, scene_read_ground;

/* The optical properties, where medium and bands have them. */
scene_read_fn scene_read_extinction, scene_read_mass_extinction;
#define ASYMMETRY_RANGE  .min = -1.0, .max = 1.0, .open = true, .range = "between -1 and 1"
#define EXTINCTION_RANGE .min = 0.0, .max = INFINITY, .range = "a number >= 0 [1/m]"

scene_read_fn scene_read_voxels; /* bool: corner */
scene_read_fn scene_skip;        /* is read by others */

/* Sets the wavelengths of a band whose name says where it is; false for any other. */
bool scene_known_band(const char *name, murk_band *out);

/* The bands of the scene that root is, after everything else. */
bool scene_read_bands(struct scene_reader *reader, const json_t *root,
                      struct scene_description *description);

#endif
