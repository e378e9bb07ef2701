/* SPDX-License-Identifier: Apache-2.0 */
/* What exchange.h promises of every method, on a table of small media. */
#include "bench.h"

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

/* Bands at once are what each is alone. */
static void check_bands(const struct bench *b, const struct scene *scene)
{
    (void)scene;
    uint64_t random = 23;
    struct element_values in[MURK_MOST_BANDS], out[MURK_MOST_BANDS], alone = make_values(b);
    murk_radiosity light[MURK_MOST_BANDS];
    murk_incident incident[MURK_MOST_BANDS];
    for (int n = 0; n < MURK_MOST_BANDS; n++) {
        in[n] = some_values(b, &random);
        out[n] = make_values(b);
        light[n] = (murk_radiosity){.zone = n == 1 ? NULL : in[n].zone,
                                    .patch = b->patches && n < 2 ? in[n].patch : NULL,
                                    .sky = 0.3 * n,
                                    .horizon = 0.1};
        incident[n] =
            (murk_incident){.zone = out[n].zone, .patch = b->patches ? out[n].patch : NULL};
    }
    assert_int_equal(
        b->method->apply(b->world.context, b->operator, light, incident, MURK_MOST_BANDS), MURK_OK);
    for (int n = 0; n < MURK_MOST_BANDS; n++) {
        murk_incident one = {.zone = alone.zone, .patch = b->patches ? alone.patch : NULL};
        assert_int_equal(b->method->apply(b->world.context, b->operator, & light[n], &one, 1),
                         MURK_OK);
        assert_within(incident[n].net_power, one.net_power, 1e-6 * (1 + fabs(one.net_power)));
        for (size_t i = 0; i < b->slots; i++)
            if (b->world.medium->kappa_t[i] > 0)
                assert_within(out[n].zone[i], alone.zone[i], 1e-6);
        for (size_t i = 0; i < b->patches; i++)
            assert_within(out[n].patch[i], alone.patch[i], 1e-6);
        drop_values(&in[n]);
        drop_values(&out[n]);
    }
    drop_values(&alone);
}

/* All checks of one method for every scene. */
static void check_method(const murk_exchange_method *method)
{
    static void (*const checks[])(const struct bench *, const struct scene *) = {
        check_reciprocity, check_rows, check_power, check_ground, check_single_rows, check_bands};
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines),
        cmocka_unit_test(pairwise),
        cmocka_unit_test(bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
