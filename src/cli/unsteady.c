/* SPDX-License-Identifier: Apache-2.0 */
#include "unsteady.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool open_scale(const struct cli_job *job)
{
    murk_medium_info info;
    return cli_job_chose_scale(job, &info);
}

static bool open_ground(const struct cli_job *job)
{
    const murk_ground_options *ground = &job->description.ground;
    return job->scene.band[0].ground &&
           (isnan(ground->height) || ground->extent_min[0] == ground->extent_max[0]);
}

static bool open_camera(const struct cli_job *job)
{
    const murk_camera *camera = &job->description.camera;
    return job->picture && (isnan(camera->eye[0]) || isnan(camera->target[0]));
}

static bool open_exposure(const struct cli_job *job)
{
    const struct cli_options *options = job->options;
    return job->picture && !options->show && isnan(options->exposure) &&
           (options->preview || !cli_has_extension(options->output, ".exr"));
}

static bool open_range(const struct cli_job *job)
{
    return job->options->show && isnan(job->options->range[0]);
}

void cli_unsteady_text(const struct cli_job *job, char text[CLI_UNSTEADY_SIZE])
{
    *text = '\0';
    if (job->scene.band_count == 0)
        return;
    const char *const open[] = {
        open_scale(job) ? "extinction (--scale)" : NULL,
        open_ground(job) ? "ground (in a scene: height, extent)" : NULL,
        open_camera(job) ? "camera (--eye, --target)" : NULL,
        open_exposure(job) ? "exposure (--exposure)" : NULL,
        open_range(job) ? "range of the scale bar (--range)" : NULL,
    };
    for (size_t i = 0; i < sizeof open / sizeof *open; i++)
        if (open[i])
            snprintf(text + strlen(text), CLI_UNSTEADY_SIZE - strlen(text), "%s%s",
                     *text ? ", " : "", open[i]);
}
