/* SPDX-License-Identifier: Apache-2.0 */
/* Warm smoke over cool ground as a thermal camera sees it: 06_infrared SMOKE.vdb OUT.exr, where the
 * file has the grids density and temperature, the latter in units of the simulation. */
#include <murk/bands.h>

#include <stdio.h>
#include <string.h>

static const murk_band LWIR = {{8e-6, 12e-6}};

/* Everything the picture needs; zeroed members are released as nothing. */
struct stage {
    murk_volume *volume;
    murk_medium *medium;
    murk_ground *ground;
    murk_scene scene;
    murk_solution *solution;
};

/* Smoke of 288 K and 20 K more per unit of its grid, over ground of 288 K, under a sky of 250 K. */
static murk_status set(murk_context *context, const char *path, struct stage *stage)
{
    murk_medium_options medium = MURK_MEDIUM_DEFAULT;
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    medium.extinction.scale = 4;
    medium.albedo.value = 0.1;
    medium.temperature = (murk_quantity){.grid = "temperature", .scale = 20};
    medium.temperature_offset = 288;
    medium.band = LWIR;
    ground.reflectance = 0.05;
    ground.emission = (1 - ground.reflectance) * 3.14159265 * murk_planck_radiance(&LWIR, 288);
    ground.extent_max[0] = ground.extent_max[1] = 0; /* as the low corner: to be chosen */
    murk_status status = murk_volume_read(context, path, &stage->volume);
    if (!status)
        status = murk_medium_from_volume(context, stage->volume, &medium, &stage->medium);
    if (!status)
        status = murk_ground_fit(context, stage->medium, &stage->scene.sun, &ground);
    if (!status)
        status = murk_ground_create(context, &ground, &stage->ground);
    stage->scene.medium = stage->medium;
    stage->scene.ground = stage->ground;
    stage->scene.sky_radiance = murk_planck_radiance(&LWIR, 250);
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

/* The hottest pixel [K]. */
static double hottest(const murk_image *image)
{
    int channels = murk_image_channels(image), at = 0;
    size_t pixels = (size_t)murk_image_width(image) * (size_t)murk_image_height(image);
    double most = 0;
    while (strcmp(murk_image_channel_name(image, at), "LWIR.temperature") != 0)
        at++;
    for (size_t i = 0; i < pixels; i++)
        most = fmax(most, murk_image_pixels_const(image)[i * (size_t)channels + (size_t)at]);
    return most;
}

static murk_status run(murk_context *context, char **argv)
{
    struct stage stage = {0};
    murk_camera camera;
    murk_image *image = NULL;
    murk_status status = set(context, argv[1], &stage);
    if (!status)
        status = murk_camera_default(context, &stage.scene, &camera);
    if (!status) {
        const murk_band_view view = {
            .name = "LWIR", .band = LWIR, .scene = &stage.scene, .solution = stage.solution};
        camera.size[0] = camera.size[1] = 256;
        status = murk_render_bands(context, &view, 1, &camera, NULL, &image);
    }
    if (!status)
        status = murk_image_write(context, image, argv[2], NULL);
    if (!status)
        printf("%s: up to %.1f K\n", argv[2], hottest(image));
    murk_image_release(image);
    clear(&stage);
    return status;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: %s SMOKE.vdb OUT.exr\n", argv[0]);
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
    murk_context_release(context);
    return status != MURK_OK;
}
