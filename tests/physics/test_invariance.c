/* SPDX-License-Identifier: Apache-2.0 */
/* What must not change the solution: where the scene stands, how it is turned, mirrored and scaled,
   and how many threads work on it. */
#include "check.h"

enum { NX = 10, NY = 9, NZ = 7, COUNT = NX * NY * NZ, MOST = 8 * COUNT, PATCHES = 6 };

/* A signed permutation of the axes: axis a of the turned scene is axis from[a] of the original,
   backwards where flip[a]; then moved and scaled, with empty voxels in front. */
struct motion {
    int from[3];
    bool flip[3];
    int32_t empty[3];
    double shift[3], scale;
};

static const struct motion STILL = {.from = {0, 1, 2}, .scale = 1};

/* The scene that all motions are applied to: arrays of NX * NY * NZ. */
struct original {
    float kappa_t[COUNT], albedo[COUNT], emission[COUNT], reflectance[PATCHES * PATCHES];
};

static const int32_t SIZE[3] = {NX, NY, NZ};
static const double VOXEL[3] = {0.1, 0.125, 0.2};

static void make_original(struct original *o)
{
    uint64_t random = 21;
    for (int i = 0; i < COUNT; i++) {
        double x = check_random(&random);
        o->kappa_t[i] = x < 0.4 ? 0 : (float)(8 * (x - 0.3));
        o->albedo[i] = (float)(0.5 + 0.5 * check_random(&random));
        o->emission[i] = (float)(check_random(&random) < 0.1);
    }
    /* The corners of the box are zones: it is the same for every motion. */
    o->kappa_t[0] = o->kappa_t[COUNT - 1] = 1;
    for (int i = 0; i < PATCHES * PATCHES; i++)
        o->reflectance[i] = (float)check_random(&random);
}

/* Where voxel `at` of the original is in the moved arrays. */
static void moved_index(const struct motion *m, const int32_t at[3], int32_t out[3])
{
    for (int a = 0; a < 3; a++) {
        int32_t i = at[m->from[a]];
        out[a] = m->empty[a] + (m->flip[a] ? SIZE[m->from[a]] - 1 - i : i);
    }
}

/* Solves the moved scene; B[n] is that of voxel n of the original. ground: -1 none, else the axis
   of the moved scene that is up, 2 or 1; the ground's extent is the medium's box. */
static void solve_moved(const struct original *o, const struct motion *m, int ground_axis,
                        int threads, const murk_solve_options *options, double B[COUNT])
{
    static float kappa_t[MOST], albedo[MOST], emission[MOST];
    murk_array array = {.kappa_t = kappa_t, .albedo = albedo, .emission = emission};
    for (int a = 0; a < 3; a++) {
        array.size[a] = SIZE[m->from[a]] + m->empty[a];
        array.voxel_size[a] = VOXEL[m->from[a]] * m->scale;
        array.origin[a] = m->shift[a] - m->empty[a] * array.voxel_size[a];
    }
    assert_true(check_count(&array) <= MOST);
    memset(kappa_t, 0, sizeof kappa_t);
    int32_t at[3], to[3];
    for (int n = 0; n < COUNT; n++) {
        at[0] = n / (NY * NZ), at[1] = n / NZ % NY, at[2] = n % NZ;
        moved_index(m, at, to);
        size_t slot = check_at(&array, to[0], to[1], to[2]);
        kappa_t[slot] = (float)(o->kappa_t[n] / m->scale);
        albedo[slot] = o->albedo[n];
        emission[slot] = o->emission[n];
    }
    /* Patch (p, q) of the original lies along its axes 0 and 1; up is its axis 2. */
    float reflectance[PATCHES * PATCHES];
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    if (ground_axis >= 0) {
        int second = ground_axis == 2 ? 1 : 2;
        ground.up = ground_axis == 2 ? MURK_UP_Z : MURK_UP_Y;
        ground.height = m->shift[ground_axis] - 0.1 * m->scale;
        const int axes[2] = {0, second};
        for (int c = 0; c < 2; c++) {
            int a = axes[c];
            ground.extent_min[c] = m->shift[a];
            ground.extent_max[c] = m->shift[a] + SIZE[m->from[a]] * array.voxel_size[a];
            ground.patches[c] = PATCHES;
        }
        for (int ia = 0; ia < PATCHES; ia++)
            for (int ib = 0; ib < PATCHES; ib++) {
                int original[3] = {0};
                original[m->from[0]] = m->flip[0] ? PATCHES - 1 - ia : ia;
                original[m->from[second]] = m->flip[second] ? PATCHES - 1 - ib : ib;
                int row = ground_axis == 2 ? PATCHES - 1 - ib : ib; /* image order */
                reflectance[row * PATCHES + ia] =
                    o->reflectance[original[0] * PATCHES + original[1]];
            }
        ground.reflectance_image = reflectance;
    }
    struct world w;
    world_open(&w, threads, &array, ground_axis >= 0 ? &ground : NULL);
    const double sun[3] = {0.4, -0.3, -0.9};
    for (int a = 0; a < 3; a++)
        w.scene.sun.direction[a] = (m->flip[a] ? -1 : 1) * sun[m->from[a]];
    w.scene.sun.irradiance = 2;
    w.scene.sky_radiance = 0.1;
    world_solve(&w, options);
    for (int n = 0; n < COUNT; n++) {
        at[0] = n / (NY * NZ), at[1] = n / NZ % NY, at[2] = n % NZ;
        moved_index(m, at, to);
        B[n] = world_b(&w, to[0], to[1], to[2]);
    }
    world_close(&w);
}

