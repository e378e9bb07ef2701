/* SPDX-License-Identifier: Apache-2.0 */
/* The operator of the paper and its iteration: identities, and the paper's own sample case. */
#include "gauss_seidel.h"
#include "pairwise.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#ifndef MURK_TEST_DATA
#define MURK_TEST_DATA "tests/physics/data"
#endif

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

static const box_options PAPER = {
    .size = {10, 10, 10}, .voxel = {0.1, 0.1, 0.05}, .kappa = 0.8, .patches = {10, 10}};

static void open_box(box *b, const box_options *o)
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

static void close_box(box *b)
{
    murk_exchange_pairwise.release(b->operator);
    murk_ground_release(b->ground);
    murk_medium_release(b->medium);
    murk_context_release(b->context);
}

/* G x in compact numbering: net radiosity of zones, irradiance of patches. */
static double apply(box *b, const double *x, double sky, double horizon, double *y)
{
    float *zone = murk_alloc(2 * b->slots, sizeof *zone), *net = zone + b->slots;
    float *patch = murk_alloc(2 * b->patches, sizeof *patch), *irradiance = patch + b->patches;
    for (size_t k = 0; k < b->zones; k++)
        zone[b->slot[k]] = (float)x[k];
    for (size_t i = 0; i < b->patches; i++)
        patch[i] = (float)x[b->zones + i];
    murk_radiosity in = {zone, b->ground ? patch : NULL, sky, horizon};
    murk_incident out = {net, b->ground ? irradiance : NULL, 0};
    assert_int_equal(murk_exchange_pairwise.apply(b->context, b->operator, & in, &out), MURK_OK);
    for (size_t k = 0; k < b->zones; k++)
        y[k] = net[b->slot[k]];
    for (size_t i = 0; i < b->patches; i++)
        y[b->zones + i] = irradiance[i];
    murk_free(zone);
    murk_free(patch);
    return out.net_power;
}

static double weight(const box *b, size_t e)
{
    if (e >= b->zones)
        return murk_ground_area(b->ground, e - b->zones);
    return 4.0 * b->medium->kappa_t[b->slot[e]] * b->medium->grid->volume;
}

/* Repeatable values in [0, 1) that are floats. */
static double noise(size_t i)
{
    return (double)(((uint32_t)i * 2654435761u) >> 12) / (1 << 20);
}

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

typedef struct paper_error {
    double zones, patches;
    int iterations;
} paper_error;

/* Relative L2 errors against the reference; *x gets the radiosities if not NULL. */
static paper_error solve_paper(const box_options *options, double *result)
{
    box_options o = *options;
    float reflectance[100];
    for (int i = 0; i < 100; i++)
        reflectance[i] = i / 10 >= 3 && i / 10 < 7 && i % 10 >= 3 && i % 10 < 7 ? 0.6f : 0.3f;
    o.reflectance = reflectance;
    box b;
    open_box(&b, &o);
    size_t n = b.zones + b.patches;
    double *source = murk_alloc(2 * n, sizeof *source), *x = source + n;
    double layer = 0.8 * 0.05; /* the sun overhead: exp(-depth), averaged over each layer */
    for (size_t k = 0; k < b.zones; k++)
        source[k] = 0.625 / 4 * exp(-layer * (9 - b.cell[k][2])) * -expm1(-layer) / layer;
    for (size_t i = 0; i < b.patches; i++)
        source[b.zones + i] = b.ground->reflectance[i] * exp(-10 * layer);
    memcpy(x, source, n * sizeof *x);
    paper_error error = {0};
    double change;
    assert_int_equal(murk_gauss_seidel(b.context, &murk_exchange_pairwise, b.operator, b.medium,
                                       b.ground, source, 1e-9, 100, x, &error.iterations, &change),
                     MURK_OK);
    assert_true(change < 1e-9);
    FILE *file = fopen(MURK_TEST_DATA "/paper_box.csv", "r");
    assert_non_null(file);
    char line[256];
    double sums[2][2] = {{0, 0}, {0, 0}};
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        char type;
        int i, j, k;
        double wanted;
        assert_int_equal(sscanf(line, "%c,%d,%d,%d,%lf", &type, &i, &j, &k, &wanted), 5);
        size_t e = b.zones + (size_t)(10 * j + i);
        for (size_t z = 0; type == 'V' && z < b.zones; z++)
            if (b.cell[z][0] == i && b.cell[z][1] == j && b.cell[z][2] == k)
                e = z;
        sums[type == 'V'][0] += (x[e] - wanted) * (x[e] - wanted);
        sums[type == 'V'][1] += wanted * wanted;
    }
    fclose(file);
    error.zones = sqrt(sums[1][0] / sums[1][1]);
    error.patches = sqrt(sums[0][0] / sums[0][1]);
    if (result)
        memcpy(result, x, n * sizeof *x);
    murk_free(source);
    close_box(&b);
    return error;
}

static void paper_by_offset(void **state)
{
    (void)state;
    paper_error error = solve_paper(&PAPER, NULL);
    print_message("error of zones %.4f %%, patches %.4f %%, %d iterations\n", 100 * error.zones,
                  100 * error.patches, error.iterations);
    assert_true(error.zones < 0.0005);
    assert_true(error.patches < 0.0005);
    assert_in_range(error.iterations, 5, 16);
}

static void paper_zone_by_zone(void **state)
{
    (void)state;
    box_options o = PAPER;
    static double table[1100], matrix[1100];
    o.perturb = true;
    paper_error error = solve_paper(&o, matrix);
    print_message("error of zones %.4f %%, patches %.4f %%, %d iterations\n", 100 * error.zones,
                  100 * error.patches, error.iterations);
    assert_true(error.zones < 0.0015);
    assert_true(error.patches < 0.0015);
    solve_paper(&PAPER, table);
    for (size_t e = 0; e < 1100; e++)
        assert_true(fabs(matrix[e] - table[e]) < 0.005 * table[e]);
}

/* A window that holds everything changes nothing; a smaller one loses light. */
static void window(void **state)
{
    (void)state;
    static double full[1100], cut[1100], wide[1100];
    box_options o = PAPER;
    solve_paper(&o, full);
    for (int a = 0; a < 3; a++)
        o.window[a] = 20;
    solve_paper(&o, wide);
    for (int a = 0; a < 3; a++)
        o.window[a] = 6;
    solve_paper(&o, cut);
    double loss = 0;
    for (size_t e = 0; e < 1100; e++) {
        assert_true(fabs(wide[e] - full[e]) < 1e-12);
        assert_true(cut[e] < full[e]);
        loss = fmax(loss, 1 - cut[e] / full[e]);
    }
    assert_true(loss > 0.01 && loss < 0.2);
}

/* Four quarters of a patch, which are not by offset, receive what the whole does. */
static void patches_in_parts(void **state)
{
    (void)state;
    box_options o = PAPER;
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
        cmocka_unit_test(identities),      cmocka_unit_test(random_medium),
        cmocka_unit_test(paper_by_offset), cmocka_unit_test(paper_zone_by_zone),
        cmocka_unit_test(window),          cmocka_unit_test(patches_in_parts),
        cmocka_unit_test(turned),          cmocka_unit_test(too_many_factors),
        cmocka_unit_test(no_zones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
