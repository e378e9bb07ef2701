/* SPDX-License-Identifier: Apache-2.0 */
/* From a description to the objects of a scene. */
#include "pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool open_vector(const double vector[3])
{
    return isnan(vector[0]);
}

/* Passes on the context's message with the scene's key in front, which the library cannot know. */
static murk_status pass_on(murk_context *context, murk_status status,
                           const struct scene_description *description, const char *key,
                           char *message)
{
    if (status == MURK_OK)
        return status;
    if (description->path && key)
        snprintf(message, SCENE_MESSAGE_SIZE, "%s: %s: %s", description->path, key,
                 murk_context_message(context));
    else
        snprintf(message, SCENE_MESSAGE_SIZE, "%s", murk_context_message(context));
    return status;
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
    return pass_on(context, status, description, "medium.file", message);
}

/* Whether anything shines by what the description itself says. */
static bool has_light(const struct scene_description *description)
{
    return description->sun_named || description->sky_named || description->medium.emission.grid ||
           description->medium.emission.value > 0.0 || description->emission_image ||
           description->ground.emission > 0.0;
}

static murk_status build_light(murk_context *context, const struct scene_description *description,
                               struct scene *scene, char *message)
{
    bool lit = has_light(description);
    murk_scene *target = &scene->scene, fallback = {0};
    murk_sun sun = description->sun;
    if (!lit || description->sun_named || description->sky_named) {
        murk_ground *ground = NULL;
        murk_status status =
            murk_scene_default(context, scene->medium, description->up, &fallback, &ground);
        if (status != MURK_OK)
            return pass_on(context, status, description, NULL, message);
        if (!lit && !description->ground_named)
            scene->ground = ground;
        else
            murk_ground_release(ground);
    }
    if (open_vector(sun.direction))
        memcpy(sun.direction, fallback.sun.direction, sizeof sun.direction);
    if (isnan(sun.irradiance))
        sun.irradiance = fallback.sun.irradiance;
    target->medium = scene->medium;
    target->ground = scene->ground;
    if (!lit || description->sun_named)
        target->sun = sun;
    if (!lit || description->sky_named)
        target->sky_radiance =
            isnan(description->sky_radiance) ? fallback.sky_radiance : description->sky_radiance;
    return MURK_OK;
}

static murk_status create_ground(murk_context *context, const struct scene_description *description,
                                 struct scene *scene, float **reflectance, float **emission,
                                 char *message)
{
    murk_ground_options options = description->ground;
    murk_status status = MURK_OK;
    options.up = description->up;
    if (isnan(options.height)) {
        murk_medium_info info;
        status = murk_medium_info_get(scene->medium, &info);
        options.height = info.box_min[description->up == MURK_UP_Y ? 1 : 2];
    }
    if (status == MURK_OK && description->reflectance_image)
        status = scene_read_pixels(context, description, "ground.reflectance",
                                   description->reflectance_image, 1.0, options.patches,
                                   reflectance, message);
    if (status == MURK_OK && description->emission_image)
        status =
            scene_read_pixels(context, description, "ground.emission", description->emission_image,
                              INFINITY, options.patches, emission, message);
    if (status != MURK_OK)
        return status;
    options.reflectance_image = *reflectance;
    options.emission_image = *emission;
    status = murk_ground_fit(context, scene->medium, &scene->scene.sun, &options);
    if (status == MURK_OK)
        status = murk_ground_create(context, &options, &scene->ground);
    scene->scene.ground = scene->ground;
    return pass_on(context, status, description, "ground", message);
}

static murk_status build_ground(murk_context *context, const struct scene_description *description,
                                struct scene *scene, char *message)
{
    float *reflectance = NULL, *emission = NULL;
    if (!description->ground_named)
        return MURK_OK;
    murk_status status =
        create_ground(context, description, scene, &reflectance, &emission, message);
    free(reflectance);
    free(emission);
    return status;
}

static murk_status build_camera(murk_context *context, const struct scene_description *description,
                                struct scene *scene, char *message)
{
    const murk_camera *given = &description->camera;
    murk_camera *camera = &scene->camera;
    murk_status status = murk_camera_default(context, &scene->scene, camera);
    if (status != MURK_OK)
        return pass_on(context, status, description, "camera", message);
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
    return pass_on(context, status, description, "background", message);
}

murk_status scene_build(murk_context *context, const struct scene_description *description,
                        struct scene *scene, char message[SCENE_MESSAGE_SIZE])
{
    murk_status status =
        murk_medium_from_volume(context, scene->volume, &description->medium, &scene->medium);
    if (status != MURK_OK)
        return pass_on(context, status, description, "medium", message);
    status = build_light(context, description, scene, message);
    if (status == MURK_OK)
        status = build_ground(context, description, scene, message);
    if (status == MURK_OK)
        status = build_camera(context, description, scene, message);
    if (status == MURK_OK)
        status = build_background(context, description, scene, message);
    return status;
}

void scene_release(struct scene *scene)
{
    murk_image_release(scene->background);
    murk_ground_release(scene->ground);
    murk_medium_release(scene->medium);
    murk_volume_release(scene->volume);
    *scene = (struct scene){0};
}
