/* SPDX-License-Identifier: Apache-2.0 */
/* The medium of a scene file. */
#include "parse.h"

bool scene_read_extinction(struct scene_reader *reader, const json_t *value, void *field,
                           const struct scene_key *key)
{
    struct scene_description *description = field;
    description->mass_extinction = NAN;
    description->obscurant = NULL;
    description->medium.extinction = (murk_quantity){NULL, 0.0, MURK_FROM_GRID};
    return scene_read_quantity(reader, value, &description->medium.extinction, key);
}

bool scene_read_mass_extinction(struct scene_reader *reader, const json_t *value, void *field,
                                const struct scene_key *key)
{
    struct scene_description *description = field;
    description->obscurant = NULL;
    return scene_read_number(reader, value, &description->mass_extinction, key);
}

static bool read_concentration(struct scene_reader *reader, const json_t *value, void *field,
                               const struct scene_key *key)
{
    struct scene_description *description = field;
    description->has_concentration = true;
    return scene_read_quantity(reader, value, &description->concentration, key);
}

static bool read_temperature(struct scene_reader *reader, const json_t *value, void *field,
                             const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"grid", scene_read_text, .offset = offsetof(murk_medium_options, temperature.grid)},
        {"scale", scene_read_number, .offset = offsetof(murk_medium_options, temperature.scale),
         POSITIVE},
        {"offset", scene_read_number, .offset = offsetof(murk_medium_options, temperature_offset),
         .min = -INFINITY, .max = INFINITY, .range = "a number [K]"},
    };
    murk_medium_options *medium = field;
    if (!json_is_object(value))
        return scene_read_quantity(reader, value, &medium->temperature, key);
    if (!json_object_get(value, "grid"))
        return scene_fail(reader, "has no \"grid\"; give one, or a number in kelvin");
    medium->temperature.scale = 1;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), medium);
}

bool scene_read_medium(struct scene_reader *reader, const json_t *value, void *field,
                       const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"file", scene_read_text, FIELD(medium_file)},
        {"extinction", scene_read_extinction, WHOLE, EXTINCTION_RANGE},
        {"mass_extinction", scene_read_mass_extinction, WHOLE, POSITIVE},
        {"concentration", read_concentration, WHOLE, NOT_NEGATIVE},
        {"obscurant", scene_read_text, FIELD(obscurant)},
        {"albedo", scene_read_quantity, FIELD(medium.albedo), .min = 0.0, .max = 1.0,
         .range = "between 0 and 1"},
        {"asymmetry", scene_read_number, FIELD(medium.asymmetry), ASYMMETRY_RANGE},
        {"emission", scene_read_quantity, FIELD(medium.emission), NOT_NEGATIVE},
        {"temperature", read_temperature, FIELD(medium), KELVIN},
        {"voxels", scene_read_voxels, FIELD(medium.corner)},
        {"voxel_size", scene_read_number, FIELD(medium.voxel_size), .min = 0.0, .max = INFINITY,
         .open = true, .range = "a positive number [m]"},
        {"strict", scene_read_bool, FIELD(medium.strict)},
    };
    (void)key;
    static const char *const OPTICS[] = {"extinction", "mass_extinction", "obscurant"};
    int given = 0;
    for (size_t i = 0; i < COUNT(OPTICS); i++)
        given += json_object_get(value, OPTICS[i]) != NULL;
    if (given > 1)
        return scene_fail(reader,
                          "takes one of \"extinction\", \"mass_extinction\" and \"obscurant\"");
    struct scene_description *description = field;
    description->albedo_named = json_object_get(value, "albedo") != NULL;
    description->asymmetry_named = json_object_get(value, "asymmetry") != NULL;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), field);
}
