/* SPDX-License-Identifier: Apache-2.0 */
/* What the workers of a sweep hold beside their tallies, from the pages that lines meet. */
#include "lines_memory.h"

#include "quadrature.h"
#include "sweep_state.h"

#include <math.h>
#include <string.h>

/* Lines u, v of the bricks of a slab: as in murk_layers. */
typedef struct span {
    int32_t first[2], last[2];
} span;

/* Pages that are met, over the box that the lines of a lattice may fill. */
typedef struct page_map {
    int32_t low[2], count[2];
    uint8_t *met;
} page_map;

static int32_t page_of(double line)
{
    return (int32_t)floor(line / MURK_PAGE);
}

/* Lines of a slab, in pages of the grid whose voxels are `edge` of the given one's. */
static double line_of(const murk_grid *grid, size_t brick, int axis, int32_t line, double edge)
{
    int32_t cell = grid->brick[brick][axis] * MURK_BRICK_EDGE - grid->lo[axis];
    return (cell + line) / edge;
}

static bool map_pages(const murk_grid *grid, const murk_lattice *lattice, const span *rows,
                      double edge, page_map *map)
{
    const int across[2] = {lattice->u, lattice->v};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    int32_t bottom = grid->lo[lattice->axis] >> 3, top = (grid->hi[lattice->axis] - 1) >> 3;
    for (int c = 0; c < 2; c++)
        for (int32_t row = bottom; row <= top; row++) {
            low[c] = fmin(low[c], rows[row - bottom].first[c] - MURK_BRICK_EDGE);
            high[c] = fmax(high[c],
                           rows[row - bottom].last[c] + grid->hi[across[c]] - grid->lo[across[c]]);
        }
    for (int c = 0; c < 2; c++) {
        map->low[c] = page_of(low[c] / edge);
        map->count[c] = page_of(high[c] / edge) - map->low[c] + 1;
    }
    map->met = murk_alloc((size_t)map->count[0] * (size_t)map->count[1], 1);
    return map->met;
}

/* Pages that the lines of one lattice meet; negative when memory runs out. */
static double count_pages(const murk_grid *grid, const murk_lattice *lattice, span *rows,
                          double edge)
{
    const int axis = lattice->axis, across[2] = {lattice->u, lattice->v};
    const int32_t bottom = grid->lo[axis] >> 3, top = (grid->hi[axis] - 1) >> 3;
    double pages = 0;
    page_map map;
    for (int32_t row = bottom; row <= top; row++) {
        murk_layers layers;
        murk_lattice_layers(lattice, grid, row, &layers);
        memcpy(rows[row - bottom].first, layers.first, sizeof layers.first);
        memcpy(rows[row - bottom].last, layers.last, sizeof layers.last);
    }
    if (!map_pages(grid, lattice, rows, edge, &map))
        return -1;
    for (size_t b = 0; b < grid->brick_count; b++) {
        const span *row = &rows[grid->brick[b][axis] - bottom];
        int32_t from[2], to[2];
        for (int c = 0; c < 2; c++) {
            from[c] = page_of(line_of(grid, b, across[c], row->first[c], edge)) - map.low[c];
            to[c] = page_of(line_of(grid, b, across[c], row->last[c], edge)) - map.low[c];
        }
        for (int32_t v = from[1]; v <= to[1]; v++)
            for (int32_t u = from[0]; u <= to[0]; u++) {
                uint8_t *met = &map.met[v * map.count[0] + u];
                pages += !*met;
                *met = 1;
            }
    }
    murk_free(map.met);
    return pages;
}

/* The most pages of a lattice; infinite when memory runs out. Opposite directions share lines. */
static double most_pages(murk_context *context, const murk_grid *grid, int orbits, double edge)
{
    double most = 0;
    int32_t rows = 0;
    murk_quadrature quadrature;
    for (int a = 0; a < 3; a++)
        rows = grid->hi[a] - grid->lo[a] > rows ? grid->hi[a] - grid->lo[a] : rows;
    span *row = murk_alloc((size_t)rows / MURK_BRICK_EDGE + 2, sizeof *row);
    if (!row || murk_quadrature_create(context, orbits, 0, &quadrature)) {
        murk_free(row);
        return INFINITY;
    }
    for (int d = 0; d < quadrature.count; d++) {
        murk_line line = {.offset = {0.5, 0.5}, .span = 1, .weight = 1};
        murk_lattice lattice;
        memcpy(line.direction, quadrature.direction[d], sizeof line.direction);
        murk_lattice_lay(&lattice, grid, &line);
        if (lattice.sign < 0)
            continue;
        double pages = count_pages(grid, &lattice, row, edge);
        most = pages < 0 ? INFINITY : fmax(most, pages);
    }
    murk_quadrature_clear(&quadrature);
    murk_free(row);
    return most;
}

/* Most bricks of a slab; infinite when memory runs out. */
static double widest_slab(const murk_grid *grid)
{
    size_t most = 0;
    for (int a = 0; a < 3; a++) {
        int32_t bottom = grid->lo[a] >> 3, top = (grid->hi[a] - 1) >> 3;
        size_t *bricks = murk_alloc((size_t)(top - bottom + 1), sizeof *bricks);
        if (!bricks)
            return INFINITY;
        for (size_t b = 0; b < grid->brick_count; b++) {
            size_t *here = &bricks[grid->brick[b][a] - bottom];
            most = ++*here > most ? *here : most;
        }
        murk_free(bricks);
    }
    return (double)most;
}

double murk_lines_memory(murk_context *context, const murk_lines_plan *plan)
{
    enum { FACES = 6 };
    const murk_grid *grid = plan->grid;
    if (!grid->brick_count)
        return 0;
    const int count = plan->orbits * MURK_ORBIT, threads = context->threads;
    /* As the sweep shares them out: lines of a block have an axis and a way along it in common. */
    const int shared = (count + 2 * threads - 1) / (2 * threads), face = count / FACES;
    int planes = shared < MURK_BLOCK ? shared : MURK_BLOCK;
    planes = face < planes ? face : planes;
    const int blocks = FACES * ((face + planes - 1) / planes);
    const int workers = threads < blocks ? threads : blocks;
    const double edge = plan->edge, bricks = (double)grid->brick_count / (edge * edge * edge);
    const double page = (double)plan->bands * MURK_PAGE_LINES * sizeof(float);
    const double pages = most_pages(context, grid, plan->orbits < 4 ? plan->orbits : 4, edge);
    const double laid = (double)(murk_laid_floats(plan->bands, plan->bent) * sizeof(float));
    const double slab = widest_slab(grid) / (edge * edge) * laid;
    /* Orders of the bricks on three axes, and what is known of each brick. */
    const double order = bricks * (3 * (sizeof(size_t) + 4 * sizeof(int32_t)) +
                                   (1 + MURK_MOST_BANDS) * sizeof(float) + sizeof(uint16_t));
    return workers * (planes * pages * page + slab) + order;
}
