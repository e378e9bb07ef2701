/* SPDX-License-Identifier: Apache-2.0 */
/* The keys of a scene file. */
#include "parse.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool scene_read_voxels(struct scene_reader *reader, const json_t *value, void *field,
                       const struct scene_key *key)
{
    (void)key;
    const char *text = json_string_value(value);
    if (!text || (strcmp(text, "center") && strcmp(text, "corner")))
        return scene_fail(reader, "not \"center\" or \"corner\"");
    *(bool *)field = !strcmp(text, "corner");
    return true;
}

static bool read_up(struct scene_reader *reader, const json_t *value, void *field,
                    const struct scene_key *key)
{
    (void)key;
    const char *text = json_string_value(value);
    if (!text || (strcmp(text, "z") && strcmp(text, "y")))
        return scene_fail(reader, "not \"z\" or \"y\"");
    *(murk_up *)field = *text == 'y' ? MURK_UP_Y : MURK_UP_Z;
    return true;
}

static bool read_direction(struct scene_reader *reader, const json_t *value, void *field,
                           const struct scene_key *key)
{
    const double *d = field;
    if (!scene_read_vector(reader, value, field, key))
        return false;
    if (d[0] == 0.0 && d[1] == 0.0 && d[2] == 0.0)
        return scene_fail(reader, "[0, 0, 0] is no direction of travel");
    return true;
}

bool scene_read_sun(struct scene_reader *reader, const json_t *value, void *field,
                    const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"direction", read_direction, FIELD(sun.direction)},
        {"irradiance", scene_read_number, FIELD(sun.irradiance), NOT_NEGATIVE},
        {"temperature", scene_read_number, FIELD(sun_temperature), KELVIN},
    };
    (void)key;
    struct scene_description *description = field;
    if (json_object_get(value, "irradiance") && json_object_get(value, "temperature"))
        return scene_fail(reader,
                          "has an irradiance and a temperature; one follows from the other");
    if (json_object_get(value, "irradiance"))
        description->sun_temperature = NAN;
    description->sun_named = true;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), field);
}

bool scene_read_sky(struct scene_reader *reader, const json_t *value, void *field,
                    const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"radiance", scene_read_number, FIELD(sky_radiance), NOT_NEGATIVE},
        {"temperature", scene_read_number, FIELD(sky_temperature), KELVIN},
    };
    (void)key;
    struct scene_description *description = field;
    if (json_object_get(value, "radiance") && !json_object_get(value, "temperature"))
        description->sky_temperature = NAN;
    description->sky_named = true;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), field);
}

/* A number in range or, in the text before it, the path of an image. */
static bool number_or_image(struct scene_reader *reader, const json_t *value, double *number,
                            const char **image, const struct scene_key *key)
{
    if (json_is_string(value))
        return scene_read_text(reader, value, image, key);
    if (json_is_number(value))
        return scene_read_number(reader, value, number, key);
    return scene_fail(reader, "not a number or the path of an image");
}

static bool read_reflectance(struct scene_reader *reader, const json_t *value, void *field,
                             const struct scene_key *key)
{
    struct scene_description *description = field;
    return number_or_image(reader, value, &description->ground.reflectance,
                           &description->reflectance_image, key);
}

static bool read_emission(struct scene_reader *reader, const json_t *value, void *field,
                          const struct scene_key *key)
{
    struct scene_description *description = field;
    return number_or_image(reader, value, &description->ground.emission,
                           &description->emission_image, key);
}

static bool read_temperature(struct scene_reader *reader, const json_t *value, void *field,
                             const struct scene_key *key)
{
    struct scene_description *description = field;
    return number_or_image(reader, value, &description->ground_temperature,
                           &description->temperature_image, key);
}

static bool read_extent(struct scene_reader *reader, const json_t *value, void *field,
                        const struct scene_key *key)
{
    murk_ground_options *ground = field;
    if (!json_is_array(value) || json_array_size(value) != 2)
        return scene_fail(reader, "not two corners [[a, b], [a, b]]");
    if (!scene_read_pair(reader, json_array_get(value, 0), ground->extent_min, key) ||
        !scene_read_pair(reader, json_array_get(value, 1), ground->extent_max, key))
        return false;
    for (int i = 0; i < 2; i++)
        if (!(ground->extent_min[i] < ground->extent_max[i]))
            return scene_fail(reader, "from %g to %g is no extent: the low corner comes first",
                              ground->extent_min[i], ground->extent_max[i]);
    return true;
}

