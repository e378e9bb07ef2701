/* SPDX-License-Identifier: Apache-2.0 */
/* Pictures of smoke over a ground, one solution and two views: 03_render SMOKE.vdb LEFT RIGHT,
 * where LEFT and RIGHT are images to write, as .exr or .png. */
#include <murk/murk.h>

#include <stdio.h>

/* Everything the pictures need; zeroed members are released as nothing. */
struct stage {
    murk_volume *volume;
    murk_medium *medium;
    murk_ground *ground;
    murk_scene scene;
    murk_solution *solution;
};

static murk_status set(murk_context *context, const char *path, struct stage *stage)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction.scale = 20.0;
    options.corner = true;
    murk_status status = murk_volume_read(context, path, &stage->volume);
    if (!status)
        status = murk_medium_from_volume(context, stage->volume, &options, &stage->medium);
    /* A sun, a sky and a ground with a pattern of squares, chosen to suit the medium. */
    if (!status)
        status =
            murk_scene_default(context, stage->medium, MURK_UP_Z, &stage->scene, &stage->ground);
    if (!status)
        status = murk_solve(context, &stage->scene, NULL, &stage->solution);
    return status;
}

static void clear(struct stage *stage)
{
    murk_solution_release(stage->solution);
    murk_ground_release(stage->ground);
    murk_medium_release(stage->medium);
    murk_volume_release(stage->volume);
}

static murk_status take(murk_context *context, const struct stage *stage, const murk_camera *camera,
                        const char *path)
{
    murk_image *image;
    murk_status status = murk_render(context, &stage->scene, stage->solution, camera, NULL, &image);
    if (status)
        return status;
    status = murk_image_write(context, image, path, NULL);
    murk_image_release(image);
    return status;
}

static murk_status run(murk_context *context, char **argv)
{
    struct stage stage = {0};
    murk_camera camera;
    murk_status status = set(context, argv[1], &stage);
    if (!status)
        status = murk_camera_default(context, &stage.scene, &camera);
    if (!status) {
        camera.size[0] = camera.size[1] = 256;
        status = take(context, &stage, &camera, argv[2]);
    }
    if (!status) {
        camera.eye[0] += 0.065; /* the other eye */
        camera.target[0] += 0.065;
        status = take(context, &stage, &camera, argv[3]);
    }
    clear(&stage);
    return status;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "usage: %s SMOKE.vdb LEFT RIGHT\n", argv[0]);
        return 1;
    }
    murk_context *context;
    murk_status status = murk_context_create(NULL, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    status = run(context, argv);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    else
        printf("one solution, two views: %s and %s\n", argv[2], argv[3]);
    murk_context_release(context);
    return status != MURK_OK;
}
