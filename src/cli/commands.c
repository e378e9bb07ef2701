/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"

#include "bake.h"
#include "bench.h"
#include "contrast.h"
#include "info.h"
#include "work.h"

static const struct cli_command_info COMMANDS[] = {
    {CLI_IMAGE, "image", "image INPUT -o FILE.exr [OPTION]...",
     "Solves the light in the medium, then renders the picture.", "vdb json", cli_image},
    {CLI_SOLVE, "solve", "solve INPUT -o FILE.vdb [OPTION]...",
     "Solves the light in the medium and writes its radiosity.", "vdb json", cli_solve},
    {CLI_RENDER, "render", "render INPUT --radiosity FILE.vdb -o FILE.exr [OPTION]...",
     "Renders another view of a solution; nothing is solved again.", "vdb json", cli_render},
    {CLI_BAKE, "bake", "bake INPUT -o FILE.png [OPTION]...",
     "Lights the medium from six sides, to the textures of six-way lighting in game engines.",
     "vdb json", cli_bake},
    {CLI_INFO, "info", "info INPUT [OPTION]...",
     "Tells what is in a file, and what murk would take it for.", "vdb json", cli_info},
    {CLI_CONTRAST, "contrast", "contrast INPUT --target REGION --background REGION [OPTION]...",
     "Tells what of a target is seen through the smoke, in each band of a picture.", "exr",
     cli_contrast},
    {CLI_BENCH, "bench", "bench [-o FILE.png] [OPTION]...",
     "Measures run time, memory and error on media made in memory.", NULL, cli_bench},
};

const struct cli_command_info *cli_command_table(size_t *count)
{
    *count = sizeof COMMANDS / sizeof *COMMANDS;
    return COMMANDS;
}
