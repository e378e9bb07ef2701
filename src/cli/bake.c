/* SPDX-License-Identifier: Apache-2.0 */
#include "bake.h"

#include "bake_sheet.h"
#include "bake_view.h"
#include "murk/memory.h"
#include "output.h"
#include "report.h"
#include "sequence.h"

#include <math.h>

enum { GLOW = CLI_BAKE_SIDES, LIGHTS };

struct bake {
    struct cli_bake_box box; /* around the media of all frames */
    struct cli_bake_sheet sheet;
    int frames, done;
};

/* ---- before -------------------------------------------------------------------------------- */

static murk_status check(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    if (!options->output) {
        cli_error(&job->terminal, "bake: needs an output: -o FILE.png");
        return MURK_ERROR_INPUT;
    }
    murk_status status = cli_bake_sheet_check(job, options->output);
    if (status != MURK_OK || !options->radiosity)
        return status;
    if (!cli_has_extension(options->radiosity, ".vdb")) {
        cli_error(&job->terminal,
                  "--radiosity %s: is not a .vdb file; the radiosity is written as VDB",
                  options->radiosity);
        return MURK_ERROR_INPUT;
    }
    return cli_job_fail(job, murk_output_check(job->context, options->radiosity));
}

static bool glows(const struct scene_description *description)
{
    const murk_medium_options *medium = &description->medium;
    return medium->emission.grid || medium->emission.value > 0 || medium->temperature.grid ||
           medium->temperature.value > 0;
}

/* What lights a scene by itself is left out: the six lights alone are wanted. */
static void put_out(struct scene_description *description)
{
    description->medium.emission = (murk_quantity){0};
    description->medium.temperature = (murk_quantity){0};
    description->sky_radiance = 0;
    description->sun_temperature = description->sky_temperature = NAN;
    description->sky_named = true;
    description->sun_named = description->ground_named = false;
    description->temperature_image = NULL;
}

/* Builds the scene without light of its own, and a second one of the medium as it glows, if it
   does, that shares the first one's volume. */
static murk_status build(struct cli_job *job, struct scene *glow)
{
    struct scene_description *bands;
    char message[SCENE_MESSAGE_SIZE] = "";
    murk_status status = cli_job_read(job);
    if (status != MURK_OK)
        return status;
    size_t count = scene_bands(&job->description, &bands);
    if (count != 1) {
        cli_error(&job->terminal,
                  "bake: lights one band, and the scene has %zu; choose one with "
                  "--bands NAME",
                  count);
        return MURK_ERROR_INPUT;
    }
    if (glow && glows(bands)) {
        glow->volume = job->scene.volume;
        status = scene_build(job->context, &job->description, glow, message);
        glow->volume = NULL;
        if (status != MURK_OK)
            cli_error(&job->terminal, "%s", message);
    }
    put_out(bands);
    if (bands != &job->description)
        put_out(&job->description);
    return status == MURK_OK ? cli_job_build(job) : status;
}

static murk_status survey(struct cli_job *job)
{
    struct bake *bake = job->state;
    const int *flipbook = job->options->flipbook;
    murk_medium_info info;
    murk_status status = build(job, NULL);
    if (status == MURK_OK)
        status = cli_job_fail(job, murk_medium_info_get(job->scene.band[0].medium, &info));
    if (status != MURK_OK)
        return status;
    cli_bake_box_add(&bake->box, &info);
    bake->frames++;
    if (flipbook[0] && bake->frames > flipbook[0] * flipbook[1]) {
        cli_error(&job->terminal,
                  "--flipbook %dx%d: has too few cells for the frames; --frames "
                  "chooses some, such as 1-100x2",
                  flipbook[0], flipbook[1]);
        return MURK_ERROR_INPUT;
    }
    return MURK_OK;
}

/* ---- one frame ----------------------------------------------------------------------------- */

/* The scenes of the six lights, and of the glow where there is one; gives their number. */
static size_t light(const struct cli_job *job, const struct scene *glow, const murk_camera *camera,
                    murk_scene scene[LIGHTS])
{
    for (int side = 0; side < CLI_BAKE_SIDES; side++)
        scene[side] =
            (murk_scene){.medium = job->scene.band[0].medium, .sun = cli_bake_light(camera, side)};
    if (!glow->band_count)
        return CLI_BAKE_SIDES;
    scene[GLOW] = (murk_scene){.medium = glow->band[0].medium};
    return LIGHTS;
}

static murk_status solve(struct cli_job *job, const murk_scene scene[], size_t count)
{
    murk_status status =
        murk_solve_many(job->context, scene, count, &job->options->solve, NULL, job->solution);
    cli_terminal_clear(&job->terminal);
    return cli_job_fail(job, status);
}

