/* SPDX-License-Identifier: Apache-2.0 */
/* The operator of the paper: identities, and one way of computing a factor against another. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "exchange_box.h"

static void check_identities(const box_options *o, double tolerance)
{
    box b;
    open_box(&b, o);
    size_t n = b.zones + b.patches;
    double *u = murk_alloc(5 * n, sizeof *u), *v = u + n, *gu = v + n, *gv = gu + n, *x = gv + n;
    for (size_t e = 0; e < n; e++) {
        u[e] = noise(e);
        v[e] = noise(e + 7919);
        x[e] = 1;
    }
    apply(&b, u, 0, 0, gu);
    double power = apply(&b, v, 0, 0, gv), one = 0, other = 0, sum = 0, size = 0;
    for (size_t e = 0; e < n; e++) {
        size += weight(&b, e) * (u[e] + v[e]);
        one += weight(&b, e) * u[e] * gv[e];
        other += weight(&b, e) * v[e] * gu[e];
        sum += e < b.zones ? weight(&b, e) * gv[e] : 0;
    }
    assert_true(fabs(one - other) <= 1e-6 * size);
    assert_true(fabs(power - sum) <= 1e-5 * fabs(sum) + 1e-6);
    for (size_t e = 0; e < n; e += 1 + n / 97) { /* a row is what apply says it is */
        double self, row = murk_exchange_pairwise.row(b.operator, e, v, &self);
        double net = row + (e < b.zones ? (self - 1) * v[e] : 0);
        assert_true(fabs(net - gv[e]) <= 1e-6);
    }
    if (tolerance > 0) { /* an isothermal enclosure stays as it is */
        power = apply(&b, x, 1, 1, gv);
        for (size_t e = 0; e < n; e++)
            assert_true(fabs(gv[e] - (e < b.zones ? 0 : 1)) <= tolerance);
        assert_true(fabs(power) <= tolerance);
    }
    murk_free(u);
    close_box(&b);
}

static void identities(void **state)
{
    (void)state;
    const box_options small = {.size = {5, 7, 4},
                               .voxel = {0.1, 0.1, 0.05},
                               .kappa = 3,
                               .patches = {5, 7},
                               .horizon = true};
    box_options o = small;
    check_identities(&o, 1e-6); /* by offset, margin patches zone by zone */
    o.perturb = true;
    check_identities(&o, 1e-6);
    o.perturb = false;
    o.height = -0.03;
    check_identities(&o, 1e-6);
    o.height = 0.07; /* through the zones */
    check_identities(&o, 1e-6);
    o = small;
    o.patches[0] = 0; /* no ground */
    check_identities(&o, 1e-6);
    o.kappa = 500;
    check_identities(&o, 1e-6);
    o = small;
    o.up = MURK_UP_Y;
    o.patches[1] = 4;
    check_identities(&o, 1e-6);
    o = small;
    o.window[0] = 4;
    o.window[1] = 3;
    o.window[2] = 2;
    check_identities(&o, 0);
    o.perturb = true;
    check_identities(&o, 0);
}

static void random_medium(void **state)
{
    (void)state;
    float kappa[6 * 5 * 7];
    for (size_t i = 0; i < 6 * 5 * 7; i++)
        kappa[i] = noise(i) < 0.3 ? 0 : (float)(20 * pow(noise(i + 1), 3));
    const box_options o = {.size = {6, 5, 7},
                           .voxel = {0.1, 0.08, 0.1},
                           .kappa_t = kappa,
                           .patches = {4, 3},
                           .horizon = true};
    check_identities(&o, 1e-6);
}

