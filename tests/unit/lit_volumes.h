/* SPDX-License-Identifier: Apache-2.0 */
/* Media of the odd volumes, and solutions that are known without solving. */
#ifndef LIT_VOLUMES_H
#define LIT_VOLUMES_H

#include "vdb_files.h"

#include "solution.h"
#include "volume.h"

static inline void assert_message(murk_context *context, const char *part)
{
    if (!strstr(murk_context_message(context), part))
        fail_msg("\"%s\" does not say \"%s\"", murk_context_message(context), part);
}

static inline murk_medium *make_medium(murk_context *context, const char *file,
                                       const murk_medium_options *options)
{
    murk_volume *volume = read_volume(context, odd(file));
    murk_medium *medium = NULL;
    murk_status status = murk_medium_from_volume(context, volume, options, &medium);
    murk_volume_release(volume);
    if (status)
        fail_msg("%s", murk_context_message(context));
    return medium;
}

/* A solution whose radiosity follows from the place and a factor, without solving. */
static inline murk_solution *make_solution(murk_context *context, const murk_medium *medium,
                                           double factor)
{
    murk_solution *solution = NULL;
    const murk_scene scene = {
        .medium = medium, .sun = {{0, 0, -1}, 2 * factor}, .sky_radiance = 0.5};
    if (murk_solution_create(context, &scene, 0, &solution))
        fail_msg("%s", murk_context_message(context));
    for (size_t b = 0; b < solution->grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (murk_grid_active(solution->grid, b, slot))
                solution->radiosity[b * MURK_BRICK_SLOTS + (size_t)slot] =
                    (float)factor * (1 + (float)slot / 512 + (float)b);
    return solution;
}

#endif
