/* SPDX-License-Identifier: Apache-2.0 */
/* Media with reference solutions of other programs (data/README.md): sphere, slab, cube. */
#include "check.h"

#include <jansson.h>

/* Value of a column at a position in a table whose first column ascends, linearly between rows. */
static double table_at(const char *path, const char *column, double position)
{
    char line[4096];
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    int wanted = 0, found = -1;
    for (char *name = strtok(line, ",\n"); name; name = strtok(NULL, ",\n"), wanted++)
        if (!strcmp(name, column))
            found = wanted;
    assert_true(found > 0);
    double last[2] = {0}, value = NAN;
    while (isnan(value) && fgets(line, sizeof line, file)) {
        double row[2] = {0};
        int n = 0;
        for (char *cell = strtok(line, ",\n"); cell; cell = strtok(NULL, ",\n"), n++)
            if (n == 0 || n == found)
                row[n > 0] = atof(cell);
        if (row[0] >= position)
            value = row[0] > position
                        ? last[1] + (row[1] - last[1]) * (position - last[0]) / (row[0] - last[0])
                        : row[1];
        last[0] = row[0];
        last[1] = row[1];
    }
    fclose(file);
    assert_false(isnan(value));
    return value;
}

/* Part of a voxel inside the sphere of radius `radius` voxels about the middle of n^3 voxels. */
static double inside(int n, double radius, int i, int j, int k)
{
    enum { PARTS = 6 };
    int count = 0;
    for (int p = 0; p < PARTS * PARTS * PARTS; p++) {
        double x = i + (p / PARTS / PARTS + 0.5) / PARTS - n / 2.0,
               y = j + (p / PARTS % PARTS + 0.5) / PARTS - n / 2.0,
               z = k + (p % PARTS + 0.5) / PARTS - n / 2.0;
        count += x * x + y * y + z * z < radius * radius;
    }
    return count / (double)(PARTS * PARTS * PARTS);
}

/* A sphere of 20 voxels radius and optical radius 2, albedo 0.9, (1 - albedo) E = 1. Voxels of 0.1
   optical depths make an error of their square over 12 in a flat source and a rim that is uncertain
   by a part of a voxel: 0.5 % together where the reference is taken. */
static void sphere(void **state)
{
    (void)state;
    enum { N = 40 };
    static float kappa_t[N * N * N];
    for (int n = 0; n < N * N * N; n++)
        kappa_t[n] = (float)(2 * inside(N, 20, n / N / N, n / N % N, n % N));
    const murk_array array = {.size = {N, N, N},
                              .voxel_size = {0.05, 0.05, 0.05},
                              .kappa_t = kappa_t,
                              .albedo_value = 0.9,
                              .emission_value = 10};
    struct world w;
    world_open(&w, 2, &array, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    world_solve(&w, &options);
    double sum[2] = {0}, most = 0;
    for (int n = 0; n < N * N * N; n++) {
        int i = n / N / N, j = n / N % N, k = n % N;
        double r = sqrt(pow(i + 0.5 - 20, 2) + pow(j + 0.5 - 20, 2) + pow(k + 0.5 - 20, 2)) / 20;
        if (r > 0.9 || n % 7) /* every seventh zone will do */
            continue;
        double wanted = table_at(MURK_TEST_DATA "/sphere_uniform.csv", "R2_a0.9", r);
        double d = world_b(&w, i, j, k) / wanted - 1;
        sum[0] += d * d;
        sum[1]++;
        most = fmax(most, fabs(d));
    }
    print_message("sphere: rms %.3f %%, most %.3f %%\n", 100 * sqrt(sum[0] / sum[1]), 100 * most);
    assert_true(sum[1] > 2000);
    assert_at_most(sqrt(sum[0] / sum[1]), 0.005);
    assert_at_most(most, 0.01);
    world_close(&w);
}

/* One row of slab.csv in the middle of a box that is 20 optical depths wide, its ground reaching
   further: what comes from the sides is below e^-10. Layers are 1/20 optical depths. */
static void check_slab(double mu, double rho, const char *key)
{
    enum { N = 40, LAYERS = 20 };
    char line[4096];
    FILE *file = fopen(MURK_TEST_DATA "/slab.csv", "r");
    assert_non_null(file);
    double B[21] = {0}, B_ground = NAN;
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, key, strlen(key)))
            continue;
        int n = 0;
        for (char *cell = strtok(line, ",\n"); cell; cell = strtok(NULL, ",\n"), n++) {
            if (n == 7)
                B_ground = atof(cell);
            if (n >= 9)
                B[n - 9] = atof(cell);
        }
        assert_int_equal(n, 30);
    }
    fclose(file);
    assert_false(isnan(B_ground));
    const murk_array array = {.size = {N, N, LAYERS},
                              .voxel_size = {0.5, 0.5, 1.0 / LAYERS},
                              .kappa_t_value = 1,
                              .albedo_value = 0.9};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.extent_max[0] = ground.extent_max[1] = N * 0.5;
    ground.patches[0] = ground.patches[1] = N;
    ground.reflectance = rho;
    struct world w;
    world_open(&w, 2, &array, &ground);
    w.scene.sun = (murk_sun){{sqrt(1 - mu * mu), 0, -mu}, 1};
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    world_solve(&w, &options);
    double most = 0;
    for (int k = 0; k < LAYERS; k++) {
        /* Depth counts from the top; the table has the faces of the layers. Simpson's rule would
           need the middle: B is smooth, its mean that of the faces to 1e-3. */
        double wanted = (B[LAYERS - 1 - k] + B[LAYERS - k]) / 2;
        double got = (world_b(&w, N / 2, N / 2, k) + world_b(&w, N / 2 - 1, N / 2 - 1, k)) / 2;
        most = fmax(most, fabs(got / wanted - 1));
    }
    static float patches[N * N];
    assert_int_equal(murk_solution_ground(w.solution, patches), MURK_OK);
    double patch = patches[N / 2 * N + N / 2];
    print_message("slab mu %g rho %g: %.3f %%, ground %g for %g\n", mu, rho, 100 * most, patch,
                  B_ground);
    assert_at_most(most, 0.01);
    assert_within(patch, B_ground, 0.01 * B_ground);
    world_close(&w);
}

