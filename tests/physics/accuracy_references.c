/* SPDX-License-Identifier: Apache-2.0 */
#include "accuracy.h"

#include "references.h"
#include "statistics.h"

enum { EDGES = 4, MOST_VALUES = 40 * 40 * 10 };

/* A reference at the resolutions of its table, and the one where the quadrature varies. */
struct reference {
    const char *name;
    void (*open)(int edge, struct world *w);
    struct reference_error (*error)(const struct world *w);
    int edges[EDGES], edge;
};

#define SPHERE(NAME, ...)                                                                          \
    static const struct reference_sphere NAME = {__VA_ARGS__};                                     \
    static void NAME##_open(int edge, struct world *w)                                             \
    {                                                                                              \
        reference_sphere_open(&NAME, edge, 1, w);                                                  \
    }                                                                                              \
    static struct reference_error NAME##_error(const struct world *w)                              \
    {                                                                                              \
        return reference_sphere_error(&NAME, INFINITY, w);                                         \
    }

#define FLAT(KIND, NAME, ...)                                                                      \
    static const struct reference_##KIND NAME = {__VA_ARGS__};                                     \
    static void NAME##_open(int edge, struct world *w)                                             \
    {                                                                                              \
        reference_##KIND##_open(&NAME, edge, 1, w);                                                \
    }                                                                                              \
    static struct reference_error NAME##_error(const struct world *w)                              \
    {                                                                                              \
        return reference_##KIND##_error(&NAME, w);                                                 \
    }

SPHERE(sphere, "sphere_uniform.csv", "R2_a0.9", 2, 0.9, false)
SPHERE(sphere_thick, "sphere_uniform.csv", "R20_a0.99", 20, 0.99, false)
SPHERE(sphere_linear, "sphere_linear_kappa.csv", "tau2_a0.9", 4, 0.9, true)
FLAT(slab, slab, 1, 0.9, 0.5, 0.3, 20)
FLAT(slab, slab_wide, 1, 0.9, 0.5, 0.3, 40)
FLAT(slab, slab_thick, 5, 0.99, 1, 0.3, 80)
FLAT(slab, slab_thick_wide, 5, 0.99, 1, 0.3, 160)
FLAT(cube, cube, 9, 1, 0.9)
FLAT(cube, cube_thick, 0, 10, 0.99)

static void box_open(int edge, struct world *w)
{
    reference_box_open(edge, 1, w);
}

#define ROW(NAME) NAME##_open, NAME##_error

static const struct reference REFERENCES[] = {
    {"sphere, radius 2, α 0.9", ROW(sphere), {10, 20, 40, 80}, 10},
    {"sphere, radius 20, α 0.99", ROW(sphere_thick), {10, 20, 40, 80}, 10},
    {"sphere, κ = 4 (1 − r), α 0.9", ROW(sphere_linear), {10, 20, 40, 80}, 10},
    {"slab, T 1, α 0.9", ROW(slab), {5, 10, 20, 40}, 5},
    {"slab, T 5, α 0.99", ROW(slab_thick), {5, 10, 20, 40}, 5},
    {"cube, κ 1 … 10, α 0.9", ROW(cube), {10, 20, 40, 80}, 10},
    {"cube, κ 10, α 0.99", ROW(cube_thick), {5, 10, 20, 40}, 10},
    {"the paper's box", box_open, reference_box_error, {10, 20, 40}, 10},
};

enum { REFERENCE_COUNT = sizeof REFERENCES / sizeof *REFERENCES };

static void solve(struct world *w, int directions, int rays)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = directions;
    options.rays = rays;
    options.tolerance = 1e-4;
    world_solve(w, &options);
}

/* A cell of a table, with the order p by which it is below the one before at `ratio` times the
   effort. */
static void print_cell(double error, double before, double ratio)
{
    printf(" %.3f", 100 * error);
    if (before > 0)
        printf(" (%.1f)", log(before / error) / log(ratio));
    printf(" |");
}

void accuracy_resolution(void)
{
    printf("| reference | voxels an edge | zones [%%] (p) | worst cell [%%] (p) | ground [%%] (p) "
           "|\n|---|---|---|---|---|\n");
    for (int n = 0; n < REFERENCE_COUNT; n++) {
        struct reference_error before = {0};
        for (int row = 0; row < EDGES && REFERENCES[n].edges[row]; row++) {
            struct world w;
            REFERENCES[n].open(REFERENCES[n].edges[row], &w);
            solve(&w, 1536, 2);
            struct reference_error e = REFERENCES[n].error(&w);
            printf("| %s | %d |", row ? "" : REFERENCES[n].name, REFERENCES[n].edges[row]);
            print_cell(e.zones, before.zones, 2);
            print_cell(e.most, before.most, 2);
            if (isnan(e.ground))
                printf(" – |");
            else
                print_cell(e.ground, before.ground, 2);
            printf("\n");
            fflush(stdout);
            before = e;
            world_close(&w);
        }
    }
    static const struct reference pairs[][2] = {
        {{"slab, T 1", ROW(slab), {0}, 10}, {"", ROW(slab_wide), {0}, 10}},
        {{"slab, T 5", ROW(slab_thick), {0}, 10}, {"", ROW(slab_thick_wide), {0}, 10}}};
    for (int n = 0; n < 2; n++) {
        double b[2] = {0};
        for (int wide = 0; wide < 2; wide++) {
            struct world w;
            pairs[n][wide].open(10, &w);
            solve(&w, 1536, 2);
            for (int k = 0; k < 10; k++)
                b[wide] += world_b(&w, 20, 20, k);
            world_close(&w);
        }
        printf("\n%s: twice the width changes the middle column by %.3f %%.\n", pairs[n][0].name,
               100 * fabs(b[1] / b[0] - 1));
    }
    printf("\n");
}

