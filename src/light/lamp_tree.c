/* SPDX-License-Identifier: Apache-2.0 */
#include "lamp_tree.h"

#include <math.h>
#include <stdlib.h>

/* Distance from which a cell is seen as one, in its longest edges. */
static const double OPEN = 3;
/* Light from within a larger cell than this many optical depths is attenuated too differently. */
static const double THIN = 0.6;
enum { MOST_LEVELS = 6 };

/* The bits of three coordinates in turn. */
static uint64_t place_of(const int32_t cell[3])
{
    uint64_t place = 0;
    for (int bit = 20; bit >= 0; bit--)
        for (int a = 0; a < 3; a++)
            place = place << 1 | (uint64_t)(cell[a] >> bit & 1);
    return place;
}

static void set_zone(const murk_medium *medium, const murk_lamp *lamp, murk_lamp_node *out)
{
    const murk_grid *grid = medium->grid;
    const int32_t *brick = grid->brick[lamp->index / MURK_BRICK_SLOTS];
    const int slot = (int)(lamp->index % MURK_BRICK_SLOTS);
    const int in[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
    int32_t cell[3];
    *out = (murk_lamp_node){.lamp = lamp, .kappa_t = medium->kappa_t[lamp->index]};
    for (int a = 0; a < 3; a++) {
        cell[a] = brick[a] * MURK_BRICK_EDGE + in[a] - grid->lo[a];
        out->low[a] = cell[a] * grid->voxel[a];
        out->high[a] = (cell[a] + 1) * grid->voxel[a];
        out->centre[a] = (cell[a] + 0.5) * grid->voxel[a];
        out->spread[a] = grid->voxel[a] * grid->voxel[a] / 12;
    }
    out->power = out->kappa_t * grid->volume * lamp->radiosity;
    out->place = place_of(cell);
}

static int compare_place(const void *a, const void *b)
{
    const murk_lamp_node *x = a, *y = b;
    return x->place < y->place ? -1 : x->place > y->place;
}

/* The cell of the nodes first ... end - 1. A single one stands for itself. */
static murk_lamp_node make_cell(const murk_lamp_node *node, size_t first, size_t end)
{
    murk_lamp_node cell = node[first];
    cell.place = node[first].place >> 3;
    if (end - first == 1)
        return cell;
    cell.first = first;
    cell.end = end;
    cell.lamp = NULL;
    cell.power = 0;
    for (size_t i = first; i < end; i++) {
        cell.power += node[i].power;
        cell.kappa_t = fmax(cell.kappa_t, node[i].kappa_t);
    }
    double edge = 0;
    for (int a = 0; a < 3; a++) {
        double mean = 0, square = 0;
        for (size_t i = first; i < end; i++) {
            double share = node[i].power / cell.power;
            mean += share * node[i].centre[a];
            square += share * (node[i].spread[a] + node[i].centre[a] * node[i].centre[a]);
            cell.low[a] = fmin(cell.low[a], node[i].low[a]);
            cell.high[a] = fmax(cell.high[a], node[i].high[a]);
        }
        cell.centre[a] = mean;
        cell.spread[a] = square - mean * mean;
        edge = fmax(edge, cell.high[a] - cell.low[a]);
    }
    cell.far = cell.kappa_t * edge > THIN ? INFINITY : OPEN * edge;
    return cell;
}

murk_status murk_lamp_tree_create(murk_context *context, const murk_medium *medium,
                                  const murk_lamp *lamps, size_t count, murk_lamp_tree *out)
{
    murk_lamp_tree tree = {.node = murk_alloc((MOST_LEVELS + 1) * count, sizeof *tree.node)};
    if (!tree.node)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu lamps", count);
    for (size_t i = 0; i < count; i++)
        set_zone(medium, lamps + i, tree.node + i);
    qsort(tree.node, count, sizeof *tree.node, compare_place);
    tree.count = tree.roots = count;
    for (int level = 0; level < MOST_LEVELS && tree.roots > 1; level++) {
        size_t first = tree.count - tree.roots, last = tree.count;
        for (size_t end = first; first < last; first = end) {
            while (end < last && tree.node[end].place >> 3 == tree.node[first].place >> 3)
                end++;
            tree.node[tree.count++] = make_cell(tree.node, first, end);
        }
        tree.roots = tree.count - last;
    }
    *out = tree;
    return MURK_OK;
}

void murk_lamp_tree_clear(murk_lamp_tree *tree)
{
    murk_free(tree->node);
    *tree = (murk_lamp_tree){0};
}

static void visit_node(const murk_lamp_tree *tree, const murk_lamp_node *node,
                       const double point[3], murk_lamp_visit *visit, void *user)
{
    double offset[3], r2 = 0;
    for (int a = 0; a < 3; a++) {
        offset[a] = point[a] - node->centre[a];
        r2 += offset[a] * offset[a];
    }
    if (node->first == node->end || r2 >= node->far * node->far) {
        visit(user, node, offset);
        return;
    }
    for (size_t i = node->first; i < node->end; i++)
        visit_node(tree, tree->node + i, point, visit, user);
}

void murk_lamp_tree_visit(const murk_lamp_tree *tree, const double point[3], murk_lamp_visit *visit,
                          void *user)
{
    for (size_t i = tree->count - tree->roots; i < tree->count; i++)
        visit_node(tree, tree->node + i, point, visit, user);
}
