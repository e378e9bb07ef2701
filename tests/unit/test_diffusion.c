/* SPDX-License-Identifier: Apache-2.0 */
/* The diffusion matrix against a plain assembly, and the multigrid cycle as its inverse. */
#include "diffusion.h"
#include "multigrid.h"
#include "sparse.h"

/* A medium on some of the voxels of a few bricks, kappa_t over `decades`. */
struct scene {
    double voxel[3], most, decades, albedo;
    int edge;    /* of the cube of bricks */
    double rate; /* at most, of the cycle */
};

/* Plates 100 times as wide as high would need cells that grow in one direction. */
static const struct scene SCENES[] = {
    {{1, 1, 1}, 0.5, 0, 1, 2, 0.2},       {{1, 1, 1}, 20, 6, 1, 3, 0.5},
    {{1, 2, 0.5}, 3, 2, 0.9, 3, 0.5},     {{1, 1, 1}, 1e-2, 1, 1, 3, 0.5},
    {{1, 1, 1}, 1e5, 13, 0.9999, 3, 0.6}, {{1, 1, 0.01}, 100, 3, 1, 2, 0.8},
};

struct fixture {
    murk_grid *grid;
    struct murk_medium medium;
};

static void open_fixture(struct fixture *f, murk_context *context, const struct scene *scene)
{
    uint64_t random = 9;
    sparse s = {.low = {-1, -1, 2}, .edge = scene->edge, .bricks = 0.7, .voxels = 0.8};
    memcpy(s.voxel, scene->voxel, sizeof s.voxel);
    f->grid = sparse_create(context, &s, &random);
    size_t slots = f->grid->brick_count * MURK_BRICK_SLOTS;
    f->medium = (struct murk_medium){.grid = f->grid,
                                     .kappa_t = murk_alloc(slots, sizeof(float)),
                                     .albedo.constant = (float)scene->albedo};
    for (size_t i = 0; i < slots; i++)
        if (murk_grid_active(f->grid, i / MURK_BRICK_SLOTS, (int)(i % MURK_BRICK_SLOTS)))
            f->medium.kappa_t[i] =
                (float)(scene->most * pow(10, -scene->decades * check_random(&random)));
}

static void close_fixture(struct fixture *f)
{
    murk_free(f->medium.kappa_t);
    murk_grid_release(f->grid);
}

static size_t cell_count(const murk_diffusion *d)
{
    return d->brick_count * murk_diffusion_cells(d->edge);
}

/* y = C x */
static void multiply(const murk_diffusion *d, const float *x, float *y)
{
    float *nothing = murk_alloc(cell_count(d), sizeof *nothing);
    for (size_t b = 0; b < d->brick_count; b++)
        murk_diffusion_residual(d, b, nothing, x, y + b * murk_diffusion_cells(d->edge));
    for (size_t i = 0; i < cell_count(d); i++)
        y[i] = -y[i];
    murk_free(nothing);
}

static double dot(const float *u, const float *v, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += (double)u[i] * v[i];
    return sum;
}

/* ---- the matrix of the finest cells, voxel by voxel ---------------------------------------- */

static double resistance(double tau)
{
    tau = fmax(tau, 1e-3);
    return tau / (8 / 3.0 + 2 * tau * tau / (3 + tau));
}

/* Half resistances of two voxels in line, from `at` on along axis; the vacuum's beyond the bricks.
 */
static double pair(const struct fixture *f, const int32_t at[3], int axis)
{
    double sum = 0;
    for (int i = 0; i < 2; i++) {
        int32_t c[3] = {at[0], at[1], at[2]};
        c[axis] += i;
        int64_t slot = murk_grid_slot(f->grid, c[0], c[1], c[2]);
        if (slot < 0)
            return 0.5;
        sum += resistance(f->medium.kappa_t[slot] * f->grid->voxel[axis]);
    }
    return sum;
}

/* Conductance between the cell at voxel `at` and the next one on a side. */
static double conductance(const struct fixture *f, const int32_t at[3], int side)
{
    int axis = side / 2;
    double sum = 0;
    for (int l = 0; l < 4; l++) {
        int32_t own[3] = {at[0], at[1], at[2]};
        own[(axis + 1) % 3] += l & 1;
        own[(axis + 2) % 3] += l >> 1;
        int32_t next[3] = {own[0], own[1], own[2]};
        next[axis] += side & 1 ? 2 : -2;
        sum += 1 / (pair(f, own, axis) + pair(f, next, axis));
    }
    return sum * cbrt(f->grid->volume) / f->grid->voxel[axis];
}

