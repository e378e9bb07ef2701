/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_sums.h"

enum { BOX = 10 };

void reference_box_open(int edge, int threads, struct world *w)
{
    static float reflectance[MOST_EDGE * MOST_EDGE];
    assert_true(edge % BOX == 0 && edge <= MOST_EDGE);
    const murk_array array = {.size = {edge, edge, edge},
                              .voxel_size = {1.0 / edge, 1.0 / edge, 0.5 / edge},
                              .kappa_t_value = 0.8,
                              .albedo_value = 0.625}; /* (0.8 - 0.3) / 0.8 */
    for (int n = 0; n < edge * edge; n++) {           /* symmetric: image order does not matter */
        int i = n % edge * BOX / edge, j = n / edge * BOX / edge;
        reflectance[n] = i >= 3 && i < 7 && j >= 3 && j < 7 ? 0.6f : 0.3f;
    }
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.patches[0] = ground.patches[1] = edge;
    ground.reflectance_image = reflectance;
    ground.horizon = false;
    world_open(w, threads, &array, &ground);
    w->scene.sun = (murk_sun){{0, 0, -1}, 1};
}

static double box_zone(const struct world *w, int width, int i, int j, int k)
{
    double b = 0;
    for (int p = 0; p < width * width * width; p++)
        b += world_b(w, i * width + p / width / width, j * width + p / width % width,
                     k * width + p % width);
    return b / (width * width * width);
}

static double box_patch(const float *ground, int width, int i, int j)
{
    double b = 0;
    for (int p = 0; p < width * width; p++)
        b += ground[((BOX - 1 - j) * width + p / width) * BOX * width + i * width + p % width];
    return b / (width * width);
}

struct reference_error reference_box_error(const struct world *w)
{
    static float ground[MOST_EDGE * MOST_EDGE];
    assert_int_equal(murk_solution_ground(w->solution, ground), MURK_OK);
    FILE *file = fopen(MURK_TEST_DATA "/paper_box.csv", "r");
    assert_non_null(file);
    char line[256], type;
    struct reference_sums zones = {0}, patches = {0};
    double wanted;
    int i, j, k, rows = 0, width = w->array.size[0] / BOX;
    assert_non_null(fgets(line, sizeof line, file));
    for (; fgets(line, sizeof line, file); rows++) {
        assert_int_equal(sscanf(line, "%c,%d,%d,%d,%lf", &type, &i, &j, &k, &wanted), 5);
        double b = type == 'V' ? box_zone(w, width, i, j, k) : box_patch(ground, width, i, j);
        reference_add(type == 'V' ? &zones : &patches, 1, b, wanted);
    }
    fclose(file);
    assert_int_equal(rows, BOX * BOX * BOX + BOX * BOX);
    return reference_result(&zones, sqrt(patches.difference / patches.size));
}
