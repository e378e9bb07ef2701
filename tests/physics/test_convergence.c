/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Conjugate gradients: few iterations in any medium, and an estimate that tells the error. Compared
 * with a solution on the same directions whose residual has come down to rounding.
 */
#include "check.h"
#include "conjugate_gradients.h"
#include "lines.h"
#include "preconditioner.h"

enum { MOST_ZONES = 32 * 32 * 32, DIRECTIONS = 48 };

/* Where a medium is: fills kappa_t in units of its largest for voxel centres in [-1/2, 1/2]^3. */
typedef double shape(const double at[3], uint64_t *random);

static double everywhere(const double at[3], uint64_t *random)
{
    (void)at, (void)random;
    return 1;
}

/* A third empty, the rest anything. */
static double porous(const double at[3], uint64_t *random)
{
    (void)at;
    return fmax(0, 1.5 * check_random(random) - 0.5);
}

/* From voxel to voxel up to a factor of 1e6. */
static double wild(const double at[3], uint64_t *random)
{
    (void)at;
    return pow(10, -6 * check_random(random));
}

static double clouds(const double at[3], uint64_t *random)
{
    (void)random;
    double x = fabs(at[0]) - 0.3;
    return x * x + at[1] * at[1] + at[2] * at[2] < 0.02;
}

static double shell(const double at[3], uint64_t *random)
{
    (void)random;
    double r = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    return r > 0.3 && r < 0.48;
}

struct medium_case {
    const char *name;
    shape *shape;
    int32_t size[3];
    double voxel[3];
    double tau; /* of the densest voxel, along x */
    double albedo;
    bool varied_albedo; /* from 0 to that */
    bool ground;
    int most; /* iterations to 0.1 % */
};

static const struct medium_case CASES[] = {
    {"thin", everywhere, {24, 24, 24}, {1, 1, 1}, 1e-3, 1, false, false, 3},
    {"half absorbing", everywhere, {24, 24, 24}, {1, 1, 1}, 1, 0.5, false, false, 6},
    {"cube of 20", everywhere, {32, 32, 32}, {1, 1, 1}, 20 / 32.0, 0.99, false, false, 6},
    {"cube of 1000", everywhere, {32, 32, 32}, {1, 1, 1}, 1000 / 32.0, 0.9999, false, false, 8},
    {"conservative cube", everywhere, {32, 32, 32}, {1, 1, 1}, 60, 1, false, false, 10},
    {"absorbing cube", everywhere, {24, 24, 24}, {1, 1, 1}, 60, 0.9, false, false, 8},
    {"slab", everywhere, {32, 32, 6}, {1, 1, 1}, 5, 0.999, false, false, 8},
    {"slab on ground", everywhere, {24, 24, 6}, {1, 1, 1}, 5, 0.999, false, true, 10},
    {"porous", porous, {24, 24, 24}, {1, 1, 1}, 1.2, 0.999, false, false, 7},
    {"porous 20", porous, {24, 24, 24}, {1, 1, 1}, 20, 1, false, false, 10},
    {"wild", wild, {24, 24, 24}, {1, 1, 1}, 20, 1, false, false, 9},
    {"opaque", wild, {16, 16, 16}, {1, 1, 1}, 1e5, 1, false, false, 14},
    {"varied albedo", porous, {24, 24, 24}, {1, 1, 1}, 5, 1, true, true, 9},
    {"clouds", clouds, {32, 24, 24}, {1, 1, 1}, 3, 1, false, false, 8},
    {"shell", shell, {32, 32, 32}, {1, 1, 1}, 1, 1, false, false, 10},
    {"flat voxels", everywhere, {24, 24, 24}, {1, 1, 0.2}, 2, 0.999, false, false, 12},
};

struct solver {
    struct world world;
    murk_lines *lines;
    murk_system system;
    murk_vector b, x, exact, d;
};

