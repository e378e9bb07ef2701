/* SPDX-License-Identifier: Apache-2.0 */
#include "paths.h"

#include "pattern.h"

#include <stdlib.h>
#include <string.h>

size_t cli_paths(struct cli_options *options, const char *command,
                 struct cli_path list[CLI_PATH_MAX])
{
    const struct cli_path all[CLI_PATH_MAX] = {
        {"INPUT", &options->input, true},
        {"--radiosity", &options->radiosity, !strcmp(command, "render")},
        {"--ground-radiosity", &options->ground_radiosity, false},
        {"-o", &options->output, false},
        {"--usd", &options->usd, false},
        {"--deep", &options->deep, false},
        {"--preview", &options->preview, false},
        {"--target", &options->target_region, true},
        {"--background", &options->background_region, true},
    };
    bool whole = !strcmp(command, "contrast");
    size_t count = 0;
    for (size_t i = 0; i < CLI_PATH_MAX; i++)
        if (*all[i].text && (all[i].input || !whole) &&
            !(options->flipbook[0] && all[i].text == &options->output))
            list[count++] = all[i];
    return count;
}

murk_status cli_frame_options_make(const struct cli_options *options, const char *command,
                                   int frame, struct cli_frame_options *out)
{
    struct cli_path list[CLI_PATH_MAX];
    *out = (struct cli_frame_options){.options = *options};
    size_t count = cli_paths(&out->options, command, list);
    for (size_t i = 0; i < count; i++) {
        const char *text = *list[i].text;
        if (list[i].input && !cli_pattern_is_input(text))
            continue;
        out->texts[i] = cli_pattern_expand(text, frame);
        if (!out->texts[i]) {
            cli_frame_options_release(out);
            return MURK_ERROR_MEMORY;
        }
        *list[i].text = out->texts[i];
    }
    return MURK_OK;
}

void cli_frame_options_release(struct cli_frame_options *frame_options)
{
    for (int i = 0; i < CLI_PATH_MAX; i++)
        free(frame_options->texts[i]);
    *frame_options = (struct cli_frame_options){0};
}
