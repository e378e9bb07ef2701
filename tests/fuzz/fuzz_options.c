/* SPDX-License-Identifier: Apache-2.0 */
/* The command line: the first line names the command, each further one is an argument. */
#include "frames.h"
#include "fuzz.h"
#include "options.h"
#include "pattern.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { ARGUMENTS = 24 };

/* What is done with the texts before any file is touched. */
static void use(const struct cli_options *options)
{
    struct cli_frames frames = {0};
    if (options->frames && cli_frames_parse(options->frames, &frames) == MURK_OK) {
        char text[40];
        assert(frames.count > 0 && frames.count <= CLI_FRAME_COUNT_MAX);
        cli_frames_text(&frames, text, sizeof text);
    }
    if (options->output && cli_pattern_has(options->output))
        free(cli_pattern_expand(options->output, frames.count ? frames.number[0] : -7));
    cli_frames_release(&frames);
}

static enum cli_command find_command(const char *name)
{
    static const char *const NAMES[] = {"image", "solve", "render", "info", "bench", "contrast"};
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++)
        if (!strcmp(NAMES[i], name))
            return (enum cli_command)(1 << i);
    return CLI_IMAGE;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char message[512] = "", *argument[ARGUMENTS];
    char *text = malloc(size + 1);
    int count = 0;
    struct cli_options options;
    if (!text)
        return 0;
    memcpy(text, bytes, size);
    text[size] = '\0';
    char *rest = text;
    const char *command = strsep(&rest, "\n");
    while (rest && count < ARGUMENTS)
        argument[count++] = strsep(&rest, "\n");
    if (cli_options_parse(find_command(command), command, count, argument, &options, message,
                          sizeof message))
        use(&options);
    else
        assert(*message);
    free(text);
    return 0;
}
