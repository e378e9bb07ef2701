/* SPDX-License-Identifier: Apache-2.0 */
/* C99 and C17: says how many grids a file has. */
#include <murk/bands.h>
#include <murk/contrast.h>
#include <murk/exchange.h>
#include <murk/false_color.h>

#include <stdio.h>

int main(int argc, char **argv)
{
    murk_context *context;
    murk_volume *volume;
    if (argc != 2 || murk_context_create(NULL, &context))
        return 2;
    murk_status status = murk_volume_read(context, argv[1], &volume);
    if (!status)
        printf("%d grid\n", (int)murk_volume_grid_count(volume));
    else
        printf("%s\n", murk_context_message(context));
    if (!status)
        murk_volume_release(volume);
    murk_context_release(context);
    return status != MURK_OK;
}