static void slab(void **state)
{
    (void)state;
    check_slab(1, 0, "1,0.9,1,0,");
    check_slab(1, 0.3, "1,0.9,1,0.3,");
    check_slab(0.5, 0.3, "1,0.9,0.5,0.3,");
}

/* Averages over the cells of a 20^3 grid; kappa_t is trilinear within an octant, so that its mean
   over a cell is the value in the middle. */
static void check_cube(const json_t *entry, double tolerance)
{
    enum { N = 20 };
    static float kappa_t[N * N * N];
    double a = json_number_value(json_object_get(entry, "a"));
    double b = json_number_value(json_object_get(entry, "b"));
    for (int n = 0; n < N * N * N; n++) {
        const int at[3] = {n / N / N, n / N % N, n % N};
        double product = a;
        for (int c = 0; c < 3; c++)
            product *= 1 - 2 * fabs((at[c] + 0.5) / N - 0.5);
        kappa_t[n] = (float)(product + b);
    }
    const murk_array array = {.size = {N, N, N},
                              .voxel_size = {1.0 / N, 1.0 / N, 1.0 / N},
                              .kappa_t = kappa_t,
                              .albedo_value = json_number_value(json_object_get(entry, "omega")),
                              .emission_value = 1};
    struct world w;
    world_open(&w, 2, &array, NULL);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.003;
    world_solve(&w, &options);
    const json_t *cells = json_object_get(entry, "cell20");
    double sum[2] = {0};
    for (size_t n = 0; n < json_array_size(cells); n++) {
        int at[3];
        for (size_t c = 0; c < 3; c++) /* counted from the centre outwards */
            at[c] = 10 + (int)json_integer_value(json_array_get(json_array_get(cells, n), c));
        double wanted = json_number_value(json_array_get(json_array_get(cells, n), 3));
        double d = world_b(&w, at[0], at[1], at[2]) / wanted - 1;
        sum[0] += d * d;
        sum[1]++;
    }
    print_message("cube %g %g %g: %.3f %%\n", a, b, array.albedo_value,
                  100 * sqrt(sum[0] / sum[1]));
    assert_int_equal(sum[1], 220);
    assert_at_most(sqrt(sum[0] / sum[1]), tolerance);
    world_close(&w);
}

static void cube(void **state)
{
    (void)state;
    json_error_t error;
    json_t *all = json_load_file(MURK_TEST_DATA "/unit_cube.json", 0, &error);
    assert_non_null(all);
    int checked = 0;
    for (size_t n = 0; n < json_array_size(all); n++) {
        const json_t *entry = json_array_get(all, n);
        if (!json_is_array(json_object_get(entry, "cell20")))
            continue;
        /* The tolerance asked for, and the flat source: zones of x optical depths diffuse light
           as if they were 1 + x^2 / 4 times thinner (data/README.md). */
        double x = (json_number_value(json_object_get(entry, "a")) +
                    json_number_value(json_object_get(entry, "b"))) /
                   20;
        check_cube(entry, 0.003 + x * x / 4);
        checked++;
    }
    assert_true(checked > 20);
    json_decref(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sphere),
        cmocka_unit_test(slab),
        cmocka_unit_test(cube),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
