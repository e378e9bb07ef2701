/* SPDX-License-Identifier: Apache-2.0 */
/* A box of zones over a ground with its stored exchange factors, for tests; cmocka and what it
   needs are included before. */
#ifndef MURK_TESTS_EXCHANGE_BOX_H
#define MURK_TESTS_EXCHANGE_BOX_H

#include "ground.h"
#include "medium.h"
#include "pairwise.h"

#include <math.h>
#include <string.h>

enum { MOST = 4096 };

/* A box of zones over a ground and the operator between them. */
typedef struct box {
    murk_context *context;
    murk_medium *medium;
    murk_ground *ground;
    void *operator;
    size_t zones, patches, slots;
    size_t slot[MOST];
    int32_t cell[MOST][3];
} box;

typedef struct box_options {
    int32_t size[3];
    double voxel[3];
    double kappa; /* where kappa_t is NULL */
    const float *kappa_t;
    bool perturb; /* one zone differs a little: no factors by offset */
    murk_up up;
    double height;
    int patches[2]; /* 0: no ground */
    bool horizon;
    int window[3];
    const float *reflectance;
} box_options;

/* The paper's sample case. */
#define PAPER_BOX                                                                                  \
    {                                                                                              \
        .size = {10, 10, 10}, .voxel = {0.1, 0.1, 0.05}, .kappa = 0.8, .patches = { 10, 10 }       \
    }

static inline void open_box(box *b, const box_options *o)
{
    memset(b, 0, sizeof *b);
    assert_int_equal(murk_context_create(NULL, &b->context), MURK_OK);
    size_t count = (size_t)o->size[0] * (size_t)o->size[1] * (size_t)o->size[2];
    float kappa[MOST];
    assert_true(count <= MOST);
    for (size_t i = 0; i < count; i++)
        kappa[i] = o->kappa_t ? o->kappa_t[i] : (float)o->kappa;
    if (o->perturb)
        kappa[0] *= 1.000001f;
    murk_array array = {.kappa_t = kappa, .albedo_value = 0.625};
    memcpy(array.size, o->size, sizeof array.size);
    memcpy(array.voxel_size, o->voxel, sizeof array.voxel_size);
    assert_int_equal(murk_medium_from_array(b->context, &array, &b->medium), MURK_OK);
    if (o->patches[0]) {
        murk_ground_options ground = MURK_GROUND_DEFAULT;
        int second = o->up == MURK_UP_Z ? 1 : 2;
        ground.up = o->up;
        ground.height = o->height;
        ground.extent_max[0] = o->size[0] * o->voxel[0];
        ground.extent_max[1] = o->size[second] * o->voxel[second];
        memcpy(ground.patches, o->patches, sizeof ground.patches);
        ground.horizon = o->horizon;
        ground.reflectance_image = o->reflectance;
        assert_int_equal(murk_ground_create(b->context, &ground, &b->ground), MURK_OK);
        b->patches = b->ground->patch_count;
    }
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    memcpy(options.window, o->window, sizeof options.window);
    assert_int_equal(
        murk_exchange_pairwise.init(b->context, b->medium, b->ground, &options, &b->operator),
        MURK_OK);
    const murk_grid *grid = b->medium->grid;
    b->slots = grid->brick_count * MURK_BRICK_SLOTS;
    for (size_t i = 0; i < b->slots; i++) {
        if (!murk_grid_active(grid, i / MURK_BRICK_SLOTS, (int)(i % MURK_BRICK_SLOTS)))
            continue;
        const int32_t at[3] = {(int32_t)(i / 64 % 8), (int32_t)(i / 8 % 8), (int32_t)(i % 8)};
        for (int a = 0; a < 3; a++)
            b->cell[b->zones][a] = grid->brick[i / MURK_BRICK_SLOTS][a] * 8 + at[a];
        b->slot[b->zones++] = i;
    }
}

static inline void close_box(box *b)
{
    murk_exchange_pairwise.release(b->operator);
    murk_ground_release(b->ground);
    murk_medium_release(b->medium);
    murk_context_release(b->context);
}

/* G x in compact numbering: net radiosity of zones, irradiance of patches. */
static inline double apply(box *b, const double *x, double sky, double horizon, double *y)
{
    float *zone = murk_alloc(2 * b->slots, sizeof *zone), *net = zone + b->slots;
    float *patch = murk_alloc(2 * b->patches, sizeof *patch), *irradiance = patch + b->patches;
    for (size_t k = 0; k < b->zones; k++)
        zone[b->slot[k]] = (float)x[k];
    for (size_t i = 0; i < b->patches; i++)
        patch[i] = (float)x[b->zones + i];
    murk_radiosity in = {
        .zone = zone, .patch = b->ground ? patch : NULL, .sky = sky, .horizon = horizon};
    murk_incident out = {.zone = net, .patch = b->ground ? irradiance : NULL};
    assert_int_equal(murk_exchange_pairwise.apply(b->context, b->operator, & in, &out, 1), MURK_OK);
    for (size_t k = 0; k < b->zones; k++)
        y[k] = net[b->slot[k]];
    for (size_t i = 0; i < b->patches; i++)
        y[b->zones + i] = irradiance[i];
    murk_free(zone);
    murk_free(patch);
    return out.net_power;
}

static inline double weight(const box *b, size_t e)
{
    if (e >= b->zones)
        return murk_ground_area(b->ground, e - b->zones);
    return 4.0 * b->medium->kappa_t[b->slot[e]] * b->medium->grid->volume;
}

/* Repeatable values in [0, 1) that are floats. */
static inline double noise(size_t i)
{
    return (double)(((uint32_t)i * 2654435761u) >> 12) / (1 << 20);
}

#endif
