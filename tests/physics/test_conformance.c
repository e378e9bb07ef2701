/* SPDX-License-Identifier: Apache-2.0 */
/* What exchange.h promises of every method, on a table of small media. */
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

static void open_bench(struct bench *b, const struct scene *s, const murk_exchange_method *method,
                       int directions, int rays)
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

static void close_bench(struct bench *b)
{
    b->method->release(b->operator);
    world_close(&b->world);
}

/* Zones and patches together; the weights of exchange.h. */
struct element_values {
    float *zone, *patch;
};

static struct element_values make_values(const struct bench *b)
{
    return (struct element_values){murk_alloc(b->slots, sizeof(float)),
                                   murk_alloc(b->patches, sizeof(float))};
}

static void drop_values(struct element_values *v)
{
    murk_free(v->zone);
    murk_free(v->patch);
}

static double zone_weight(const struct bench *b, size_t slot)
{
    return 4.0 * b->world.medium->kappa_t[slot] * b->world.medium->grid->volume;
}

/* Random values in [0, 1], or all 1. */
static struct element_values some_values(const struct bench *b, uint64_t *random)
{
    struct element_values v = make_values(b);
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0)
            v.zone[i] = random ? (float)check_random(random) : 1;
    for (size_t i = 0; i < b->patches; i++)
        v.patch[i] = random ? (float)check_random(random) : 1;
    return v;
}

static double apply(const struct bench *b, const struct element_values *in, double sky,
                    double horizon, struct element_values *out)
{
    const murk_radiosity radiosity = {in ? in->zone : NULL, in && b->patches ? in->patch : NULL,
                                      sky, horizon};
    murk_incident incident = {out->zone, b->patches ? out->patch : NULL, 0};
    if (b->method->apply(b->world.context, b->operator, & radiosity, &incident))
        fail_msg("%s", murk_context_message(b->world.context));
    return incident.net_power;
}

/* <u, v>_w over zones and patches, or with absolute values. */
static double product(const struct bench *b, const struct element_values *u,
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

/* <u, G v> = <G u, v>, to the rounding of floats in G u. */
static void check_reciprocity(const struct bench *b, const struct scene *scene)
{
    (void)scene;
    uint64_t random = 13;
    struct element_values u = some_values(b, &random), v = some_values(b, &random);
    struct element_values gu = make_values(b), gv = make_values(b);
    apply(b, &u, 0, 0, &gu);
    apply(b, &v, 0, 0, &gv);
    assert_within(product(b, &u, &gv, false), product(b, &gu, &v, false),
                  1e-5 * product(b, &u, &gv, true));
    drop_values(&u);
    drop_values(&v);
    drop_values(&gu);
    drop_values(&gv);
}

/* Everything at radiosity 1: a zone gains nothing, a patch receives 1. A bounded ground has nothing
   around it that could radiate. */
static void check_rows(const struct bench *b, const struct scene *scene)
{
    if (scene->patches[0] && !scene->horizon)
        return;
    struct element_values ones = some_values(b, NULL), out = make_values(b);
    double net = apply(b, &ones, 1, 1, &out);
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0)
            assert_within(out.zone[i], 0, 1e-5);
    for (size_t i = 0; i < b->patches; i++)
        assert_within(out.patch[i], 1, 1e-5);
    assert_within(net, 0, 1e-5 * product(b, &ones, &ones, false));
    drop_values(&ones);
    drop_values(&out);
}

/* The power that crosses the boundary inwards is what the zones gain. */
static void check_power(const struct bench *b, const struct scene *scene)
{
    (void)scene;
    uint64_t random = 14;
    struct element_values in = some_values(b, &random), out = make_values(b), ones = make_values(b);
    for (size_t i = 0; i < b->slots; i++)
        ones.zone[i] = 1;
    for (int light = 0; light < 3; light++) { /* zones and patches, the sky alone, all */
        double net =
            apply(b, light == 1 ? NULL : &in, light > 0 ? 0.7 : 0, light > 0 ? 0.2 : 0, &out);
        assert_within(net, product(b, &ones, &out, false), 1e-5 * product(b, &ones, &out, true));
    }
    drop_values(&in);
    drop_values(&out);
    drop_values(&ones);
}

/* What the ground gets from the zones is what they send down: sum of A H = <1 on patches, G v>
   = <G 1 on patches, v>, a sum over zones. All is positive. */
