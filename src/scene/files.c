/* SPDX-License-Identifier: Apache-2.0 */
/* The files that a description names. */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *scene_path(const struct scene_description *description, const char *file)
{
    const char *folder = description->folder ? description->folder : "";
    if (*file == '/' || !strcmp(file, "-"))
        folder = "";
    size_t size = strlen(folder) + strlen(file) + 1;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s%s", folder, file);
    return path;
}

size_t scene_files(struct scene_description *description, const char **files[SCENE_FILE_MAX])
{
    const char **all[SCENE_FILE_MAX] = {&description->medium_file, &description->reflectance_image,
                                        &description->emission_image, &description->background};
    size_t count = 0;
    for (size_t i = 0; i < SCENE_FILE_MAX; i++)
        if (*all[i] && strcmp(*all[i], "none"))
            files[count++] = all[i];
    return count;
}