bool scene_read_ground(struct scene_reader *reader, const json_t *value, void *field,
                       const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"height", scene_read_number, FIELD(ground.height), .min = -INFINITY, .max = INFINITY},
        {"extent", read_extent, FIELD(ground)},
        {"patches", scene_read_size, FIELD(ground.patches), .min = 1.0, .max = 65536.0,
         .range = "two whole numbers of patches, each at least 1"},
        {"reflectance", read_reflectance, .min = 0.0, .max = 1.0, .range = "between 0 and 1"},
        {"emission", read_emission, NOT_NEGATIVE},
        {"temperature", read_temperature, KELVIN},
        {"horizon", scene_read_bool, FIELD(ground.horizon)},
    };
    (void)key;
    ((struct scene_description *)field)->ground_named = true;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), field);
}

static bool read_camera(struct scene_reader *reader, const json_t *value, void *field,
                        const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {"eye", scene_read_vector, FIELD(camera.eye)},
        {"target", scene_read_vector, FIELD(camera.target)},
        {"up", scene_read_vector, FIELD(camera.up)},
        {"fov", scene_read_number, FIELD(camera.fov), .min = 0.0, .max = 180.0, .open = true,
         .range = "between 0 and 180 degrees"},
        {"size", scene_read_size, FIELD(camera.size), .min = 1.0, .max = 65536.0,
         .range = "a width and height of 1 to 65536 pixels"},
    };
    (void)key;
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), field);
}

static bool read_scene(struct scene_reader *reader, const json_t *root,
                       struct scene_description *description)
{
    static const struct scene_key KEYS[] = {
        {"medium", scene_read_medium, WHOLE}, {"sun", scene_read_sun, WHOLE},
        {"sky", scene_read_sky, WHOLE},       {"ground", scene_read_ground, WHOLE},
        {"up", read_up, FIELD(up)},           {"voxels", scene_read_voxels, FIELD(medium.corner)},
        {"camera", read_camera, WHOLE},       {"background", scene_read_text, FIELD(background)},
        {"bands", scene_skip, WHOLE},
    };
    if (!scene_read_object(reader, root, KEYS, COUNT(KEYS), description))
        return false;
    if (!description->medium_file)
        return scene_fail(reader, "no \"medium\" with a \"file\": {\"medium\": {\"file\": "
                                  "\"plume.vdb\"}} is the least");
    return scene_read_bands(reader, root, description); /* last: they start from all the rest */
}

void scene_describe_volume(const char *medium_file, struct scene_description *out)
{
    const murk_medium_options medium = MURK_MEDIUM_DEFAULT;
    const murk_ground_options ground = MURK_GROUND_DEFAULT;
    *out = (struct scene_description){
        .medium_file = medium_file,
        .medium = medium,
        .sun = {{NAN, NAN, NAN}, NAN},
        .sky_radiance = NAN,
        .concentration = {NULL, 1.0, MURK_FROM_GRID},
        .mass_extinction = NAN,
        .sun_temperature = NAN,
        .sky_temperature = NAN,
        .ground_temperature = NAN,
        .ground = ground,
        .up = MURK_UP_Z,
        .camera = {{NAN, NAN, NAN}, {NAN, NAN, NAN}, {NAN, NAN, NAN}, NAN, {0, 0}, 0},
    };
    out->ground.height = NAN;
    out->ground.patches[0] = out->ground.patches[1] = 0;
    for (int i = 0; i < 2; i++)
        out->ground.extent_min[i] = out->ground.extent_max[i] = 0.0;
}

murk_status scene_parse(const char *path, struct scene_description *out,
                        char message[SCENE_MESSAGE_SIZE])
{
    struct scene_description description;
    struct scene_reader reader = {.file = path, .message = message};
    scene_describe_volume(NULL, &description);
    description.path = path;
    description.root = scene_load(path, message);
    if (!description.root)
        return MURK_ERROR_INPUT;
    const char *slash = strrchr(path, '/');
    description.folder = strndup(path, slash ? (size_t)(slash - path) + 1 : 0);
    if (!description.folder || !read_scene(&reader, description.root, &description)) {
        if (!description.folder)
            snprintf(message, SCENE_MESSAGE_SIZE, "%s: out of memory", path);
        murk_status status = description.folder ? MURK_ERROR_INPUT : MURK_ERROR_MEMORY;
        scene_description_release(&description);
        return status;
    }
    *out = description;
    return MURK_OK;
}

void scene_description_release(struct scene_description *description)
{
    json_decref(description->root);
    free(description->folder);
    free(description->band);
    *description = (struct scene_description){0};
}