/* Each row of C x against the sum over its neighbours. */
static void agrees_with_plain_assembly(void **state)
{
    for (size_t n = 0; n < sizeof SCENES / sizeof *SCENES; n++) {
        struct fixture f;
        open_fixture(&f, *state, &SCENES[n]);
        murk_diffusion d;
        assert_int_equal(murk_diffusion_create(*state, &f.medium, &d), MURK_OK);
        size_t count = cell_count(&d);
        float *x = murk_alloc(count, sizeof *x), *y = murk_alloc(count, sizeof *y);
        uint64_t random = 4;
        for (size_t i = 0; i < count; i++)
            x[i] = (float)check_random(&random);
        multiply(&d, x, y);
        for (size_t i = 0; i < count; i++) {
            const int32_t *brick = f.grid->brick[i / 64];
            const int32_t at[3] = {brick[0] * 8 + (int)(i % 64 / 16) * 2,
                                   brick[1] * 8 + (int)(i % 16 / 4) * 2,
                                   brick[2] * 8 + (int)(i % 4) * 2};
            double wanted = d.sink[i] * x[i], size = wanted;
            for (int side = 0; side < 6; side++) {
                int32_t next[3] = {at[0], at[1], at[2]};
                next[side / 2] += side & 1 ? 2 : -2;
                int64_t slot = murk_grid_slot(f.grid, next[0], next[1], next[2]);
                double other = slot < 0 ? 0
                                        : x[slot / 512 * 64 + slot % 512 / 128 * 16 +
                                            slot % 64 / 16 * 4 + slot % 8 / 2];
                wanted += conductance(&f, at, side) * (x[i] - other);
                size += conductance(&f, at, side);
            }
            assert_within(y[i], wanted, 1e-3 * size);
        }
        murk_free(x);
        murk_free(y);
        murk_diffusion_clear(&d);
        close_fixture(&f);
    }
}

/* Down to single cells: <u, C v> = <C u, v>, <u, C u> > 0, and C 1 >= 0: nothing comes from
 * nothing. */
static void every_level_is_symmetric_positive(void **state)
{
    for (size_t n = 0; n < sizeof SCENES / sizeof *SCENES; n++) {
        struct fixture f;
        open_fixture(&f, *state, &SCENES[n]);
        murk_diffusion d, next;
        assert_int_equal(murk_diffusion_create(*state, &f.medium, &d), MURK_OK);
        for (int level = 0; level < 6; level++) {
            size_t count = cell_count(&d);
            float *u = murk_alloc(5 * count, sizeof *u);
            float *v = u + count, *cu = v + count, *cv = cu + count, *diagonal = cv + count;
            uint64_t random = 4;
            for (size_t i = 0; i < count; i++)
                u[i] = (float)check_random(&random), v[i] = (float)check_random(&random);
            multiply(&d, u, cu);
            multiply(&d, v, cv);
            double size = sqrt(dot(u, cu, count) * dot(v, cv, count));
            assert_true(size > 0 && isfinite(size));
            assert_within(dot(u, cv, count), dot(v, cu, count), 1e-5 * size);
            for (size_t i = 0; i < count; i++)
                u[i] = 1;
            multiply(&d, u, cu);
            murk_diffusion_invert_diagonal(&d, diagonal);
            for (size_t i = 0; i < count; i++)
                assert_true(cu[i] * diagonal[i] > -1e-5 && cu[i] * diagonal[i] < 1 + 1e-5);
            murk_free(u);
            int32_t *parent;
            assert_int_equal(murk_diffusion_coarsen(*state, &d, &next, &parent), MURK_OK);
            murk_free(parent);
            murk_diffusion_clear(&d);
            d = next;
        }
        assert_true(d.brick_count < 9);
        murk_diffusion_clear(&d);
        close_fixture(&f);
    }
}

/* In a uniform medium a cell of twice the edge conducts twice as well: four lines over twice the
   distance. */