static murk_status render(struct cli_job *job, const murk_scene scene[], size_t count,
                          const murk_camera *camera, struct cli_bake_sheet *sheet, int at)
{
    double start = cli_seconds();
    murk_render_options options = MURK_RENDER_DEFAULT;
    murk_status status = MURK_OK;
    options.samples = job->options->samples;
    options.no_background = true;
    for (size_t n = 0; n < count && status == MURK_OK; n++) {
        murk_image *picture = NULL;
        status = murk_render(job->context, &scene[n], job->solution[n], camera, &options, &picture);
        if (status == MURK_OK)
            cli_bake_sheet_put(sheet, at, (int)n, picture);
        murk_image_release(picture);
    }
    cli_terminal_clear(&job->terminal);
    job->seconds_render = cli_seconds() - start;
    return cli_job_fail(job, status);
}

/* The cell of the frame is drawn, in a sheet of its own or that of the flipbook. */
static murk_status draw(struct cli_job *job, const murk_scene scene[], size_t count,
                        const murk_camera *camera)
{
    struct bake *bake = job->state;
    const int *flipbook = job->options->flipbook, one[2] = {1, 1};
    murk_status status = MURK_OK;
    if (!bake->sheet.half[0])
        status =
            cli_bake_sheet_create(job, camera->size, flipbook[0] ? flipbook : one, &bake->sheet);
    if (status == MURK_OK)
        status = render(job, scene, count, camera, &bake->sheet, flipbook[0] ? bake->done : 0);
    if (status == MURK_OK && !flipbook[0])
        status = cli_bake_sheet_write(job, &bake->sheet, job->options->output);
    if (!flipbook[0])
        cli_bake_sheet_clear(&bake->sheet);
    bake->done += status == MURK_OK;
    return status;
}

/* Whether the sheet's two halves, the opacity of one and a picture of a cell fit into memory. */
static murk_status afford(struct cli_job *job, const murk_scene scene[], size_t count,
                          const murk_camera *camera)
{
    enum { VALUES = 2 * 4 + 1, ENCODED = 4 };
    const struct bake *bake = job->state;
    const int *flipbook = job->options->flipbook;
    const double cells = flipbook[0] ? (double)flipbook[0] * flipbook[1] : 1;
    const double values = bake->sheet.half[0] ? ENCODED : VALUES + ENCODED;
    const double sheet = cells * camera->size[0] * camera->size[1] * values * sizeof(float);
    return cli_job_afford(job, count, "the sheet of textures",
                          sheet + (double)murk_render_memory(scene, camera, 0));
}

static murk_status light_and_draw(struct cli_job *job, const struct scene *glow)
{
    struct bake *bake = job->state;
    murk_scene scene[LIGHTS];
    murk_medium_info info;
    murk_camera camera;
    if (!job->frame && murk_medium_info_get(job->scene.band[0].medium, &info) == MURK_OK)
        cli_bake_box_add(&bake->box, &info);
    murk_status status = cli_bake_camera(job, &bake->box, &camera);
    if (status != MURK_OK)
        return status;
    size_t count = light(job, glow, &camera, scene);
    status = afford(job, scene, count, &camera);
    if (status == MURK_OK)
        status = solve(job, scene, count);
    if (cli_job_failed(status))
        return status;
    murk_status drawn = draw(job, scene, count, &camera);
    if (drawn == MURK_OK && job->options->radiosity)
        drawn = cli_job_fail(
            job, cli_output_radiosity(job, CLI_BAKE_SIDE, CLI_BAKE_SIDES, job->options->radiosity));
    if (drawn != MURK_OK)
        return drawn;
    cli_report_say(job, status);
    if (job->options->json)
        cli_report_json(job, status);
    return status;
}

static murk_status work(struct cli_job *job)
{
    struct scene glow = {0};
    murk_status status = build(job, &glow);
    if (status == MURK_OK)
        status = light_and_draw(job, &glow);
    scene_release(&glow);
    return status;
}

/* ---- after all of them --------------------------------------------------------------------- */

static murk_status finish(struct cli_job *job)
{
    struct bake *bake = job->state;
    murk_status status = MURK_OK;
    if (!bake->sheet.half[0])
        return MURK_OK;
    if (bake->done < bake->frames)
        cli_error(&job->terminal, "%s: not written, because %d of %d frames failed",
                  job->options->output, bake->frames - bake->done, bake->frames);
    else
        status = cli_bake_sheet_write(job, &bake->sheet, job->options->output);
    cli_bake_sheet_clear(&bake->sheet);
    return status;
}

int cli_bake(const struct cli_options *options, const char *command_line)
{
    struct bake bake = {0};
    const struct cli_steps steps = {
        .check = check, .work = work, .finish = finish, .state = &bake, .survey = survey};
    return cli_run(options, "bake", command_line, &steps);
}
