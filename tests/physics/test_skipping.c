/* SPDX-License-Identifier: Apache-2.0 */
/* What a scene does not need is left out; each time that changes the result by less than the
   tolerance, and the report says it. */
#include "check.h"

enum { EDGE = 44, CLOUD = EDGE * EDGE * EDGE };

/* A ball whose extinction varies smoothly, `depth` optical depths a voxel at its centre, moved by
   `shift` voxels along x, in a box of `edge` voxels from corner `at` on. */
static void fill_ball(float *kappa_t, int edge, int at, double depth, double shift)
{
    memset(kappa_t, 0, (size_t)edge * (size_t)edge * (size_t)edge * sizeof *kappa_t);
    for (int n = 0; n < CLOUD; n++) {
        const int in[3] = {n / EDGE / EDGE, n / EDGE % EDGE, n % EDGE};
        double r2 = 0;
        for (int a = 0; a < 3; a++)
            r2 += pow((in[a] + 0.5 - (a ? 0 : shift)) / (EDGE / 2.0) - 1, 2);
        double ripple = 1 + 0.5 * sin(0.7 * in[0]) * sin(0.9 * in[1]) * sin(0.8 * in[2]);
        size_t to = ((size_t)(in[0] + at) * (size_t)edge + (size_t)(in[1] + at)) * (size_t)edge +
                    (size_t)(in[2] + at);
        kappa_t[to] = r2 < 1 ? (float)(depth / 0.1 * (1.02 - r2) * ripple) : 0;
    }
}

static murk_array array_of(const float *kappa_t, int edge, int at, double albedo)
{
    return (murk_array){.size = {edge, edge, edge},
                        .voxel_size = {0.1, 0.1, 0.1},
                        .origin = {-0.1 * at, -0.1 * at, -0.1 * at},
                        .kappa_t = kappa_t,
                        .albedo_value = albedo};
}

static const murk_sun SUN = {{0.48, -0.36, -0.8}, 3};

static murk_ground_options wide_ground(void)
{
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.height = -0.2;
    ground.extent_max[0] = ground.extent_max[1] = 0.1 * EDGE;
    ground.patches[0] = ground.patches[1] = 24;
    return ground;
}

/* All zones of a solution, NaN elsewhere; to be freed. */
static float *zones_of(const struct world *w, const float *kappa_t, int edge)
{
    size_t count = (size_t)edge * (size_t)edge * (size_t)edge;
    float *b = malloc(count * sizeof *b);
    assert_non_null(b);
    for (size_t n = 0; n < count; n++) {
        int32_t i = (int32_t)n;
        b[n] = kappa_t[n] > 0 ? (float)world_b(w, i / edge / edge, i / edge % edge, i % edge) : NAN;
    }
    return b;
}

/* Relative difference in the norm of the tolerance. */
static double differ(const float *kappa_t, const float *b, const float *reference, size_t count)
{
    double difference = 0, size = 0;
    for (size_t n = 0; n < count; n++)
        if (kappa_t[n] > 0) {
            difference += kappa_t[n] * pow(b[n] - reference[n], 2);
            size += kappa_t[n] * pow(reference[n], 2);
        }
    return sqrt(difference / size);
}

static float *solve_ball(struct world *w, const float *kappa_t, double albedo,
                         const murk_solve_options *options)
{
    murk_ground_options ground = wide_ground();
    const murk_array array = array_of(kappa_t, EDGE, 0, albedo);
    world_open(w, 2, &array, &ground);
    w->scene.sun = SUN;
    w->scene.sky_radiance = 0.2;
    world_solve(w, options);
    return zones_of(w, kappa_t, EDGE);
}

/* A box 8 times as large, empty but for the same cloud: the same zones, to the last bit. */
static void empty_space(void **state)
{
    (void)state;
    enum { WIDE = 2 * EDGE, AT = 21 };
    static float kappa_t[CLOUD], wide[WIDE * WIDE * WIDE];
    fill_ball(kappa_t, EDGE, 0, 0.1, 0);
    fill_ball(wide, WIDE, AT, 0.1, 0);
    struct world w, v;
    float *b = solve_ball(&w, kappa_t, 0.9, NULL);
    murk_ground_options ground = wide_ground();
    const murk_array array = array_of(wide, WIDE, AT, 0.9);
    world_open(&v, 2, &array, &ground);
    v.scene.sun = SUN;
    v.scene.sky_radiance = 0.2;
    world_solve(&v, NULL);
    for (int n = 0; n < CLOUD; n++)
        if (kappa_t[n] > 0)
            assert_within(world_b(&v, n / EDGE / EDGE + AT, n / EDGE % EDGE + AT, n % EDGE + AT),
                          b[n], 2e-6 * b[n]);
    assert_within(murk_solution_report(v.solution)->crossings,
                  murk_solution_report(w.solution)->crossings, 0);
    free(b);
    world_close(&w);
    world_close(&v);
}