static void open_solver(struct solver *s, const struct medium_case *c)
{
    static float kappa_t[MOST_ZONES], albedo[MOST_ZONES];
    murk_array array = {.kappa_t = kappa_t, .albedo_value = c->albedo};
    memcpy(array.size, c->size, sizeof array.size);
    memcpy(array.voxel_size, c->voxel, sizeof array.voxel_size);
    size_t count = check_count(&array), n = 0;
    assert_true(count <= MOST_ZONES);
    uint64_t random = 5;
    for (int i = 0; i < c->size[0]; i++)
        for (int j = 0; j < c->size[1]; j++)
            for (int k = 0; k < c->size[2]; k++, n++) {
                const double at[3] = {(i + 0.5) / c->size[0] - 0.5, (j + 0.5) / c->size[1] - 0.5,
                                      (k + 0.5) / c->size[2] - 0.5};
                kappa_t[n] = (float)(c->tau / c->voxel[0] * c->shape(at, &random));
                double r = check_random(&random);
                albedo[n] = r < 0.2 ? 0 : (float)(c->albedo * sqrt(r));
            }
    if (c->varied_albedo)
        array.albedo = albedo;
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    for (int a = 0; a < 2; a++) {
        ground.extent_max[a] = c->size[a] * c->voxel[a];
        ground.patches[a] = 6;
    }
    ground.reflectance = 0.6;
    world_open(&s->world, 2, &array, c->ground ? &ground : NULL);
    const murk_medium *medium = s->world.medium;
    assert_int_equal(murk_lines_create(s->world.context, medium->grid, medium->kappa_t,
                                       s->world.ground, DIRECTIONS, 1, 0, &s->lines),
                     MURK_OK);
    s->system = (murk_system){.context = s->world.context,
                              .method = &murk_exchange_lines,
                              .state = s->lines,
                              .medium = medium,
                              .ground = s->world.ground,
                              .slots = medium->grid->brick_count * MURK_BRICK_SLOTS,
                              .patches = c->ground ? s->world.ground->patch_count : 0};
    murk_vector *vectors[] = {&s->b, &s->x, &s->exact, &s->d};
    for (int i = 0; i < 4; i++)
        assert_int_equal(murk_vector_create(&s->system, vectors[i]), MURK_OK);
}

static void close_solver(struct solver *s)
{
    murk_vector_clear(&s->b);
    murk_vector_clear(&s->x);
    murk_vector_clear(&s->exact);
    murk_vector_clear(&s->d);
    murk_preconditioner_release(s->system.preconditioner);
    murk_lines_release(s->lines);
    world_close(&s->world);
}

/* Light that has come down through half of what is above: strong on top, nearly none below. */
static void set_source(struct solver *s)
{
    const murk_medium *medium = s->world.medium;
    const murk_grid *grid = medium->grid;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            size_t i = b * MURK_BRICK_SLOTS + (size_t)slot;
            double depth = 0;
            for (int32_t k = grid->brick[b][2] * 8 + (slot & 7); k < grid->hi[2]; k++) {
                int64_t above = murk_grid_slot(grid, grid->brick[b][0] * 8 + (slot >> 6),
                                               grid->brick[b][1] * 8 + (slot >> 3 & 7), k);
                depth += above < 0 ? 0 : 0.5 * medium->kappa_t[above] * grid->voxel[2];
            }
            s->b.zone[i] = medium->kappa_t[i] > 0 ? (float)(0.01 + exp(-depth)) : 0;
        }
    for (size_t i = 0; i < s->system.patches; i++)
        s->b.patch[i] = 0.1f;
}

static murk_cg_result solve(struct solver *s, double relative, murk_vector *x)
{
    murk_cg cg = {.system = &s->system, .b = &s->b, .x = x, .relative = relative};
    s->system.escape = 0; /* as a first solve */
    if (murk_conjugate_gradients(&cg, 1, 1000))
        fail_msg("%s", murk_context_message(s->world.context));
    return cg.result;
}

/* To where rounding ends it, twice. */
static void solve_exactly(struct solver *s)
{
    murk_vector b = s->b;
    murk_cg cg = {.system = &s->system, .b = &s->b, .x = &s->d, .relative = 1e-3};
    solve(s, 0, &s->exact);
    assert_int_equal(murk_vector_create(&s->system, &s->b), MURK_OK);
    assert_int_equal(murk_system_apply(&(murk_application){&s->system, &s->exact, &s->d}, 1),
                     MURK_OK);
    murk_vector_copy(&s->system, &b, &s->b);
    murk_vector_add(&s->system, -1, &s->d, &s->b);
    assert_int_equal(murk_conjugate_gradients(&cg, 1, 1000), MURK_OK);
    murk_vector_add(&s->system, 1, &s->d, &s->exact);
    murk_vector_clear(&s->b);
    s->b = b;
}

static double error_of(struct solver *s)
{
    murk_vector_copy(&s->system, &s->x, &s->d);
    murk_vector_add(&s->system, -1, &s->exact, &s->d);
    return sqrt(murk_vector_norm2(&s->system, &s->d) / murk_vector_norm2(&s->system, &s->exact));
}