/* Four quarters of a patch, which are not by offset, receive what the whole does. */
static void patches_in_parts(void **state)
{
    (void)state;
    box_options o = PAPER_BOX;
    box whole, parts;
    double *x = murk_alloc(3 * 2048, sizeof *x), *h = x + 2048, *quarter = h + 2048;
    for (size_t k = 0; k < 1000; k++)
        x[k] = noise(k);
    open_box(&whole, &o);
    o.patches[0] = o.patches[1] = 20;
    open_box(&parts, &o);
    apply(&whole, x, 1, 0, h);
    apply(&parts, x, 1, 0, quarter);
    for (size_t i = 0; i < 100; i++) {
        size_t first = 1000 + 2 * (i / 10) * 20 + 2 * (i % 10);
        double mean =
            (quarter[first] + quarter[first + 1] + quarter[first + 20] + quarter[first + 21]) / 4;
        assert_true(fabs(mean - h[1000 + i]) < 0.001 * h[1000 + i]);
    }
    close_box(&whole);
    close_box(&parts);
    murk_free(x);
}

/* A box of 10 x 10 x 10 cubes turned on its side. */
static void turned(void **state)
{
    (void)state;
    box_options o = {.size = {6, 5, 4}, .voxel = {0.1, 0.1, 0.1}, .kappa = 2, .patches = {6, 5}};
    box upright, lying;
    double x[150], y[150], h[150], turned_h[150];
    open_box(&upright, &o);
    o.size[1] = 4;
    o.size[2] = 5;
    o.up = MURK_UP_Y;
    open_box(&lying, &o);
    for (size_t k = 0; k < 120; k++) {
        const int32_t *c = upright.cell[k], *d = lying.cell[k];
        x[k] = noise((size_t)(c[0] * 100 + c[1] * 10 + c[2]));
        y[k] = noise((size_t)(d[0] * 100 + d[2] * 10 + d[1]));
    }
    for (size_t i = 120; i < 150; i++)
        x[i] = y[i] = noise(5000 + i);
    apply(&upright, x, 0.5, 0, h);
    apply(&lying, y, 0.5, 0, turned_h);
    for (size_t k = 0; k < 120; k++)
        for (size_t j = 0; j < 120; j++) {
            const int32_t *c = upright.cell[k], *d = lying.cell[j];
            if (c[0] == d[0] && c[1] == d[2] && c[2] == d[1]) /* the sky is by different lines */
                assert_true(fabs(h[k] - turned_h[j]) < 2e-3);
        }
    for (size_t i = 120; i < 150; i++)
        assert_true(fabs(h[i] - turned_h[i]) < 1e-6);
    close_box(&upright);
    close_box(&lying);
}

static void too_many_factors(void **state)
{
    (void)state;
    murk_context *context;
    murk_medium *medium;
    void *operator= NULL;
    assert_int_equal(murk_context_create(NULL, &context), MURK_OK);
    size_t count = 40 * 40 * 40;
    float *kappa = murk_alloc(count, sizeof *kappa);
    for (size_t i = 0; i < count; i++)
        kappa[i] = 1 + (float)noise(i);
    murk_array array = {.size = {40, 40, 40}, .voxel_size = {1, 1, 1}, .kappa_t = kappa};
    assert_int_equal(murk_medium_from_array(context, &array, &medium), MURK_OK);
    assert_int_equal(murk_exchange_pairwise.init(context, medium, NULL, NULL, &operator),
                     MURK_ERROR_INPUT);
    assert_null(operator);
    assert_non_null(strstr(murk_context_message(context), "lines"));
    murk_free(kappa);
    murk_medium_release(medium);
    murk_context_release(context);
}

static void no_zones(void **state)
{
    (void)state;
    const float empty[8] = {0};
    const box_options o = {
        .size = {2, 2, 2}, .voxel = {1, 1, 1}, .kappa_t = empty, .patches = {3, 2}};
    box b;
    double x[6] = {1, 1, 1, 1, 1, 1}, h[6];
    open_box(&b, &o);
    assert_int_equal(b.zones, 0);
    assert_true(apply(&b, x, 2, 0, h) == 0);
    for (int i = 0; i < 6; i++)
        assert_true(h[i] == 2);
    close_box(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identities),       cmocka_unit_test(random_medium),
        cmocka_unit_test(patches_in_parts), cmocka_unit_test(turned),
        cmocka_unit_test(too_many_factors), cmocka_unit_test(no_zones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
