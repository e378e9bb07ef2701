/* SPDX-License-Identifier: Apache-2.0 */
#include "boxes.h"

#include "kernel.h"

#include <math.h>

static murk_box box_of(const murk_medium *medium, size_t brick)
{
    const murk_grid *grid = medium->grid;
    const float *kappa_t = medium->kappa_t + brick * MURK_BRICK_SLOTS;
    murk_box box = {.from = {8, 8, 8}};
    float most = 0;
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        const uint8_t at[3] = {(uint8_t)(slot >> 6), slot >> 3 & 7, slot & 7};
        if (!(kappa_t[slot] > 0))
            continue;
        most = kappa_t[slot] > most ? kappa_t[slot] : most;
        for (int a = 0; a < 3; a++) {
            box.from[a] = at[a] < box.from[a] ? at[a] : box.from[a];
            box.to[a] = at[a] >= box.to[a] ? at[a] + 1 : box.to[a];
        }
    }
    for (int a = 0; a < 3; a++)
        box.low[a] = grid->brick[brick][a] * MURK_BRICK_EDGE - grid->lo[a];
    box.thin = murk_depth_of(most * hypot(hypot(grid->voxel[0], grid->voxel[1]), grid->voxel[2])) <
               MURK_DEPTH_ANY;
    return box;
}

murk_box *murk_boxes_create(murk_context *context, const murk_medium *medium)
{
    size_t count = medium->grid->brick_count;
    murk_box *box = murk_alloc(count, sizeof *box);
    if (!box)
        return NULL;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t b = 0; b < count; b++)
        box[b] = box_of(medium, b);
    return box;
}
