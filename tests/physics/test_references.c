/* SPDX-License-Identifier: Apache-2.0 */
/* Media with reference solutions of other programs (data/README.md): sphere, slab, cube. */
#include "references.h"

static void solve(struct world *w)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    world_solve(w, &options);
}

/* 20 voxels radius and optical radius 2. Voxels of 0.1 optical depths make an error of their square
   over 12 in a flat source and a rim that is uncertain by a part of a voxel: 0.5 % together where
   the reference is taken. */
static void sphere(void **state)
{
    (void)state;
    const struct reference_sphere c = {"sphere_uniform.csv", "R2_a0.9", 2, 0.9, false};
    struct world w;
    reference_sphere_open(&c, 40, 2, &w);
    solve(&w);
    struct reference_error e = reference_sphere_error(&c, 0.9, &w);
    print_message("sphere: %.3f %%, most %.3f %%\n", 100 * e.zones, 100 * e.most);
    assert_at_most(e.zones, 0.005);
    assert_at_most(e.most, 0.01);
    world_close(&w);
}

/* The same, thinner towards the rim. */
static void sphere_linear(void **state)
{
    (void)state;
    const struct reference_sphere c = {"sphere_linear_kappa.csv", "tau2_a0.9", 4, 0.9, true};
    struct world w;
    reference_sphere_open(&c, 40, 2, &w);
    solve(&w);
    struct reference_error e = reference_sphere_error(&c, 0.9, &w);
    print_message("sphere, linear: %.3f %%, most %.3f %%\n", 100 * e.zones, 100 * e.most);
    assert_at_most(e.zones, 0.005);
    assert_at_most(e.most, 0.01);
    world_close(&w);
}

/* 20 optical depths wide, the ground reaching further: what comes from the sides is below e^-10.
   Layers are 1/20 optical depths. */
static void check_slab(double mu, double rho)
{
    const struct reference_slab c = {1, 0.9, mu, rho, 20};
    struct world w;
    reference_slab_open(&c, 20, 2, &w);
    solve(&w);
    struct reference_error e = reference_slab_error(&c, &w);
    print_message("slab mu %g rho %g: %.3f %%, ground %.3f %%\n", mu, rho, 100 * e.most,
                  100 * e.ground);
    assert_at_most(e.most, 0.01);
    if (rho > 0)
        assert_at_most(e.ground, 0.01);
    world_close(&w);
}

static void slab(void **state)
{
    (void)state;
    check_slab(1, 0);
    check_slab(1, 0.3);
    check_slab(0.5, 0.3);
}

/* The tolerance asked for, and the flat source: zones of x optical depths diffuse light as if they
   were 1 + x^2 / 4 times thinner (data/README.md). */
static void cube(void **state)
{
    (void)state;
    enum { MOST = 64 };
    struct reference_cube cubes[MOST];
    int count = reference_cube_list(cubes, MOST);
    assert_true(count > 20 && count <= MOST);
    for (int n = 0; n < count; n++) {
        const struct reference_cube *c = &cubes[n];
        struct world w;
        reference_cube_open(c, 20, 2, &w);
        solve(&w);
        struct reference_error e = reference_cube_error(c, &w);
        double x = (c->a + c->b) / 20;
        print_message("cube %g %g %g: %.3f %%\n", c->a, c->b, c->omega, 100 * e.zones);
        assert_at_most(e.zones, 0.003 + x * x / 4);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sphere),
        cmocka_unit_test(sphere_linear),
        cmocka_unit_test(slab),
        cmocka_unit_test(cube),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