static void uniform_cells_conduct_by_their_size(void **state)
{
    murk_context *context = *state;
    struct world w;
    murk_array array = {
        .size = {64, 64, 64}, .voxel_size = {1, 1, 1}, .kappa_t_value = 0.3, .albedo_value = 1};
    world_open(&w, 1, &array, NULL);
    murk_diffusion d, next;
    assert_int_equal(murk_diffusion_create(context, w.medium, &d), MURK_OK);
    for (double wanted = 1 / resistance(0.3); d.edge > 1 || d.brick_count > 64; wanted *= 2) {
        /* the middle of the medium is a face between bricks */
        int32_t half = w.medium->grid->hi[0] / 16, b = 0;
        while (d.brick[b][0] != (d.edge > 1 || d.brick_count == 512 ? half : half / 2) ||
               d.brick[b][1] != d.brick[b][0] || d.brick[b][2] != d.brick[b][0])
            b++;
        for (int a = 0; a < 3; a++)
            assert_within(d.face[(size_t)b * murk_diffusion_faces(d.edge) +
                                 murk_face_layout(a, d.edge).first],
                          wanted, 1e-4 * wanted);
        int32_t *parent;
        assert_int_equal(murk_diffusion_coarsen(context, &d, &next, &parent), MURK_OK);
        murk_free(parent);
        murk_diffusion_clear(&d);
        d = next;
    }
    murk_diffusion_clear(&d);
    world_close(&w);
}

/* ---- the cycle ----------------------------------------------------------------------------- */

static void cycle(murk_context *context, murk_multigrid *m, const float *b, float *x, size_t count)
{
    memcpy(murk_multigrid_source(m), b, count * sizeof *b);
    murk_multigrid_cycle(context, m);
    memcpy(x, murk_multigrid_solution(m), count * sizeof *x);
}

static void cycle_is_symmetric_positive(void **state)
{
    for (size_t n = 0; n < sizeof SCENES / sizeof *SCENES; n++) {
        struct fixture f;
        open_fixture(&f, *state, &SCENES[n]);
        murk_multigrid *m;
        assert_int_equal(murk_multigrid_create(*state, &f.medium, &m), MURK_OK);
        size_t count = f.grid->brick_count * 64;
        float *u = murk_alloc(4 * count, sizeof *u);
        float *v = u + count, *mu = v + count, *mv = mu + count;
        uint64_t random = 8;
        for (size_t i = 0; i < count; i++) {
            u[i] = (float)check_random(&random);
            v[i] = (float)check_random(&random) - 0.5f;
        }
        cycle(*state, m, u, mu, count);
        cycle(*state, m, v, mv, count);
        double uu = dot(u, mu, count), vv = dot(v, mv, count);
        assert_true(uu > 0 && vv > 0 && isfinite(uu) && isfinite(vv));
        assert_within(dot(u, mv, count), dot(v, mu, count), 1e-5 * sqrt(uu * vv));
        murk_free(u);
        murk_multigrid_release(m);
        close_fixture(&f);
    }
}

/* Conjugate gradients for C x = b with the cycle: the energy of the residual falls by `rate`^2 a
   step on average. */
static double find_rate(murk_context *context, const struct fixture *f)
{
    enum { STEPS = 8 };
    murk_multigrid *m;
    murk_diffusion d;
    assert_int_equal(murk_multigrid_create(context, &f->medium, &m), MURK_OK);
    assert_int_equal(murk_diffusion_create(context, &f->medium, &d), MURK_OK);
    size_t count = cell_count(&d);
    float *r = murk_alloc(4 * count, sizeof *r);
    float *z = r + count, *p = z + count, *q = p + count;
    uint64_t random = 8;
    for (size_t i = 0; i < count; i++)
        r[i] = (float)check_random(&random);
    cycle(context, m, r, z, count);
    memcpy(p, z, count * sizeof *p);
    double first = dot(r, z, count), before = first;
    for (int step = 0; step < STEPS; step++) {
        multiply(&d, p, q);
        double a = before / dot(p, q, count);
        for (size_t i = 0; i < count; i++)
            r[i] -= (float)a * q[i];
        cycle(context, m, r, z, count);
        double next = dot(r, z, count);
        for (size_t i = 0; i < count; i++)
            p[i] = z[i] + (float)(next / before) * p[i];
        before = next;
    }
    murk_free(r);
    murk_diffusion_clear(&d);
    murk_multigrid_release(m);
    return pow(before / first, 0.5 / STEPS);
}

static void cycle_converges_at_any_contrast(void **state)
{
    for (size_t n = 0; n < sizeof SCENES / sizeof *SCENES; n++) {
        struct fixture f;
        open_fixture(&f, *state, &SCENES[n]);
        double rate = find_rate(*state, &f);
        print_message("%zu bricks, kappa over %g decades: %.3f a cycle\n", f.grid->brick_count,
                      SCENES[n].decades, rate);
        assert_at_most(rate, SCENES[n].rate);
        close_fixture(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_plain_assembly),
        cmocka_unit_test(every_level_is_symmetric_positive),
        cmocka_unit_test(uniform_cells_conduct_by_their_size),
        cmocka_unit_test(cycle_is_symmetric_positive),
        cmocka_unit_test(cycle_converges_at_any_contrast),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