static void check_ground(const struct bench *b, const struct scene *scene)
{
    (void)scene;
    if (!b->patches)
        return;
    uint64_t random = 15;
    struct element_values v = some_values(b, &random), ground = make_values(b),
                          out = make_values(b);
    memset(v.patch, 0, b->patches * sizeof(float));
    for (size_t i = 0; i < b->patches; i++)
        ground.patch[i] = 1;
    apply(b, &v, 0, 0, &out);
    double down = 0, received = 0, sent = 0;
    for (size_t i = 0; i < b->patches; i++) {
        assert_true(out.patch[i] >= 0);
        down += murk_ground_area(b->world.ground, i) * out.patch[i];
    }
    apply(b, &ground, 0, 0, &out);
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0) {
            assert_true(out.zone[i] >= 0);
            received += zone_weight(b, i) * out.zone[i] * v.zone[i];
            sent += zone_weight(b, i) * v.zone[i];
        }
    for (size_t i = 0; i < b->patches; i++)
        assert_within(out.patch[i], 0, 0); /* a plane does not see itself */
    assert_within(down, received, 1e-5 * down);
    /* Not more than half of what a zone emits goes down. */
    assert_true(down > 0 && down < sent / 2);
    drop_values(&v);
    drop_values(&ground);
    drop_values(&out);
}

/* A bounded ground is one with a horizon whose outer patches are dark. */
static void bounded(void **state)
{
    (void)state;
    static const murk_exchange_method *const methods[] = {&murk_exchange_lines,
                                                          &murk_exchange_pairwise};
    /* The stored factors of the outer patches are not exact, and each row sums to 1. */
    static const double tolerance[] = {1e-5, 5e-3};
    static struct bench with, without;
    for (size_t m = 0; m < 2; m++) {
        struct scene scene = SCENES[SCENE_COUNT - 1];
        open_bench(&without, &scene, methods[m], 96, 1);
        scene.horizon = true;
        open_bench(&with, &scene, methods[m], 96, 1);
        uint64_t random = 16;
        struct element_values in = some_values(&without, &random), out = make_values(&without);
        struct element_values wide = make_values(&with), wide_out = make_values(&with);
        memcpy(wide.zone, in.zone, with.slots * sizeof(float));
        const murk_ground *ground = with.world.ground;
        for (int ib = 0; ib < scene.patches[1]; ib++)
            for (int ia = 0; ia < scene.patches[0]; ia++)
                wide.patch[murk_ground_interior(ground, ia, ib)] =
                    in.patch[ib * scene.patches[0] + ia];
        print_message("%s\n", methods[m]->name);
        apply(&without, &in, 1, 0, &out);
        apply(&with, &wide, 1, 0, &wide_out);
        for (size_t i = 0; i < with.slots; i++)
            if (with.world.medium->kappa_t[i] > 0)
                assert_within(wide_out.zone[i], out.zone[i], tolerance[m]);
        for (int ib = 0; ib < scene.patches[1]; ib++)
            for (int ia = 0; ia < scene.patches[0]; ia++)
                assert_within(wide_out.patch[murk_ground_interior(ground, ia, ib)],
                              out.patch[ib * scene.patches[0] + ia], tolerance[m]);
        drop_values(&in);
        drop_values(&out);
        drop_values(&wide);
        drop_values(&wide_out);
        close_bench(&with);
        close_bench(&without);
    }
}

/* A row is a line of the matrix that apply() multiplies by. */
static void check_single_rows(const struct bench *b, const struct scene *scene)
{
    (void)scene;
    if (!b->method->row)
        return;
    uint64_t random = 17;
    struct element_values in = some_values(b, &random), out = make_values(b);
    size_t zones = b->world.medium->grid->zone_count, n = 0;
    double *x = murk_alloc(zones + b->patches, sizeof *x);
    for (size_t i = 0; i < b->slots; i++)
        if (b->world.medium->kappa_t[i] > 0)
            x[n++] = in.zone[i];
    for (size_t i = 0; i < b->patches; i++)
        x[n++] = in.patch[i];
    apply(b, &in, 0, 0, &out);
    n = 0;
    for (size_t i = 0; i < b->slots + b->patches; i++) {
        if (i < b->slots && !(b->world.medium->kappa_t[i] > 0))
            continue;
        double self, row = b->method->row(b->operator, n, x, &self);
        if (i < b->slots)
            assert_within(row + (self - 1) * x[n], out.zone[i], 1e-5);
        else
            assert_within(row + self * x[n], out.patch[i - b->slots], 1e-5);
        n++;
    }
    murk_free(x);
    drop_values(&in);
    drop_values(&out);
}

