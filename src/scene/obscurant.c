/* SPDX-License-Identifier: Apache-2.0 */
#include "obscurant.h"

#include "keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(table) (sizeof(table) / sizeof *(table))
#define FIELD(name)  .offset = offsetof(struct content, name)

/* What the keys name, as JSON: numbers, or arrays of them. */
struct content {
    const char *name, *source;
    const json_t *wavelength, *mass_extinction, *albedo, *asymmetry;
};

/* A finite number, or an array of such, all in the key's range. */
static bool read_list(struct scene_reader *reader, const json_t *value, void *field,
                      const struct scene_key *key)
{
    double number;
    size_t length = strlen(reader->path);
    if (!json_is_array(value)) {
        if (!json_is_number(value))
            return scene_fail(reader, "not a number or an array of numbers");
        if (!scene_read_number(reader, value, &number, key))
            return false;
    } else if (json_array_size(value) == 0) {
        return scene_fail(reader, "is empty: needs one number at least");
    }
    for (size_t i = 0; i < json_array_size(value); i++) {
        snprintf(reader->path + length, sizeof reader->path - length, "[%zu]", i);
        if (!scene_read_number(reader, json_array_get(value, i), &number, key))
            return false;
    }
    reader->path[length] = '\0';
    *(const json_t **)field = value;
    return true;
}

static bool read_content(struct scene_reader *reader, const json_t *root, struct content *out)
{
    static const struct scene_key KEYS[] = {
        {"name", scene_read_text, FIELD(name)},
        {"source", scene_read_text, FIELD(source)},
        {"wavelength", read_list, FIELD(wavelength), .min = 1e-8, .max = 1e-2,
         .range = "between 1e-8 and 0.01 metres (0.55 um is 5.5e-7)"},
        {"mass_extinction", read_list, FIELD(mass_extinction), .min = 0.0, .max = 1e9,
         .range = "a number >= 0 [m^2/g]"},
        {"albedo", read_list, FIELD(albedo), .min = 0.0, .max = 1.0, .range = "between 0 and 1"},
        {"asymmetry", read_list, FIELD(asymmetry), .min = -1.0, .max = 1.0, .open = true,
         .range = "between -1 and 1, both excluded"},
    };
    if (!scene_read_object(reader, root, KEYS, COUNT(KEYS), out))
        return false;
    const json_t *const needed[] = {out->wavelength, out->mass_extinction, out->albedo,
                                    out->asymmetry};
    for (size_t i = 0; i < COUNT(needed); i++)
        if (!needed[i])
            return scene_fail(reader,
                              "no \"%s\": an obscurant needs \"wavelength\" [m], "
                              "\"mass_extinction\" [m^2/g], \"albedo\" and \"asymmetry\"",
                              KEYS[i + 2].name);
    return true;
}

static bool fail_at(struct scene_reader *reader, const char *key, const char *text)
{
    snprintf(reader->path, sizeof reader->path, "%s", key);
    return scene_fail(reader, "%s", text);
}

/* The i-th number of a list, or the one that is there for all. */
static double number(const json_t *list, size_t i)
{
    return json_number_value(json_is_array(list) ? json_array_get(list, i) : list);
}

static bool check_lengths(struct scene_reader *reader, const struct content *content, size_t count)
{
    const struct {
        const char *key;
        const json_t *list;
    } all[] = {{"mass_extinction", content->mass_extinction},
               {"albedo", content->albedo},
               {"asymmetry", content->asymmetry}};
    for (size_t i = 0; i < COUNT(all); i++) {
        char text[120];
        size_t has = json_array_size(all[i].list);
        snprintf(text, sizeof text,
                 "%zu numbers for %zu wavelengths: needs as many, or one number for all", has,
                 count);
        if (json_is_array(all[i].list) && has != count)
            return fail_at(reader, all[i].key, text);
    }
    for (size_t i = 1; i < count; i++)
        if (!(number(content->wavelength, i) > number(content->wavelength, i - 1)))
            return fail_at(reader, "wavelength", "has to ascend, from the shortest to the longest");
    return true;
}

/* NULL stays NULL. */
static bool copy(const char *text, char **out)
{
    *out = text ? strdup(text) : NULL;
    return *out || !text;
}

static bool keep(struct scene_reader *reader, const struct content *content, size_t count,
                 struct scene_obscurant *out)
{
    out->wavelength = malloc(count * sizeof *out->wavelength);
    out->optics = malloc(count * sizeof *out->optics);
    if (!out->wavelength || !out->optics || !copy(reader->file, &out->path) ||
        !copy(content->name, &out->name) || !copy(content->source, &out->source))
        return scene_fail(reader, "out of memory");
    out->count = count;
    for (size_t i = 0; i < count; i++) {
        out->wavelength[i] = number(content->wavelength, i);
        out->optics[i] =
            (struct scene_optics){.mass_extinction = number(content->mass_extinction, i),
                                  .albedo = number(content->albedo, i),
                                  .asymmetry = number(content->asymmetry, i)};
    }
    return true;
}

static murk_status read_root(struct scene_reader *reader, const json_t *root,
                             struct scene_obscurant *out)
{
    struct content content = {0};
    struct scene_obscurant obscurant = {0};
    if (!read_content(reader, root, &content))
        return MURK_ERROR_INPUT;
    size_t count = json_is_array(content.wavelength) ? json_array_size(content.wavelength) : 1;
    if (!check_lengths(reader, &content, count))
        return MURK_ERROR_INPUT;
    if (!keep(reader, &content, count, &obscurant)) {
        scene_obscurant_release(&obscurant);
        return MURK_ERROR_MEMORY;
    }
    *out = obscurant;
    return MURK_OK;
}

murk_status scene_obscurant_read(const char *path, struct scene_obscurant *out,
                                 char message[SCENE_MESSAGE_SIZE])
{
    struct scene_reader reader = {.file = path, .message = message};
    json_t *root = scene_load(path, message);
    if (!root)
        return MURK_ERROR_INPUT;
    murk_status status = read_root(&reader, root, out);
    json_decref(root);
    return status;
}

void scene_obscurant_release(struct scene_obscurant *obscurant)
{
    free(obscurant->path);
    free(obscurant->name);
    free(obscurant->source);
    free(obscurant->wavelength);
    free(obscurant->optics);
    *obscurant = (struct scene_obscurant){0};
}
