/* SPDX-License-Identifier: Apache-2.0 */
/* The scene file, from bytes to its description and the bands chosen of it. */
#define _GNU_SOURCE /* memfd_create */
#include "fuzz.h"
#include "scene.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static void parse(const char *path)
{
    struct scene_description description;
    struct scene_description *bands;
    const char **files[SCENE_FILE_MAX];
    char message[SCENE_MESSAGE_SIZE] = "";
    if (scene_parse(path, &description, message)) {
        assert(*message && !strchr(message, '\n'));
        return;
    }
    scene_choose_bands(&description, "LWIR,R", message);
    scene_bands(&description, &bands);
    assert(scene_files(&description, files) <= SCENE_FILE_MAX);
    scene_description_release(&description);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char path[64];
    const int file = memfd_create("scene", MFD_CLOEXEC);
    if (file < 0)
        return 0;
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    if (write(file, bytes, size) == (ssize_t)size)
        parse(path);
    close(file);
    return 0;
}
