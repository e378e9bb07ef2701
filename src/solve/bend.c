/* SPDX-License-Identifier: Apache-2.0 */
#include "bend.h"

#include "spatial.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Square of the error that a brick brings with constant sources, weighted as the tolerance is: by
   kappa_t and, in a guess, the same light everywhere. */
struct share {
    double error;
    int32_t brick;
    bool opaque;
};

/* Optical depths of a zone in which slopes see nothing of the skin where the light is. */
static const double OPAQUE = 100;

static int compare_shares(const void *a, const void *b)
{
    const struct share *u = a, *v = b;
    return u->error != v->error ? (u->error < v->error ? -1 : 1)
                                : (u->brick > v->brick) - (u->brick < v->brick);
}

/* The shares of all bricks in ascending order; sum of kappa_t. */
static double find_shares(const murk_medium *medium, struct share *share)
{
    const double *voxel = medium->grid->voxel;
    const double edge = fmax(voxel[0], fmax(voxel[1], voxel[2]));
    double all = 0;
    for (size_t b = 0; b < medium->grid->brick_count; b++) {
        share[b] = (struct share){0, (int32_t)b, false};
        for (size_t i = b * MURK_BRICK_SLOTS; i < (b + 1) * MURK_BRICK_SLOTS; i++) {
            double kappa_t = medium->kappa_t[i], albedo = murk_value(&medium->albedo, i);
            double error = albedo * murk_spatial_flat(edge * kappa_t);
            share[b].error += kappa_t * error * error;
            share[b].opaque = share[b].opaque || edge * kappa_t > OPAQUE;
            all += kappa_t;
        }
    }
    qsort(share, medium->grid->brick_count, sizeof *share, compare_shares);
    return all;
}

static void choose(const murk_medium *medium, double allowed, const int32_t *map,
                   struct share *share, murk_bend *bend)
{
    const size_t bricks = medium->grid->brick_count;
    double all = find_shares(medium, share), flat = 0;
    size_t n = 0;
    for (; n < bricks && flat + share[n].error <= allowed * allowed * all; n++)
        flat += share[n].error;
    for (; n < bricks; n++)
        if (share[n].opaque)
            flat += share[n].error;
        else
            bend->zones.place[share[n].brick] = 0;
    bend->flat = all > 0 ? sqrt(flat / all) : 0;
    for (size_t b = 0; b < bricks; b++)
        if (bend->zones.place[b] != MURK_NOT_BENT) {
            bend->zones.place[b] = bend->there.place[map[b]] = (int32_t)bend->zones.count;
            bend->zones.brick[bend->zones.count] = (int32_t)b;
            bend->there.brick[bend->zones.count++] = map[b];
        }
    bend->there.count = bend->zones.count;
}

murk_status murk_bend_create(murk_context *context, const murk_medium *medium, double allowed,
                             const murk_grid *grid, const int32_t *map, murk_bend *out)
{
    const size_t bricks = medium->grid->brick_count;
    struct share *share = murk_alloc(bricks, sizeof *share);
    murk_bend made = {.zones = {.brick = murk_alloc(bricks, sizeof(int32_t)),
                                .place = murk_alloc(bricks, sizeof(int32_t))},
                      .there = {.brick = murk_alloc(bricks, sizeof(int32_t)),
                                .place = murk_alloc(grid->brick_count, sizeof(int32_t))}};
    murk_status status = MURK_OK;
    if (!share || !made.zones.brick || !made.zones.place || !made.there.brick ||
        !made.there.place) {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           medium->grid->zone_count);
        murk_bend_clear(&made);
    } else {
        for (size_t b = 0; b < bricks; b++)
            made.zones.place[b] = MURK_NOT_BENT;
        for (size_t b = 0; b < grid->brick_count; b++)
            made.there.place[b] = MURK_NOT_BENT;
        choose(medium, allowed, map, share, &made);
        *out = made;
    }
    murk_free(share);
    return status;
}

void murk_bend_clear(murk_bend *bend)
{
    murk_free(bend->zones.brick);
    murk_free(bend->zones.place);
    murk_free(bend->there.brick);
    murk_free(bend->there.place);
    memset(bend, 0, sizeof *bend);
}