/* Thin media iterate on larger zones; against 64 times the directions on ever the same zones. */
static void larger_zones(void **state)
{
    (void)state;
    static float kappa_t[CLOUD];
    static const struct {
        double depth, albedo, tolerance;
        int coarsening;
    } cases[] = {
        {0.02, 0.9, 0.01, 2}, {0.2, 0.99, 0.01, 2}, {0.2, 0.9, 0.05, 2}, {0.8, 0.9, 0.01, 1}};
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        fill_ball(kappa_t, EDGE, 0, cases[n].depth, 0);
        struct world w;
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.tolerance = cases[n].tolerance;
        float *b = solve_ball(&w, kappa_t, cases[n].albedo, &options);
        assert_int_equal(murk_solution_report(w.solution)->coarsening, cases[n].coarsening);
        options.tolerance = 0.001;
        options.directions = 1536;
        world_solve(&w, &options);
        float *reference = zones_of(&w, kappa_t, EDGE);
        double error = differ(kappa_t, b, reference, CLOUD);
        print_message("depth %g, albedo %g: %.2f %% for %g %%\n", cases[n].depth, cases[n].albedo,
                      100 * error, 100 * cases[n].tolerance);
        assert_at_most(error, cases[n].tolerance);
        free(b);
        free(reference);
        world_close(&w);
    }
}

/* An opaque block in the sun: bricks that no light reaches are passed over, and that is no more
   than rounding. A glow of 1e-9 keeps them all awake. */
static void dark_bricks(void **state)
{
    (void)state;
    static float kappa_t[CLOUD];
    for (int n = 0; n < CLOUD; n++)
        kappa_t[n] = 60 / 0.1f;
    float *b[2];
    double dark = 0;
    for (int glow = 0; glow < 2; glow++) {
        murk_array array = array_of(kappa_t, EDGE, 0, 0.3);
        array.emission_value = glow ? 1e-9 : 0;
        struct world w;
        world_open(&w, 2, &array, NULL);
        w.scene.sun = SUN;
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.directions = 96;
        options.tolerance = 1e-4; /* of the iteration */
        world_solve(&w, &options);
        const murk_report *report = murk_solution_report(w.solution);
        if (!glow)
            dark = report->crossings_dark / report->crossings;
        b[glow] = zones_of(&w, kappa_t, EDGE);
        world_close(&w);
    }
    print_message("passed over: %.0f %% of all crossings\n", 100 * dark);
    assert_true(dark > 0.05); /* 64 of 216 bricks lie inside, and many sweeps carry a constant */
    assert_at_most(differ(kappa_t, b[0], b[1], CLOUD), 1e-5);
    free(b[0]);
    free(b[1]);
}

/* Without scattering there is nothing to iterate, without light nothing to carry. */
static void nothing_to_do(void **state)
{
    (void)state;
    static float kappa_t[CLOUD];
    fill_ball(kappa_t, EDGE, 0, 0.2, 0);
    struct world w;
    float *b = solve_ball(&w, kappa_t, 0, NULL);
    const murk_report *report = murk_solution_report(w.solution);
    assert_int_equal(report->iterations, 0);
    world_close(&w);
    free(b);
    const murk_array array = array_of(kappa_t, EDGE, 0, 0.9);
    world_open(&w, 2, &array, NULL);
    world_solve(&w, NULL);
    report = murk_solution_report(w.solution);
    assert_true(report->crossings > 0 && report->crossings_dark == report->crossings);
    for (int n = 0; n < CLOUD; n++)
        if (kappa_t[n] > 0)
            assert_within(world_b(&w, n / EDGE / EDGE, n / EDGE % EDGE, n % EDGE), 0, 0);
    world_close(&w);
}

/* The next frame from the last one's solution, from itself, and from one that has nothing to do
   with it. */
