/* SPDX-License-Identifier: Apache-2.0 */
/* From a description to the objects of a scene. */
#include "build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool open_vector(const double vector[3])
{
    return isnan(vector[0]);
}

static void write_place(const struct scene_description *description, const char *key,
                        const char *text, char message[SCENE_MESSAGE_SIZE])
{
    const char *path = description->path && key ? description->path : "";
    const char *name = *path && description->name ? description->name : "";
    snprintf(message, SCENE_MESSAGE_SIZE, "%s%s%s%s%s%s%s", path, *path ? ": " : "",
             *name ? "band " : "", name, *name ? ": " : "", *path ? key : "", *path ? ": " : "");
    size_t used = strlen(message);
    snprintf(message + used, SCENE_MESSAGE_SIZE - used, "%s", text);
}

murk_status scene_pass_on(murk_context *context, murk_status status,
                          const struct scene_description *description, const char *key,
                          char message[SCENE_MESSAGE_SIZE])
{
    if (status != MURK_OK)
        write_place(description, key, murk_context_message(context), message);
    return status;
}

murk_status scene_refuse(const struct scene_description *description, const char *key,
                         const char *text, char message[SCENE_MESSAGE_SIZE])
{
    if (description->path)
        write_place(description, key, text, message);
    else
        snprintf(message, SCENE_MESSAGE_SIZE, "%s: %s", key, text);
    return MURK_ERROR_INPUT;
}

murk_status scene_read_volume(murk_context *context, const struct scene_description *description,
                              struct scene *scene, char message[SCENE_MESSAGE_SIZE])
{
    char *path = scene_path(description, description->medium_file);
    if (!path) {
        snprintf(message, SCENE_MESSAGE_SIZE, "out of memory");
        return MURK_ERROR_MEMORY;
    }
    murk_status status = murk_volume_read(context, path, &scene->volume);
    free(path);
    return scene_pass_on(context, status, description, "medium.file", message);
}

static murk_status build_camera(murk_context *context, const struct scene_description *description,
                                struct scene *scene, char *message)
{
    const murk_camera *given = &description->camera;
    murk_camera *camera = &scene->camera;
    murk_status status = murk_camera_default(context, &scene->band[0].scene, camera);
    if (status != MURK_OK)
        return scene_pass_on(context, status, description, "camera", message);
    if (!open_vector(given->eye))
        memcpy(camera->eye, given->eye, sizeof camera->eye);
    if (!open_vector(given->target))
        memcpy(camera->target, given->target, sizeof camera->target);
    double up[3] = {0.0, description->up == MURK_UP_Y, description->up == MURK_UP_Z};
    memcpy(camera->up, open_vector(given->up) ? up : given->up, sizeof camera->up);
    if (!isnan(given->fov))
        camera->fov = given->fov;
    if (given->size[0] > 0)
        memcpy(camera->size, given->size, sizeof camera->size);
    if (!memcmp(camera->eye, camera->target, sizeof camera->eye)) {
        snprintf(message, SCENE_MESSAGE_SIZE, "%s%scamera: eye and target are the same point",
                 description->path ? description->path : "", description->path ? ": " : "");
        return MURK_ERROR_INPUT;
    }
    return MURK_OK;
}

static murk_status build_background(murk_context *context,
                                    const struct scene_description *description,
                                    struct scene *scene, char *message)
{
    if (!description->background)
        return MURK_OK;
    if (!strcmp(description->background, "none")) {
        scene->no_background = true;
        return MURK_OK;
    }
    char *path = scene_path(description, description->background);
    if (!path) {
        snprintf(message, SCENE_MESSAGE_SIZE, "out of memory");
        return MURK_ERROR_MEMORY;
    }
    murk_status status = murk_image_read(context, path, &scene->background);
    free(path);
    return scene_pass_on(context, status, description, "background", message);
}

static murk_status build_band(murk_context *context, const struct scene_description *description,
                              const struct scene *scene, bool lit, struct scene_band *band,
                              char *message)
{
    band->name = description->name;
    band->band = description->wavelength;
    murk_status status = scene_build_medium(context, description, scene->volume, band, message);
    if (status == MURK_OK)
        status = scene_build_light(context, description, lit, band, message);
    if (status == MURK_OK)
        status = scene_build_ground(context, description, band, message);
    return status;
}

static bool needs_bands(const struct scene_description *description)
{
    return description->medium.temperature.grid || description->medium.temperature.value > 0.0 ||
           !isnan(description->sun_temperature) || !isnan(description->sky_temperature) ||
           !isnan(description->ground_temperature) || description->temperature_image ||
           description->obscurant;
}

murk_status scene_build(murk_context *context, struct scene_description *description,
                        struct scene *scene, char message[SCENE_MESSAGE_SIZE])
{
    struct scene_description *bands;
    murk_status status = MURK_OK;
    bool lit = false;
    if (!description->band_count && needs_bands(description))
        return scene_refuse(description, "bands",
                            "temperatures and obscurants need bands to act in: [{\"name\": "
                            "\"LWIR\", \"wavelength\": [8e-6, 12e-6]}]",
                            message);
    scene->band_count = scene_bands(description, &bands);
    for (size_t n = 0; n < scene->band_count; n++)
        lit = lit || scene_has_light(&bands[n]);
    for (size_t n = 0; n < scene->band_count && status == MURK_OK; n++)
        status = build_band(context, &bands[n], scene, lit, &scene->band[n], message);
    if (status == MURK_OK)
        status = build_camera(context, description, scene, message);
    if (status == MURK_OK)
        status = build_background(context, description, scene, message);
    return status;
}

void scene_release(struct scene *scene)
{
    murk_image_release(scene->background);
    for (size_t n = 0; n < scene->band_count; n++) {
        murk_ground_release(scene->band[n].ground);
        murk_medium_release(scene->band[n].medium);
    }
    murk_volume_release(scene->volume);
    *scene = (struct scene){0};
}
