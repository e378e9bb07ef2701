/* SPDX-License-Identifier: Apache-2.0 */
/* Small media of many kinds, and exchange operators on them. */
#ifndef BENCH_H
#define BENCH_H

#include "check.h"
#include "lines.h"
#include "pairwise.h"

enum { MOST = 1200 };

/* A medium and its ground. kappa_t of a voxel is depth / voxel[0] where `filled` is 1; else it is 0
   with the probability 1 - filled and varies up to that. */
struct scene {
    const char *name;
    int32_t size[3];
    double voxel[3];
    double depth, filled;
    int patches[2]; /* 0: no ground */
    double gap;     /* between ground and medium [m] */
    bool horizon;
    murk_up up;
};

static const struct scene SCENES[] = {
    {"box", {5, 6, 7}, {0.1, 0.1, 0.1}, 0.08, 1, {0, 0}, 0, false, MURK_UP_Z},
    {"box on ground", {6, 5, 4}, {0.1, 0.1, 0.1}, 0.08, 1, {6, 5}, 0, true, MURK_UP_Z},
    {"box over ground, y up", {5, 4, 6}, {0.1, 0.1, 0.1}, 0.3, 1, {4, 3}, 0.15, true, MURK_UP_Y},
    {"sparse", {10, 9, 12}, {0.1, 0.1, 0.1}, 0.6, 0.4, {0, 0}, 0, false, MURK_UP_Z},
    {"sparse on ground", {9, 8, 5}, {0.1, 0.1, 0.1}, 0.6, 0.5, {5, 4}, 0, true, MURK_UP_Z},
    {"sparse over ground", {6, 9, 8}, {0.1, 0.1, 0.1}, 0.6, 0.5, {3, 6}, 0.2, true, MURK_UP_Z},
    {"flat voxels", {8, 7, 6}, {0.2, 0.1, 0.05}, 0.8, 0.6, {6, 6}, 0.05, true, MURK_UP_Z},
    {"thin", {6, 6, 6}, {0.1, 0.1, 0.1}, 1e-3, 0.7, {4, 4}, 0.02, true, MURK_UP_Z},
    {"thick", {6, 6, 6}, {0.1, 0.1, 0.1}, 20, 0.7, {4, 4}, 0.02, true, MURK_UP_Z},
    {"bounded ground", {6, 5, 4}, {0.1, 0.1, 0.1}, 0.5, 0.7, {5, 5}, 0.1, false, MURK_UP_Z},
};

enum { SCENE_COUNT = sizeof SCENES / sizeof *SCENES };

/* A scene with the operator of one method. */
struct bench {
    struct world world;
    const murk_exchange_method *method;
    void *operator;
    size_t slots, patches;
    float kappa_t[MOST];
};

static inline void open_bench(struct bench *b, const struct scene *s,
                              const murk_exchange_method *method, int directions, int rays)
{
    uint64_t random = 12;
    murk_array array = {.kappa_t = b->kappa_t, .albedo_value = 0.5};
    for (int a = 0; a < 3; a++) {
        array.size[a] = s->size[a];
        array.voxel_size[a] = s->voxel[a];
    }
    assert_true(check_count(&array) <= MOST);
    for (size_t i = 0; i < check_count(&array); i++) {
        double x = s->filled < 1 ? check_random(&random) / s->filled : 1;
        b->kappa_t[i] = x <= 1 ? (float)(s->depth / s->voxel[0] * x) : 0;
    }
    int second = s->up == MURK_UP_Z ? 1 : 2;
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.up = s->up;
    ground.height = -s->gap;
    ground.horizon = s->horizon;
    ground.extent_max[0] = s->size[0] * s->voxel[0];
    ground.extent_max[1] = s->size[second] * s->voxel[second];
    memcpy(ground.patches, s->patches, sizeof ground.patches);
    world_open(&b->world, 2, &array, s->patches[0] ? &ground : NULL);
    b->method = method;
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = directions;
    options.rays = rays;
    if (method->init(b->world.context, b->world.medium, b->world.ground, &options, &b->operator))
        fail_msg("%s", murk_context_message(b->world.context));
    b->slots = b->world.medium->grid->brick_count * MURK_BRICK_SLOTS;
    b->patches = b->world.ground ? b->world.ground->patch_count : 0;
}

static inline void close_bench(struct bench *b)
{
    b->method->release(b->operator);
    world_close(&b->world);
}

/* Zones and patches together; the weights of exchange.h. */
struct element_values {
    float *zone, *patch;
};

static inline struct element_values make_values(const struct bench *b)
{
    return (struct element_values){murk_alloc(b->slots, sizeof(float)),
                                   murk_alloc(b->patches, sizeof(float))};
}

static inline void drop_values(struct element_values *v)
{
    murk_free(v->zone);
    murk_free(v->patch);
}

static inline double zone_weight(const struct bench *b, size_t slot)
{
    return 4.0 * b->world.medium->kappa_t[slot] * b->world.medium->grid->volume;
}

/* Random values in [0, 1], or all 1. */
static inline struct element_values some_values(const struct bench *b, uint64_t *random)
{
    struct element_values v = make_values(b);
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0)
            v.zone[i] = random ? (float)check_random(random) : 1;
    for (size_t i = 0; i < b->patches; i++)
        v.patch[i] = random ? (float)check_random(random) : 1;
    return v;
}

static inline double apply(const struct bench *b, const struct element_values *in, double sky,
                           double horizon, struct element_values *out)
{
    const murk_radiosity radiosity = {.zone = in ? in->zone : NULL,
                                      .patch = in && b->patches ? in->patch : NULL,
                                      .sky = sky,
                                      .horizon = horizon};
    murk_incident incident = {.zone = out->zone, .patch = b->patches ? out->patch : NULL};
    if (b->method->apply(b->world.context, b->operator, & radiosity, &incident, 1))
        fail_msg("%s", murk_context_message(b->world.context));
    return incident.net_power;
}

/* <u, v>_w over zones and patches, or with absolute values. */
static inline double product(const struct bench *b, const struct element_values *u,
                             const struct element_values *v, bool absolute)
{
    double sum = 0;
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0) {
            double term = zone_weight(b, i) * u->zone[i] * v->zone[i];
            sum += absolute ? fabs(term) : term;
        }
    for (size_t i = 0; i < b->patches; i++) {
        double term = murk_ground_area(b->world.ground, i) * u->patch[i] * v->patch[i];
        sum += absolute ? fabs(term) : term;
    }
    return sum;
}

#endif
