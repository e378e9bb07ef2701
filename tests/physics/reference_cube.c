/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_sums.h"

#include <jansson.h>

static float kappa_t[MOST_EDGE * MOST_EDGE * MOST_EDGE];

enum { CELLS = 20 };

static double number(const json_t *entry, const char *key)
{
    return json_number_value(json_object_get(entry, key));
}

static json_t *read_cubes(void)
{
    json_error_t error;
    json_t *all = json_load_file(MURK_TEST_DATA "/unit_cube.json", 0, &error);
    assert_non_null(all);
    return all;
}

int reference_cube_list(struct reference_cube *out, int count)
{
    json_t *all = read_cubes();
    int found = 0;
    for (size_t n = 0; n < json_array_size(all); n++) {
        const json_t *entry = json_array_get(all, n);
        if (!json_is_array(json_object_get(entry, "cell20")))
            continue;
        if (found < count)
            out[found] = (struct reference_cube){number(entry, "a"), number(entry, "b"),
                                                 number(entry, "omega")};
        found++;
    }
    json_decref(all);
    return found;
}

/* From a cell's number on an axis to that counted from the centre. */
static int fold(int n)
{
    return n < CELLS / 2 ? CELLS / 2 - 1 - n : n - CELLS / 2;
}

/* The means of an eighth of the cube in any order of the axes. */
static void read_cells(const json_t *cells, double out[CELLS / 2][CELLS / 2][CELLS / 2])
{
    assert_int_equal(json_array_size(cells), 220);
    for (size_t n = 0; n < json_array_size(cells); n++) {
        json_int_t x[3];
        for (size_t c = 0; c < 3; c++)
            x[c] = json_integer_value(json_array_get(json_array_get(cells, n), c));
        double b = json_number_value(json_array_get(json_array_get(cells, n), 3));
        for (int turn = 0; turn < 3; turn++) {
            json_int_t p = x[turn], q = x[(turn + 1) % 3], r = x[(turn + 2) % 3];
            out[p][q][r] = out[p][r][q] = b;
        }
    }
}

void reference_cube_means(const struct reference_cube *c, int edge, double *out)
{
    static double cell[CELLS / 2][CELLS / 2][CELLS / 2];
    json_t *all = read_cubes();
    const json_t *cells = NULL;
    for (size_t n = 0; n < json_array_size(all); n++) {
        const json_t *entry = json_array_get(all, n);
        if (number(entry, "a") == c->a && number(entry, "b") == c->b &&
            number(entry, "omega") == c->omega)
            cells = json_object_get(entry, "cell20");
    }
    read_cells(cells, cell);
    json_decref(all);
    assert_true(CELLS % edge == 0);
    int width = CELLS / edge;
    memset(out, 0, (size_t)(edge * edge * edge) * sizeof *out);
    for (int n = 0; n < CELLS * CELLS * CELLS; n++) {
        int i = n / CELLS / CELLS, j = n / CELLS % CELLS, k = n % CELLS;
        out[(i / width * edge + j / width) * edge + k / width] +=
            cell[fold(i)][fold(j)][fold(k)] / (width * width * width);
    }
}

/* kappa_t is trilinear within an octant: its mean over a voxel is the value in the middle. */
void reference_cube_open(const struct reference_cube *c, int edge, int threads, struct world *w)
{
    assert_true(edge <= MOST_EDGE && (edge % 2 == 0 || c->a == 0));
    const murk_array array = {.size = {edge, edge, edge},
                              .voxel_size = {1.0 / edge, 1.0 / edge, 1.0 / edge},
                              .kappa_t = kappa_t,
                              .albedo_value = c->omega,
                              .emission_value = 1};
    for (int n = 0; n < edge * edge * edge; n++) {
        const int at[3] = {n / edge / edge, n / edge % edge, n % edge};
        double product = c->a;
        for (int a = 0; a < 3; a++)
            product *= 1 - 2 * fabs((at[a] + 0.5) / edge - 0.5);
        kappa_t[n] = (float)(product + c->b);
    }
    world_open(w, threads, &array, NULL);
}

struct reference_error reference_cube_error(const struct reference_cube *c, const struct world *w)
{
    static double wanted[CELLS * CELLS * CELLS];
    struct reference_sums sums = {0};
    int edge = w->array.size[0], cells = edge < CELLS ? edge : CELLS, width = edge / cells;
    reference_cube_means(c, cells, wanted);
    for (int n = 0; n < cells * cells * cells; n++) {
        double b = 0, kappa = 0;
        for (int p = 0; p < width * width * width; p++) {
            int i = n / cells / cells * width + p / width / width,
                j = n / cells % cells * width + p / width % width,
                k = n % cells * width + p % width;
            b += world_b(w, i, j, k) / (width * width * width);
            kappa += kappa_t[(i * edge + j) * edge + k];
        }
        reference_add(&sums, kappa, b, wanted[n]);
    }
    return reference_result(&sums, NAN);
}