static void start(void **state)
{
    (void)state;
    static float before[CLOUD], now[CLOUD], other[CLOUD];
    fill_ball(before, EDGE, 0, 0.5, 0);
    fill_ball(now, EDGE, 0, 0.5, 0.3);
    memset(other, 0, sizeof other);
    for (int n = 0; n < 1000; n++)
        other[n] = 30;
    struct world first, far, w;
    float *cold = solve_ball(&w, now, 0.97, NULL);
    int iterations = murk_solution_report(w.solution)->iterations;
    free(solve_ball(&first, before, 0.97, NULL));
    free(solve_ball(&far, other, 0.5, NULL));
    struct world again;
    free(solve_ball(&again, now, 0.97, NULL));
    const murk_solution *starts[] = {first.solution, again.solution, far.solution};
    for (int n = 0; n < 3; n++) {
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.start = starts[n];
        world_solve(&w, &options);
        float *warm = zones_of(&w, now, EDGE);
        int taken = murk_solution_report(w.solution)->iterations;
        print_message("%d iterations, %d from nothing, %.3f %% apart\n", taken, iterations,
                      100 * differ(now, warm, cold, CLOUD));
        assert_at_most(differ(now, warm, cold, CLOUD), 0.25 * options.tolerance);
        if (n < 2)
            assert_true(taken < iterations);
        free(warm);
    }
    free(cold);
    world_close(&w);
    world_close(&first);
    world_close(&far);
    world_close(&again);
}

/* For one camera alone: the picture is the same within the tolerance, lines end early, and what
   lies behind an opaque front is left as it is. */
static void one_camera(void **state)
{
    (void)state;
    static float kappa_t[CLOUD];
    static const struct {
        double depth, albedo;
        murk_camera camera;
    } cases[] = {
        {0.3, 0.95, {{2.2, -6, 2.2}, {1.2, 2.2, 3.2}, {0, 0, 1}, 8, {48, 48}, 0}}, /* a detail */
        {20,
         0.6,
         {{-9, 2, 2}, {2, 2, 2}, {0, 0, 1}, 40, {48, 48}, 0}}, /* the near face of a block */
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        fill_ball(kappa_t, EDGE, 0, cases[n].depth, 0);
        for (int i = 0; cases[n].depth > 1 && i < CLOUD; i++) {
            bool inside = i / EDGE / EDGE < 40 && i / EDGE % EDGE < 40 && i % EDGE < 40;
            kappa_t[i] = inside ? (float)(cases[n].depth / 0.1) : 0;
        }
        const murk_array array = array_of(kappa_t, EDGE, 0, cases[n].albedo);
        murk_image *image[2];
        struct world w;
        world_open(&w, 2, &array, NULL);
        w.scene.sun = SUN;
        w.scene.sky_radiance = 0.2;
        for (int alone = 0; alone < 2; alone++) {
            murk_solve_options options = MURK_SOLVE_DEFAULT;
            options.directions = cases[n].depth > 1 ? 192 : 0; /* no halved voxels */
            options.camera = alone ? &cases[n].camera : NULL;
            world_solve(&w, &options);
            const murk_report *report = murk_solution_report(w.solution);
            assert_true((report->crossings_unseen > 0) == alone);
            assert_true(isnan(report->energy_balance) == alone);
            assert_int_equal(
                murk_render(w.context, &w.scene, w.solution, &cases[n].camera, NULL, &image[alone]),
                MURK_OK);
        }
        int count = 48 * 48 * murk_image_channels(image[0]),
            channels = murk_image_channels(image[0]);
        const float *whole = murk_image_pixels_const(image[0]),
                    *part = murk_image_pixels_const(image[1]);
        double difference = 0, size = 0;
        for (int i = 0; i < count; i += channels) { /* R comes first */
            difference += pow(part[i] - whole[i], 2);
            size += pow(whole[i], 2);
        }
        print_message("pictures differ by %.3f %%\n", 100 * sqrt(difference / size));
        assert_at_most(sqrt(difference / size), 0.003);
        murk_image_release(image[0]);
        murk_image_release(image[1]);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_space), cmocka_unit_test(larger_zones),
        cmocka_unit_test(dark_bricks), cmocka_unit_test(nothing_to_do),
        cmocka_unit_test(start),       cmocka_unit_test(one_camera),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
