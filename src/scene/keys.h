/* SPDX-License-Identifier: Apache-2.0 */
/* Tables of JSON keys: one row says a key's name, type, range and where its value goes. */
#ifndef SCENE_KEYS_H
#define SCENE_KEYS_H

#include "scene.h"

#include <jansson.h>

/* Where the reader is, for messages. */
struct scene_reader {
    const char *file;
    char path[256]; /* "camera.fov" */
    char *message;  /* SCENE_MESSAGE_SIZE */
};

struct scene_key;
typedef bool scene_read_fn(struct scene_reader *reader, const json_t *value, void *field,
                           const struct scene_key *key);

struct scene_key {
    const char *name;
    scene_read_fn *read;
    size_t offset; /* of the field in the table's struct */
    double min, max;
    bool open;         /* min and max themselves are out of range */
    const char *range; /* the same in words: "between 0 and 180 degrees" */
};

/* The JSON of a file, to be released with json_decref(); NULL with one line in message where it
   cannot be read. */
json_t *scene_load(const char *path, char message[SCENE_MESSAGE_SIZE]);

/* Reads every key of object into the struct at base; an unknown key is an error. null is absent.
   False with the message written where something is wrong. */
bool scene_read_object(struct scene_reader *reader, const json_t *object,
                       const struct scene_key *keys, size_t count, void *base);

/* Readers of values. */
scene_read_fn scene_read_number;   /* double */
scene_read_fn scene_read_size;     /* int[2] */
scene_read_fn scene_read_pair;     /* double[2] */
scene_read_fn scene_read_vector;   /* double[3] */
scene_read_fn scene_read_bool;     /* bool */
scene_read_fn scene_read_text;     /* const char * */
scene_read_fn scene_read_quantity; /* murk_quantity */

/* Writes the one line "file: path: ..." and gives back false. */
bool scene_fail(struct scene_reader *reader, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
