/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_sums.h"

static float kappa_t[MOST_EDGE * MOST_EDGE * MOST_EDGE];

enum { RADII = 41, PARTS = 6 };

/* The column of a table whose first one has RADII values from 0 to 1. */
static void read_column(const char *file, const char *column, double out[RADII])
{
    char path[512], line[4096];
    snprintf(path, sizeof path, MURK_TEST_DATA "/%s", file);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    assert_non_null(fgets(line, sizeof line, in));
    int wanted = 0, found = -1, rows = 0;
    for (char *name = strtok(line, ",\n"); name; name = strtok(NULL, ",\n"), wanted++)
        if (!strcmp(name, column))
            found = wanted;
    assert_true(found > 0);
    for (; fgets(line, sizeof line, in); rows++) {
        assert_true(rows < RADII);
        char *cell = strtok(line, ",\n");
        assert_within(atof(cell), rows / (RADII - 1.0), 1e-9);
        for (int n = 0; n < found; n++)
            cell = strtok(NULL, ",\n");
        out[rows] = atof(cell);
    }
    fclose(in);
    assert_int_equal(rows, RADII);
}

static double at_radius(const double column[RADII], double r)
{
    double x = r * (RADII - 1);
    int n = (int)fmin(x, RADII - 2);
    return column[n] + (column[n + 1] - column[n]) * (x - n);
}

/* Mean of kappa_t over a voxel, and that of kappa_t B where there is a column. */
static void average_sphere(const struct reference_sphere *c, int edge, const int at[3],
                           const double *column, double *kappa, double *emitted)
{
    *kappa = *emitted = 0;
    for (int p = 0; p < PARTS * PARTS * PARTS; p++) {
        const int part[3] = {p / PARTS / PARTS, p / PARTS % PARTS, p % PARTS};
        double r = 0;
        for (int a = 0; a < 3; a++)
            r += pow((at[a] + (part[a] + 0.5) / PARTS) * 2 / edge - 1, 2);
        r = sqrt(r);
        double k = r < 1 ? c->kappa_t * (c->radial ? 1 - r : 1) / (PARTS * PARTS * PARTS) : 0;
        *kappa += k;
        *emitted += column && k > 0 ? k * at_radius(column, r) : 0;
    }
}

void reference_sphere_open(const struct reference_sphere *c, int edge, int threads, struct world *w)
{
    assert_true(edge <= MOST_EDGE);
    const murk_array array = {.size = {edge, edge, edge},
                              .voxel_size = {2.0 / edge, 2.0 / edge, 2.0 / edge},
                              .kappa_t = kappa_t,
                              .albedo_value = c->albedo,
                              .emission_value = 1 / (1 - c->albedo)};
    for (int n = 0; n < edge * edge * edge; n++) {
        const int at[3] = {n / edge / edge, n / edge % edge, n % edge};
        double kappa, emitted;
        average_sphere(c, edge, at, NULL, &kappa, &emitted);
        kappa_t[n] = (float)kappa;
    }
    world_open(w, threads, &array, NULL);
}

struct reference_error reference_sphere_error(const struct reference_sphere *c, double within,
                                              const struct world *w)
{
    double column[RADII];
    struct reference_sums sums = {0};
    int edge = w->array.size[0];
    read_column(c->file, c->column, column);
    for (int n = 0; n < edge * edge * edge; n++) {
        const int at[3] = {n / edge / edge, n / edge % edge, n % edge};
        double kappa, emitted, r = 0;
        average_sphere(c, edge, at, column, &kappa, &emitted);
        for (int a = 0; a < 3; a++)
            r += pow((at[a] + 0.5) * 2 / edge - 1, 2);
        if (!(kappa > 0) || sqrt(r) > within)
            continue;
        double wanted = emitted / kappa, b = world_b(w, at[0], at[1], at[2]);
        reference_add(&sums, kappa, b, wanted);
    }
    return reference_result(&sums, NAN);
}
