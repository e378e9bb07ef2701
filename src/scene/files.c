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

size_t scene_bands(struct scene_description *description, struct scene_description **bands)
{
    *bands = description->band_count ? description->band : description;
    return description->band_count ? description->band_count : 1;
}

static size_t take(const char **text, const char **files[SCENE_FILE_MAX], size_t count)
{
    if (*text && strcmp(*text, "none"))
        files[count++] = text;
    return count;
}

size_t scene_files(struct scene_description *description, const char **files[SCENE_FILE_MAX])
{
    struct scene_description *bands;
    size_t count = take(&description->medium_file, files, 0);
    count = take(&description->background, files, count);
    for (size_t n = scene_bands(description, &bands); n-- > 0;) {
        count = take(&bands[n].obscurant, files, count);
        count = take(&bands[n].reflectance_image, files, count);
        count = take(&bands[n].emission_image, files, count);
        count = take(&bands[n].temperature_image, files, count);
    }
    return count;
}
