/* SPDX-License-Identifier: Apache-2.0 */
#include "show.h"

#include "murk/false_color.h"
#include "nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool cli_show_wanted(const struct cli_job *job, const char *path)
{
    return job->options->show && path && !cli_has_extension(path, ".exr") &&
           !cli_has_extension(path, ".tif") && !cli_has_extension(path, ".tiff");
}

murk_status cli_show_check(struct cli_job *job)
{
    const struct cli_options *options = job->options;
    const bool range = !isnan(options->range[0]);
    if (!options->show && !range)
        return MURK_OK;
    if (!options->show)
        cli_error(&job->terminal, "--range: is for the channel that --show CHANNEL names");
    else if (!cli_show_wanted(job, options->output) && !cli_show_wanted(job, options->preview))
        cli_error(&job->terminal,
                  "--show %s: needs a picture to show it in, such as --preview FILE.png; an .exr "
                  "keeps all channels as they are",
                  options->show);
    else if (!isnan(options->exposure))
        cli_error(&job->terminal,
                  "--exposure: a channel in false colour has none; --range LOW:HIGH says what is "
                  "dark and what is bright");
    else
        return MURK_OK;
    return MURK_ERROR_INPUT;
}

/* ---- the label ----------------------------------------------------------------------------- */

/* What channels hold: by the name, or by its end after a band's name and a dot. */
static const struct {
    const char *channel, *text;
} MEANING[] = {
    {"radiance", "radiance [W/m^2/sr]"},
    {"temperature", "apparent temperature [K]"},
    {"transmittance", "transmittance"},
    {"scattered", "scattered radiance [W/m^2/sr]"},
    {"emitted", "emitted radiance [W/m^2/sr]"},
    {"surface", "surface radiance, attenuated [W/m^2/sr]"},
    {"inherent", "surface radiance, inherent [W/m^2/sr]"},
    {"transmittance.Y", "transmittance"},
    {"Z", "depth [m]"},
    {"A", "opacity"},
    {"CL.Y", "concentration times length [g/m^2]"},
};

/* "LWIR apparent temperature [K]"; a channel that is not in the table is one of radiances. */
static void name_channel(const char *channel, char *label, size_t size)
{
    for (size_t i = 0; i < sizeof MEANING / sizeof *MEANING; i++) {
        size_t length = strlen(channel), end = strlen(MEANING[i].channel);
        bool of_band = length > end + 1 && channel[length - end - 1] == '.' &&
                       !strcmp(channel + length - end, MEANING[i].channel);
        if (of_band || !strcmp(channel, MEANING[i].channel)) {
            snprintf(label, size, "%.*s%s%s", of_band ? (int)(length - end - 1) : 0, channel,
                     of_band ? " " : "", MEANING[i].text);
            return;
        }
    }
    snprintf(label, size, "%s [W/m^2/sr]", channel);
}

/* ---- the channel --------------------------------------------------------------------------- */

static bool has_channel(const murk_image *image, const char *name)
{
    for (int c = 0; c < murk_image_channels(image); c++)
        if (!strcmp(murk_image_channel_name(image, c), name))
            return true;
    return false;
}

/* Names all channels, those nearest to the unknown one first. */
static murk_status unknown_channel(struct cli_job *job, const murk_image *image)
{
    enum { LIST_SIZE = 900 };
    const char *wanted = job->options->show;
    char list[LIST_SIZE] = "";
    for (int distance = 0; distance <= MURK_EDIT_DISTANCE_MAX; distance++)
        for (int c = 0; c < murk_image_channels(image); c++) {
            const char *name = murk_image_channel_name(image, c);
            size_t used = strlen(list);
            if (murk_edit_distance(wanted, name) == distance)
                snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "", name);
        }
    cli_error(&job->terminal, "--show %s: the picture has no such channel; it has %s", wanted,
              list);
    return MURK_ERROR_INPUT;
}

murk_status cli_show_check_channel(struct cli_job *job)
{
    static const int size[2] = {1, 1};
    murk_band_view view[SCENE_BANDS_MAX];
    murk_image *image = NULL;
    if (!job->options->show)
        return MURK_OK;
    const size_t count = cli_job_views(job, view);
    murk_status status =
        cli_job_fail(job, murk_bands_picture(job->context, view, count, size, &image));
    if (status == MURK_OK && !has_channel(image, job->options->show))
        status = unknown_channel(job, image);
    murk_image_release(image);
    return status;
}

murk_status cli_show_make(struct cli_job *job, murk_image **out)
{
    const struct cli_options *options = job->options;
    char label[128];
    if (!options->show)
        return MURK_OK;
    name_channel(options->show, label, sizeof label);
    const murk_false_color color = {.channel = options->show,
                                    .low = options->range[0],
                                    .high = options->range[1],
                                    .label = label};
    return cli_job_fail(job, murk_false_color_create(job->context, job->picture, &color, out));
}
