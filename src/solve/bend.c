/* SPDX-License-Identifier: Apache-2.0 */
#include "bend.h"

#include "spatial.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Square of the error that a brick brings with constant sources, weighted as the tolerance is: by
   kappa_t and, in a guess, the same light everywhere. */
struct share {
    double error; /* by the highest albedo that a medium has in each zone */
    double own[MURK_MOST_BANDS];
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

/* The share of one brick; adds to the sum of kappa_t. */
static struct share share_of(const murk_medium *const medium[], int count, size_t brick,
                             double *all)
{
    const double *voxel = medium[0]->grid->voxel;
    const double edge = fmax(voxel[0], fmax(voxel[1], voxel[2]));
    struct share share = {.brick = (int32_t)brick};
    for (size_t i = brick * MURK_BRICK_SLOTS; i < (brick + 1) * MURK_BRICK_SLOTS; i++) {
        double kappa_t = medium[0]->kappa_t[i], flat = murk_spatial_flat(edge * kappa_t), most = 0;
        for (int m = 0; m < count; m++) {
            double error = murk_value(&medium[m]->albedo, i) * flat;
            share.own[m] += kappa_t * error * error;
            most = fmax(most, error);
        }
        share.error += kappa_t * most * most;
        share.opaque = share.opaque || edge * kappa_t > OPAQUE;
        *all += kappa_t;
    }
    return share;
}

static void choose(const murk_medium *const medium[], int count, double allowed, const int32_t *map,
                   struct share *share, double flat[], murk_bend *bend)
{
    const size_t bricks = medium[0]->grid->brick_count;
    double all = 0, left = 0;
    for (size_t b = 0; b < bricks; b++)
        share[b] = share_of(medium, count, b, &all);
    qsort(share, bricks, sizeof *share, compare_shares);
    for (int m = 0; m < count; m++)
        flat[m] = 0;
    for (size_t n = 0; n < bricks; n++) {
        left += share[n].error;
        if (left > allowed * allowed * all && !share[n].opaque)
            bend->zones.place[share[n].brick] = 0;
        else
            for (int m = 0; m < count; m++)
                flat[m] += share[n].own[m];
    }
    for (int m = 0; m < count; m++)
        flat[m] = all > 0 ? sqrt(flat[m] / all) : 0;
    for (size_t b = 0; b < bricks; b++)
        if (bend->zones.place[b] != MURK_NOT_BENT) {
            bend->zones.place[b] = bend->there.place[map[b]] = (int32_t)bend->zones.count;
            bend->zones.brick[bend->zones.count] = (int32_t)b;
            bend->there.brick[bend->zones.count++] = map[b];
        }
    bend->there.count = bend->zones.count;
}

murk_status murk_bend_create(murk_context *context, const murk_medium *const medium[], int count,
                             double allowed, const murk_grid *grid, const int32_t *map,
                             double flat[], murk_bend *out)
{
    const size_t bricks = medium[0]->grid->brick_count;
    struct share *share = murk_alloc(bricks, sizeof *share);
    murk_bend made = {.zones = {.brick = murk_alloc(bricks, sizeof(int32_t)),
                                .place = murk_alloc(bricks, sizeof(int32_t))},
                      .there = {.brick = murk_alloc(bricks, sizeof(int32_t)),
                                .place = murk_alloc(grid->brick_count, sizeof(int32_t))}};
    murk_status status = MURK_OK;
    if (!share || !made.zones.brick || !made.zones.place || !made.there.brick ||
        !made.there.place) {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu zones",
                           medium[0]->grid->zone_count);
        murk_bend_clear(&made);
    } else {
        for (size_t b = 0; b < bricks; b++)
            made.zones.place[b] = MURK_NOT_BENT;
        for (size_t b = 0; b < grid->brick_count; b++)
            made.there.place[b] = MURK_NOT_BENT;
        choose(medium, count, allowed, map, share, flat, &made);
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