/* All checks of one method for every scene. */
static void check_method(const murk_exchange_method *method)
{
    static void (*const checks[])(const struct bench *, const struct scene *) = {
        check_reciprocity, check_rows, check_power, check_ground, check_single_rows};
    static struct bench bench;
    for (int s = 0; s < SCENE_COUNT; s++) {
        print_message("%s\n", SCENES[s].name);
        open_bench(&bench, &SCENES[s], method, 96, s % 4 == 3 ? 2 : 1);
        for (size_t n = 0; n < sizeof checks / sizeof *checks; n++)
            checks[n](&bench, &SCENES[s]);
        close_bench(&bench);
    }
}

static void lines(void **state)
{
    (void)state;
    check_method(&murk_exchange_lines);
}

static void pairwise(void **state)
{
    (void)state;
    check_method(&murk_exchange_pairwise);
}

/* Radiosities that vary smoothly from zone to zone, as solutions do. */
static struct element_values smooth_values(const struct bench *b)
{
    struct element_values v = make_values(b);
    const murk_grid *grid = b->world.medium->grid;
    for (size_t i = 0; i < b->slots; i++) {
        const int32_t *brick = grid->brick[i / MURK_BRICK_SLOTS];
        double x = 8 * brick[0] + (int)(i / 64 % 8), y = 8 * brick[1] + (int)(i / 8 % 8),
               z = 8 * brick[2] + (int)(i % 8);
        if (b->world.medium->kappa_t[i] > 0)
            v.zone[i] = (float)(1 + 0.5 * sin(0.7 * x + 0.3 * y - 0.4 * z));
    }
    for (size_t i = 0; i < b->patches; i++)
        v.patch[i] = (float)(1 + 0.5 * sin(0.1 * (double)i));
    return v;
}

static bool is_interior(const murk_ground *ground, size_t patch)
{
    int ia = (int)(patch % (size_t)ground->count[0]) - ground->margin;
    int ib = (int)(patch / (size_t)ground->count[0]) - ground->margin;
    return ia >= 0 && ia < ground->interior[0] && ib >= 0 && ib < ground->interior[1];
}

/* The methods share no line of code for their factors. G/4 of all zones, and H of the patches under
   the medium, differ by the error of the lines: with 1, 2 and 4 rays a face 0.15, 0.05 and 0.01 %
   in the box, 0.6, 0.2 and 0.1 % in the sparse medium; with 384 and 1536 directions 0.8 and 0.3 %
   where patches of different brightness are seen from above. */
static void agreement(void **state)
{
    (void)state;
    static const int scenes[] = {0, 3, 5, 8, 9};
    static struct bench lit, paired;
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        print_message("%s\n", SCENES[scenes[s]].name);
        open_bench(&lit, &SCENES[scenes[s]], &murk_exchange_lines, 1536, 2);
        open_bench(&paired, &SCENES[scenes[s]], &murk_exchange_pairwise, 0, 0);
        struct element_values in = smooth_values(&lit), a = make_values(&lit),
                              b = make_values(&lit);
        apply(&lit, &in, 0.5, 0.3, &a);
        apply(&paired, &in, 0.5, 0.3, &b);
        double zone[2] = {0}, patch[2] = {0};
        for (size_t i = 0; i < lit.slots; i++) {
            double weight = zone_weight(&lit, i), incident = a.zone[i] + in.zone[i];
            if (weight > 0) {
                zone[0] += weight * pow(a.zone[i] - b.zone[i], 2);
                zone[1] += weight * pow(incident, 2);
            }
        }
        for (size_t i = 0; i < lit.patches; i++)
            if (is_interior(lit.world.ground, i)) {
                patch[0] += pow(a.patch[i] - b.patch[i], 2);
                patch[1] += pow(a.patch[i], 2);
            }
        print_message("zones %.2g patches %.2g\n", sqrt(zone[0] / zone[1]),
                      sqrt(patch[0] / fmax(patch[1], 1e-30)));
        assert_at_most(sqrt(zone[0] / zone[1]), 0.005);
        assert_at_most(sqrt(patch[0] / fmax(patch[1], 1e-30)), 0.005);
        drop_values(&in);
        drop_values(&a);
        drop_values(&b);
        close_bench(&lit);
        close_bench(&paired);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines),
        cmocka_unit_test(pairwise),
        cmocka_unit_test(bounded),
        cmocka_unit_test(agreement),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