/* Largest relative difference over the zones. */
static double difference(const struct original *o, const double *a, const double *b)
{
    double most = 0;
    for (int n = 0; n < COUNT; n++)
        if (o->kappa_t[n] > 0)
            most = fmax(most, fabs(a[n] / b[n] - 1));
    return most;
}

/* A fixed quadrature and an iteration that ends far below the differences looked for. */
static murk_solve_options fixed(void)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 96;
    options.tolerance = 1e-5;
    return options;
}

static double B[COUNT], MOVED[COUNT];

/* The directions turn with the lattice and so do the places of their lines: a turned scene differs
   by the order of sums in floats alone. In a mirrored one the lines pass elsewhere, and zones of
   such a rough medium differ by up to the angular error of 96 directions, some per cent. */
static void turns(void **state)
{
    static const struct {
        struct motion motion;
        int up; /* axis of the original's z afterwards; -1: a ground cannot lie there */
        bool mirror;
    } moves[] = {
        {{{1, 0, 2}, {true, false, false}, {0}, {0}, 1}, 2, false},   /* a quarter about z */
        {{{1, 0, 2}, {false, true, false}, {0}, {0}, 1}, 2, false},   /* and back */
        {{{0, 1, 2}, {true, true, false}, {0}, {0}, 1}, 2, false},    /* half about z */
        {{{0, 2, 1}, {false, false, true}, {0}, {0}, 1}, 1, false},   /* a quarter about x: y up */
        {{{2, 1, 0}, {false, false, true}, {0}, {0}, 1}, -1, false},  /* a quarter about y */
        {{{0, 1, 2}, {true, false, true}, {0}, {0}, 1}, -1, false},   /* upside down */
        {{{1, 2, 0}, {false, false, false}, {0}, {0}, 1}, -1, false}, /* a third */
        {{{0, 1, 2}, {true, false, false}, {0}, {0}, 1}, 2, true},
        {{{1, 0, 2}, {false, false, false}, {0}, {0}, 1}, 2, true},
        {{{0, 1, 2}, {false, false, true}, {0}, {0}, 1}, -1, true},
    };
    const murk_solve_options options = fixed();
    for (int ground = 0; ground < 2; ground++) {
        solve_moved(*state, &STILL, ground ? 2 : -1, 2, &options, B);
        for (size_t n = 0; n < sizeof moves / sizeof *moves; n++) {
            if (ground && moves[n].up < 0)
                continue;
            solve_moved(*state, &moves[n].motion, ground ? moves[n].up : -1, 2, &options, MOVED);
            double most = difference(*state, MOVED, B);
            print_message("ground %d motion %zu: %.2g\n", ground, n, most);
            assert_at_most(most, moves[n].mirror ? 0.05 : 1e-6);
        }
    }
}

/* Far away, and anywhere among the bricks of the index space. */
static void translations(void **state)
{
    static const struct motion moves[] = {
        {{0, 1, 2}, {0}, {0}, {100, -37.5, 12.25}, 1},
        {{0, 1, 2}, {0}, {3, 1, 6}, {0}, 1},
        {{0, 1, 2}, {0}, {8, 0, 8}, {1e5, 1e5, 1e5}, 1},
    };
    const murk_solve_options options = fixed();
    for (int ground = 0; ground < 2; ground++) {
        solve_moved(*state, &STILL, ground ? 2 : -1, 2, &options, B);
        for (size_t n = 0; n < sizeof moves / sizeof *moves; n++) {
            solve_moved(*state, &moves[n], ground ? 2 : -1, 2, &options, MOVED);
            double most = difference(*state, MOVED, B);
            print_message("ground %d translation %zu: %.2g\n", ground, n, most);
            assert_at_most(most, 1e-6);
        }
    }
}

/* Lengths times s with kappa_t / s: bit for bit where s is a power of two. */
static void scales(void **state)
{
    struct motion m = STILL;
    const murk_solve_options options = fixed();
    for (int ground = 0; ground < 2; ground++) {
        solve_moved(*state, &STILL, ground ? 2 : -1, 2, &options, B);
        m.scale = 1024;
        solve_moved(*state, &m, ground ? 2 : -1, 2, &options, MOVED);
        assert_within(difference(*state, MOVED, B), 0, 0);
        m.scale = 0.37;
        solve_moved(*state, &m, ground ? 2 : -1, 2, &options, MOVED);
        print_message("ground %d scale: %.2g\n", ground, difference(*state, MOVED, B));
        assert_at_most(difference(*state, MOVED, B), 1e-6);
    }
}

/* Sums are in another order; the same number of threads gives the same bits. */
static void threads(void **state)
{
    const murk_solve_options options = fixed();
    solve_moved(*state, &STILL, 2, 1, &options, B);
    solve_moved(*state, &STILL, 2, 2, &options, MOVED);
    print_message("threads: %.2g\n", difference(*state, MOVED, B));
    assert_at_most(difference(*state, MOVED, B), 1e-6);
    solve_moved(*state, &STILL, 2, 2, &options, B);
    assert_within(difference(*state, MOVED, B), 0, 0);
}

int main(void)
{
    static struct original original;
    make_original(&original);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(turns, &original),
        cmocka_unit_test_prestate(translations, &original),
        cmocka_unit_test_prestate(scales, &original),
        cmocka_unit_test_prestate(threads, &original),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