/* Down to a goal the error is within it, within what the estimate says or little above, and the
   estimate no idle fear. Rounding ends that at 1e-6. */
static void check_goal(struct solver *s, const struct medium_case *c, double goal)
{
    murk_cg_result result = solve(s, goal, &s->x);
    double error = error_of(s), estimate = result.error / result.norm;
    print_message("%-17s %-6g %2d iterations%s, error %.2e, estimate %.2e\n", c->name, goal,
                  result.iterations, s->system.preconditioner ? " preconditioned" : "", error,
                  estimate);
    assert_at_most(estimate, goal);
    assert_at_most(error, goal);
    assert_at_most(error, 1.5 * estimate + 1e-6);
    assert_at_most(estimate, 5 * error + 1e-6);
    if (goal == 1e-3)
        assert_at_most(result.iterations, c->most);
}

static void iterations_and_estimate(void **state)
{
    (void)state;
    static const double GOALS[] = {0.1, 0.01, 1e-3, 1e-4};
    for (size_t n = 0; n < sizeof CASES / sizeof *CASES; n++) {
        struct solver s;
        open_solver(&s, &CASES[n]);
        set_source(&s);
        solve_exactly(&s);
        for (size_t g = 0; g < sizeof GOALS / sizeof *GOALS; g++)
            check_goal(&s, &CASES[n], GOALS[g]);
        close_solver(&s);
    }
}

/* <u, P^-1 v> is symmetric and <v, P^-1 v> positive, in the system's inner product. */
static void preconditioner_is_self_adjoint(void **state)
{
    (void)state;
    static const struct medium_case EXTREMES[] = {
        {"wild thin", wild, {20, 18, 17}, {1, 1, 1}, 1e-2, 1, false, false, 0},
        {"wild opaque", wild, {20, 18, 17}, {1, 1, 1}, 1e5, 1, true, true, 0},
        {"plates", porous, {20, 18, 17}, {1, 1, 0.01}, 10, 0.99, false, false, 0},
        {"needles", porous, {20, 18, 17}, {0.01, 0.01, 1}, 0.1, 1, false, false, 0},
    };
    for (size_t n = 0; n < sizeof EXTREMES / sizeof *EXTREMES; n++) {
        struct solver s;
        open_solver(&s, &EXTREMES[n]);
        assert_int_equal(
            murk_preconditioner_create(s.world.context, s.world.medium, &s.system.preconditioner),
            MURK_OK);
        uint64_t random = 3;
        murk_vector u = s.b, v = s.x, pu = s.exact, pv = s.d;
        for (size_t i = 0; i < s.system.slots; i++) {
            bool free =
                s.world.medium->kappa_t[i] > 0 && murk_value(&s.world.medium->albedo, i) > 0;
            u.zone[i] = free ? (float)check_random(&random) : 0;
            v.zone[i] = free ? (float)check_random(&random) - 0.5f : 0;
        }
        murk_preconditioner_apply(s.system.preconditioner, &s.system, &u, &pu);
        murk_preconditioner_apply(s.system.preconditioner, &s.system, &v, &pv);
        double uu = murk_vector_product(&s.system, &u, &pu);
        double vv = murk_vector_product(&s.system, &v, &pv);
        assert_true(uu > 0 && isfinite(uu) && vv > 0 && isfinite(vv));
        assert_within(murk_vector_product(&s.system, &u, &pv),
                      murk_vector_product(&s.system, &v, &pu), 1e-5 * sqrt(uu * vv));
        close_solver(&s);
    }
}

/* Cycle and sums, to the last bit. */
static void threads_change_nothing(void **state)
{
    (void)state;
    struct solver s;
    open_solver(&s, &CASES[8]);
    set_source(&s);
    assert_int_equal(
        murk_preconditioner_create(s.world.context, s.world.medium, &s.system.preconditioner),
        MURK_OK);
    murk_preconditioner_apply(s.system.preconditioner, &s.system, &s.b, &s.x);
    double one = murk_vector_product(&s.system, &s.b, &s.x);
    for (int threads = 1; threads < 6; threads++) {
        s.world.context->threads = threads;
        murk_preconditioner_apply(s.system.preconditioner, &s.system, &s.b, &s.d);
        assert_memory_equal(s.d.zone, s.x.zone, s.system.slots * sizeof(float));
        assert_true(murk_vector_product(&s.system, &s.b, &s.d) == one);
    }
    close_solver(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(iterations_and_estimate),
        cmocka_unit_test(preconditioner_is_self_adjoint),
        cmocka_unit_test(threads_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
