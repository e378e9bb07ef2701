/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_sums.h"

enum { DEPTHS = 21, LAYERS = 10, COLUMNS = 40 };

struct slab_row {
    double b[DEPTHS], ground;
};

static void read_slab(const struct reference_slab *c, struct slab_row *out)
{
    char key[64], line[4096];
    snprintf(key, sizeof key, "%g,%g,%g,%g,", c->T, c->alpha, c->mu, c->rho);
    FILE *file = fopen(MURK_TEST_DATA "/slab.csv", "r");
    assert_non_null(file);
    int cells = 0;
    while (!cells && fgets(line, sizeof line, file)) {
        if (strncmp(line, key, strlen(key)))
            continue;
        for (char *cell = strtok(line, ",\n"); cell; cell = strtok(NULL, ",\n"), cells++) {
            if (cells == 7)
                out->ground = atof(cell);
            if (cells >= 9 && cells < 9 + DEPTHS)
                out->b[cells - 9] = atof(cell);
        }
    }
    fclose(file);
    assert_int_equal(cells, 9 + DEPTHS);
}

/* x ln x and its integral from 0. */
static double singular(double x)
{
    return x > 0 ? x * log(x) : 0;
}

static double singular_integral(double x)
{
    return x > 0 ? x * x / 2 * (log(x) - 0.5) : 0;
}

/* Means over LAYERS layers from the top: Simpson's rule on what is left of B without the terms
   -(alpha/2) B(0) t ln t at the top and -(alpha/2) (B(T) - B_ground) t ln t at the bottom, which
   are its leading singularities (the derivative of the integral equation with kernel E1). */
static void average_slab(const struct reference_slab *c, const struct slab_row *row,
                         double out[LAYERS])
{
    double step = c->T / (DEPTHS - 1), smooth[DEPTHS];
    double top = -c->alpha / 2 * row->b[0],
           low = -c->alpha / 2 * (row->b[DEPTHS - 1] - row->ground);
    for (int n = 0; n < DEPTHS; n++)
        smooth[n] = row->b[n] - top * singular(n * step) - low * singular(c->T - n * step);
    for (int n = 0; n < LAYERS; n++) {
        double t0 = 2 * n * step, t1 = t0 + 2 * step;
        out[n] = (smooth[2 * n] + 4 * smooth[2 * n + 1] + smooth[2 * n + 2]) / 6 +
                 (top * (singular_integral(t1) - singular_integral(t0)) +
                  low * (singular_integral(c->T - t0) - singular_integral(c->T - t1))) /
                     (2 * step);
    }
}

void reference_slab_open(const struct reference_slab *c, int edge, int threads, struct world *w)
{
    const murk_array array = {.size = {COLUMNS, COLUMNS, edge},
                              .voxel_size = {c->width / COLUMNS, c->width / COLUMNS, c->T / edge},
                              .kappa_t_value = 1,
                              .albedo_value = c->alpha};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.extent_max[0] = ground.extent_max[1] = c->width;
    ground.patches[0] = ground.patches[1] = COLUMNS;
    ground.reflectance = c->rho;
    world_open(w, threads, &array, &ground);
    w->scene.sun = (murk_sun){{sqrt(1 - c->mu * c->mu), 0, -c->mu}, 1};
}

struct reference_error reference_slab_error(const struct reference_slab *c, const struct world *w)
{
    struct slab_row row;
    struct reference_sums sums = {0};
    double wanted[LAYERS], ground = NAN;
    int edge = w->array.size[2], middle = COLUMNS / 2;
    assert_true(edge % LAYERS == 0 || LAYERS % edge == 0);
    read_slab(c, &row);
    average_slab(c, &row, wanted);
    int layers = edge < LAYERS ? edge : LAYERS, zones = edge / layers, cells = LAYERS / layers;
    for (int n = 0; n < layers; n++) {
        double b = 0, mean = 0;
        for (int k = 0; k < zones; k++)
            for (int column = 0; column < 4; column++)
                b += world_b(w, middle - column / 2, middle - column % 2, edge - 1 - n * zones - k);
        for (int k = 0; k < cells; k++)
            mean += wanted[n * cells + k] / cells;
        b /= 4 * zones;
        reference_add(&sums, 1, b, mean);
    }
    static float patches[COLUMNS * COLUMNS];
    assert_int_equal(murk_solution_ground(w->solution, patches), MURK_OK);
    if (c->rho > 0)
        ground = fabs(patches[middle * COLUMNS + middle] / row.ground - 1);
    return reference_result(&sums, ground);
}
