/* SPDX-License-Identifier: Apache-2.0 */
#include "keys.h"

#include "nearest.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool scene_fail(struct scene_reader *reader, const char *format, ...)
{
    va_list arguments;
    int used = snprintf(reader->message, SCENE_MESSAGE_SIZE, "%s: %s%s", reader->file, reader->path,
                        *reader->path ? ": " : "");
    if (used >= 0 && used < SCENE_MESSAGE_SIZE) {
        va_start(arguments, format);
        vsnprintf(reader->message + used, SCENE_MESSAGE_SIZE - (size_t)used, format, arguments);
        va_end(arguments);
    }
    for (char *c = reader->message; *c; c++) /* a key may hold a line feed; a message is one line */
        if ((unsigned char)*c < ' ')
            *c = '?';
    return false;
}

static bool unknown_key(struct scene_reader *reader, const char *name, const struct scene_key *keys,
                        size_t count)
{
    struct murk_nearest nearest = {0};
    for (size_t i = 0; i < count; i++)
        murk_nearest_offer(&nearest, name, keys[i].name);
    return scene_fail(reader, "unknown key; the nearest known one is \"%s\"", nearest.word);
}

static bool read_key(struct scene_reader *reader, const char *name, const json_t *value,
                     const struct scene_key *keys, size_t count, void *base)
{
    for (size_t i = 0; i < count; i++)
        if (!strcmp(keys[i].name, name))
            return json_is_null(value) ||
                   keys[i].read(reader, value, (char *)base + keys[i].offset, &keys[i]);
    return unknown_key(reader, name, keys, count);
}

bool scene_read_object(struct scene_reader *reader, const json_t *object,
                       const struct scene_key *keys, size_t count, void *base)
{
    if (!json_is_object(object))
        return scene_fail(reader, "not an object {...}");
    size_t length = strlen(reader->path);
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)object, name, value)
    {
        snprintf(reader->path + length, sizeof reader->path - length, "%s%s", length ? "." : "",
                 name);
        if (!read_key(reader, name, value, keys, count, base))
            return false;
        reader->path[length] = '\0';
    }
    return true;
}

static bool in_range(double value, const struct scene_key *key)
{
    return key->open ? value > key->min && value < key->max
                     : value >= key->min && value <= key->max;
}

bool scene_read_number(struct scene_reader *reader, const json_t *value, void *field,
                       const struct scene_key *key)
{
    if (!json_is_number(value))
        return scene_fail(reader, "not a number");
    double number = json_number_value(value);
    if (!in_range(number, key))
        return scene_fail(reader, "%g is not %s", number, key->range);
    *(double *)field = number;
    return true;
}

static bool read_numbers(struct scene_reader *reader, const json_t *value, double *field,
                         size_t count)
{
    bool good = json_is_array(value) && json_array_size(value) == count;
    for (size_t i = 0; good && i < count; i++)
        good = json_is_number(json_array_get(value, i));
    if (!good)
        return scene_fail(reader, "not an array of %zu numbers", count);
    for (size_t i = 0; i < count; i++)
        field[i] = json_number_value(json_array_get(value, i));
    return true;
}

bool scene_read_pair(struct scene_reader *reader, const json_t *value, void *field,
                     const struct scene_key *key)
{
    (void)key;
    return read_numbers(reader, value, field, 2);
}

bool scene_read_vector(struct scene_reader *reader, const json_t *value, void *field,
                       const struct scene_key *key)
{
    (void)key;
    return read_numbers(reader, value, field, 3);
}

bool scene_read_size(struct scene_reader *reader, const json_t *value, void *field,
                     const struct scene_key *key)
{
    double size[2];
    if (!read_numbers(reader, value, size, 2))
        return false;
    for (int i = 0; i < 2; i++)
        if (!in_range(size[i], key) || size[i] != floor(size[i]))
            return scene_fail(reader, "[%g, %g] is not %s", size[0], size[1], key->range);
    ((int *)field)[0] = (int)size[0];
    ((int *)field)[1] = (int)size[1];
    return true;
}

bool scene_read_bool(struct scene_reader *reader, const json_t *value, void *field,
                     const struct scene_key *key)
{
    (void)key;
    if (!json_is_boolean(value))
        return scene_fail(reader, "not true or false");
    *(bool *)field = json_boolean_value(value);
    return true;
}

bool scene_read_text(struct scene_reader *reader, const json_t *value, void *field,
                     const struct scene_key *key)
{
    (void)key;
    if (!json_is_string(value) || !*json_string_value(value))
        return scene_fail(reader, "not a text in quotes");
    *(const char **)field = json_string_value(value);
    return true;
}

bool scene_read_quantity(struct scene_reader *reader, const json_t *value, void *field,
                         const struct scene_key *key)
{
    static const struct scene_key KEYS[] = {
        {.name = "grid", .read = scene_read_text, .offset = offsetof(murk_quantity, grid)},
        {.name = "scale",
         .read = scene_read_number,
         .offset = offsetof(murk_quantity, scale),
         .min = 0.0,
         .max = INFINITY,
         .open = true,
         .range = "a positive number"},
    };
    murk_quantity *quantity = field;
    if (json_is_number(value))
        return scene_read_number(reader, value, &quantity->value, key);
    quantity->scale = 1; /* a grid that is named is taken as it is */
    if (json_is_string(value))
        return scene_read_text(reader, value, &quantity->grid, key);
    if (json_is_object(value))
        return scene_read_object(reader, value, KEYS, sizeof KEYS / sizeof *KEYS, quantity);
    return scene_fail(reader, "not a number, a grid name or {\"grid\", \"scale\"}");
}

json_t *scene_load(const char *path, char message[SCENE_MESSAGE_SIZE])
{
    json_error_t error;
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(message, SCENE_MESSAGE_SIZE, "%s: cannot read: %s", path, strerror(errno));
        return NULL;
    }
    json_t *root = json_loadf(file, JSON_REJECT_DUPLICATES, &error);
    fclose(file);
    if (!root)
        snprintf(message, SCENE_MESSAGE_SIZE, "%s:%d:%d: %s", path, error.line, error.column,
                 error.text);
    return root;
}