/* B of all voxels, and the norm of a difference weighted by kappa_t. */
static void take(const struct world *w, double *b)
{
    const int32_t *size = w->array.size;
    size_t n = 0;
    for (int i = 0; i < size[0]; i++)
        for (int j = 0; j < size[1]; j++)
            for (int k = 0; k < size[2]; k++, n++)
                b[n] = !w->array.kappa_t || w->array.kappa_t[n] > 0 ? world_b(w, i, j, k) : 0;
}

static double differ(const struct world *w, const double *b, const double *best)
{
    double difference = 0, size = 0;
    for (size_t n = 0; n < check_count(&w->array); n++) {
        double kappa = w->array.kappa_t ? w->array.kappa_t[n] : 1;
        difference += kappa * pow(b[n] - best[n], 2);
        size += kappa * best[n] * best[n];
    }
    return sqrt(difference / size);
}

static const struct quadrature {
    int directions, rays;
} BY_DIRECTIONS[] = {{48, 2}, {96, 2}, {192, 2}, {384, 2}, {768, 2}, {1536, 2}, {3072, 2}},
  BY_RAYS[] = {{768, 1}, {768, 2}, {768, 4}}, BEST_DIRECTIONS = {12288, 2}, BEST_RAYS = {768, 8};

enum { MOST_ROWS = 7 };

struct quadrature_errors {
    double reference[REFERENCE_COUNT][MOST_ROWS], best[REFERENCE_COUNT][MOST_ROWS];
};

static void measure(const struct quadrature *rows, int count, struct quadrature best,
                    struct quadrature_errors *out)
{
    static double b[MOST_VALUES], finest[MOST_VALUES];
    for (int n = 0; n < REFERENCE_COUNT; n++) {
        struct world w;
        REFERENCES[n].open(REFERENCES[n].edge, &w);
        assert_true(check_count(&w.array) <= MOST_VALUES);
        solve(&w, best.directions, best.rays);
        take(&w, finest);
        for (int row = 0; row < count; row++) {
            solve(&w, rows[row].directions, rows[row].rays);
            take(&w, b);
            out->best[n][row] = differ(&w, b, finest);
            out->reference[n][row] = REFERENCES[n].error(&w).zones;
        }
        world_close(&w);
    }
}

/* Directions are not nested, so that p from row to row jumps: a fit of all rows. */
static void print_orders(const struct quadrature *rows, int count,
                         const double errors[REFERENCE_COUNT][MOST_ROWS], bool by_rays)
{
    double x[MOST_ROWS];
    for (int row = 0; row < count; row++)
        x[row] = by_rays ? rows[row].rays : rows[row].directions;
    printf("| p of all |");
    for (int n = 0; n < REFERENCE_COUNT; n++)
        printf(" %.2f |", -bench_power(x, errors[n], (size_t)count));
    printf("\n");
}

static void print_quadrature(const char *what, const struct quadrature *rows, int count,
                             const double errors[REFERENCE_COUNT][MOST_ROWS], bool by_rays,
                             bool orders)
{
    printf("| %s |", what);
    for (int n = 0; n < REFERENCE_COUNT; n++)
        printf(" %s, %d |", REFERENCES[n].name, REFERENCES[n].edge);
    printf("\n|---|");
    for (int n = 0; n < REFERENCE_COUNT; n++)
        printf("---|");
    printf("\n");
    for (int row = 0; row < count; row++) {
        printf("| %d |", by_rays ? rows[row].rays : rows[row].directions);
        for (int n = 0; n < REFERENCE_COUNT; n++)
            print_cell(errors[n][row], orders && row ? errors[n][row - 1] : 0, 2);
        printf("\n");
    }
    if (orders)
        print_orders(rows, count, errors, by_rays);
    printf("\n");
    fflush(stdout);
}

void accuracy_quadrature(void)
{
    static struct quadrature_errors errors;
    enum { DIRECTIONS = sizeof BY_DIRECTIONS / sizeof *BY_DIRECTIONS };
    enum { RAYS = sizeof BY_RAYS / sizeof *BY_RAYS };
    measure(BY_DIRECTIONS, DIRECTIONS, BEST_DIRECTIONS, &errors);
    print_quadrature("directions: to 12288 [%] (p)", BY_DIRECTIONS, DIRECTIONS, errors.best, false,
                     true);
    print_quadrature("directions: to the reference [%]", BY_DIRECTIONS, DIRECTIONS,
                     errors.reference, false, false);
    measure(BY_RAYS, RAYS, BEST_RAYS, &errors);
    print_quadrature("lines a face and axis: to 8 [%] (p)", BY_RAYS, RAYS, errors.best, true, true);
    print_quadrature("lines a face and axis: to the reference [%]", BY_RAYS, RAYS, errors.reference,
                     true, false);
}
