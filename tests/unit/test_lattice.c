/* SPDX-License-Identifier: Apache-2.0 */
/* Lattices of lines: where each piece of a line lies, and that voxels keep their volume. */
#include "lattice.h"
#include "sparse.h"

/* Where line r is on axis c (0: u, 1: v) when its coordinate on the dominant axis is at. */
static double position(const murk_lattice *lattice, int c, int32_t r, double at)
{
    return r + lattice->offset[c] + lattice->slope[c] * (at - lattice->middle);
}

/* Follows line (ru, rv) through one layer: every piece has its middle in the voxel that it claims,
   and adds length * area * span^2 to the volume of that voxel. */
static void follow(const murk_grid *grid, const murk_lattice *lattice, const murk_layer *layer,
                   int32_t c, int32_t ru, int32_t rv, double *volume)
{
    double sum = 0;
    for (int s = 0; s < layer->count; s++) {
        const murk_segment *segment = &layer->segment[s];
        double part = segment->length / lattice->length, within = sum + part / 2;
        double at = c + (lattice->sign > 0 ? within : 1 - within);
        const int32_t cell[2] = {ru + layer->shift[0] + segment->du,
                                 rv + layer->shift[1] + segment->dv};
        for (int n = 0; n < 2; n++) {
            double x = position(lattice, n, n ? rv : ru, at);
            assert_true(x >= cell[n] - 1e-6 && x <= cell[n] + 1 + 1e-6);
            assert_within(segment->middle[n], x - cell[n] - 0.5, 1e-6);
            assert_within(segment->change[n], lattice->slope[n] * lattice->sign * part, 1e-6);
        }
        assert_within(segment->middle[2], at - c - 0.5, 1e-6);
        assert_within(segment->change[2], lattice->sign * part, 1e-6);
        sum += part;
        int32_t voxel[3];
        voxel[lattice->axis] = c;
        voxel[lattice->u] = cell[0];
        voxel[lattice->v] = cell[1];
        int64_t slot = murk_grid_slot(grid, voxel[0] + grid->lo[0], voxel[1] + grid->lo[1],
                                      voxel[2] + grid->lo[2]);
        if (slot >= 0)
            volume[slot] += segment->length * lattice->area * lattice->span * lattice->span;
    }
}

/* All lines of a lattice that meet a brick, and those alone, in the layers of that brick. */
static void cross_brick(const murk_grid *grid, const murk_lattice *lattice, size_t b,
                        double *volume)
{
    murk_layers layers;
    int32_t low[3];
    murk_lattice_layers(lattice, grid, grid->brick[b][lattice->axis], &layers);
    for (int a = 0; a < 3; a++)
        low[a] = 8 * grid->brick[b][a] - grid->lo[a];
    for (int c = 0; c < 2; c++)
        assert_true(layers.last[c] - layers.first[c] < MURK_WINDOW);
    for (int k = 0; k < 8; k++) {
        const murk_layer *layer = &layers.layer[k];
        double sum = 0;
        assert_in_range(layer->count, 1, 3);
        for (int s = 0; s < layer->count; s++)
            sum += layer->segment[s].length;
        assert_within(sum / lattice->length, 1, 1e-6); /* lengths are floats */
        for (int32_t rv = layers.first[1]; rv <= layers.last[1]; rv++)
            for (int32_t ru = layers.first[0]; ru <= layers.last[0]; ru++)
                follow(grid, lattice, layer, low[lattice->axis] + k, low[lattice->u] + ru,
                       low[lattice->v] + rv, volume);
    }
}

/* With rays x rays lines a face every voxel of every brick is crossed by its own volume. */
static void check_lattices(const murk_grid *grid, const double direction[3], int rays, double start)
{
    size_t slots = grid->brick_count * MURK_BRICK_SLOTS;
    double *volume = murk_alloc(2 * slots, sizeof *volume), *all = volume + slots;
    for (int i = 0; i < rays * rays; i++) {
        murk_line line = {.offset = {(i % rays + start) / rays, (i / rays + start) / rays},
                          .span = 1.0 / rays,
                          .weight = 1};
        memcpy(line.direction, direction, sizeof line.direction);
        murk_lattice lattice;
        murk_lattice_lay(&lattice, grid, &line);
        /* The perpendicular section of a face, from its edges. */
        int a = lattice.axis;
        double face = grid->volume / grid->voxel[a];
        assert_within(lattice.area, face * fabs(direction[a]), 1e-12 * face);
        assert_within(lattice.length * lattice.area, grid->volume, 1e-12 * grid->volume);
        for (size_t b = 0; b < grid->brick_count; b++) {
            memset(volume, 0, slots * sizeof *volume);
            cross_brick(grid, &lattice, b, volume);
            for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
                all[b * MURK_BRICK_SLOTS + (size_t)slot] +=
                    volume[b * MURK_BRICK_SLOTS + (size_t)slot];
        }
    }
    for (size_t i = 0; i < slots; i++)
        assert_within(all[i], grid->volume, 2e-6 * grid->volume);
    murk_free(volume);
}

static void random_directions(void **state)
{
    sparse s = {.low = {-1, 0, 1}, .edge = 2, .bricks = 0.7, .voxels = 0.1, .voxel = {1, 0.5, 2}};
    uint64_t random = 7;
    murk_grid *grid = sparse_create(*state, &s, &random);
    for (int n = 0; n < 30; n++) {
        double direction[3];
        check_direction(&random, direction);
        check_lattices(grid, direction, 1 + n % 3, n % 2 ? 0 : 0.5);
    }
    murk_grid_release(grid);
}

/* Along axes, face diagonals and space diagonals lines meet edges and corners. */
static void straight_directions(void **state)
{
    sparse s = {.low = {-1, -1, 0}, .edge = 2, .bricks = 0.7, .voxels = 0.1, .voxel = {1, 1, 1}};
    uint64_t random = 8;
    murk_grid *grid = sparse_create(*state, &s, &random);
    for (int n = 0; n < 27; n++) {
        double d[3] = {n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
        double size = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (n == 13)
            continue;
        for (int a = 0; a < 3; a++)
            d[a] /= size;
        check_lattices(grid, d, 1, 0.5);
        check_lattices(grid, d, 2, 0);
    }
    murk_grid_release(grid);
}

/* The dominant axis is the one whose layers the direction crosses fastest. */
static void dominant(void **state)
{
    sparse s = {.edge = 1, .bricks = 1, .voxels = 0.1, .voxel = {1, 0.25, 1}};
    uint64_t random = 9;
    murk_grid *grid = sparse_create(*state, &s, &random);
    assert_int_equal(murk_lattice_axis(grid, (const double[3]){0.8, 0.6, 0}), 1);
    assert_int_equal(murk_lattice_axis(grid, (const double[3]){-0.99, 0.1, 0.1}), 0);
    assert_int_equal(murk_lattice_axis(grid, (const double[3]){0, 0.1, -0.99}), 2);
    assert_int_equal(murk_lattice_signs((const double[3]){0.1, -0.1, 0.9}), 1 | 4);
    murk_grid_release(grid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_directions),
        cmocka_unit_test(straight_directions),
        cmocka_unit_test(dominant),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
