/* SPDX-License-Identifier: Apache-2.0 */
#include "gather.h"

#include "factor_patch.h"
#include "lamp_far.h"
#include "lamp_near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Optical depth by which voxels of a rough medium differ. */
static const double ROUGH = 0.004;
/* Lines of sight that lamps are worth for each voxel, and for small media in all. */
static const double LINES_A_VOXEL = 24, LINES = 4e6;
typedef struct gather {
    murk_context *context;
    const murk_medium *medium;
    const murk_grid *to;
    murk_sight sight; /* in the frame of the medium's grid, as all positions */
    bool rough;       /* the medium differs from voxel to voxel */
    murk_lamp_near near;
    murk_lamp_tree tree;
} gather;

/* Where light arrives. */
typedef struct receiver {
    const gather *g;
    double centre[3];
    double kappa_t;
    double light; /* G/4 */
} receiver;

static bool is_near(const gather *g, const murk_lamp_node *node, const double offset[3])
{
    const double *size = g->medium->grid->voxel;
    if (!node->lamp)
        return false;
    int32_t cells[3];
    for (int a = 0; a < 3; a++)
        cells[a] = (int32_t)lround(offset[a] / size[a]);
    return murk_lamp_near_index(&g->near, cells) >= 0;
}

static void add_far(void *user, const murk_lamp_node *node, const double offset[3])
{
    receiver *at = user;
    if (is_near(at->g, node, offset))
        return;
    at->light += murk_lamp_far(&at->g->sight, node, offset, at->kappa_t, at->g->rough);
}

static void count_line(void *user, const murk_lamp_node *node, const double offset[3])
{
    (void)node;
    (void)offset;
    ++*(size_t *)user;
}

/* Cell of a voxel of one of the two grids, from the corner of the medium's. */
static void cell_of(const gather *g, const murk_grid *grid, size_t slot, int32_t out[3])
{
    const int in[3] = {slot >> 6 & 7, slot >> 3 & 7, slot & 7};
    for (int a = 0; a < 3; a++)
        out[a] = grid->brick[slot / MURK_BRICK_SLOTS][a] * MURK_BRICK_EDGE + in[a] -
                 g->medium->grid->lo[a];
}

static receiver receiver_at(const gather *g, const int32_t cell[3])
{
    const murk_grid *grid = g->medium->grid;
    receiver at = {.g = g};
    int64_t slot =
        murk_grid_slot(grid, grid->lo[0] + cell[0], grid->lo[1] + cell[1], grid->lo[2] + cell[2]);
    at.kappa_t = slot < 0 ? 0 : g->medium->kappa_t[slot];
    for (int a = 0; a < 3; a++)
        at.centre[a] = (cell[a] + 0.5) * grid->voxel[a];
    return at;
}

/* Whether one line says too little of those beside it: the mean second difference of the optical
   depth from voxel to voxel, as the spread of independent voxels. A few voxels do not decide. */
static bool is_rough(const murk_medium *medium)
{
    const murk_grid *grid = medium->grid;
    double edge = fmax(grid->voxel[0], fmax(grid->voxel[1], grid->voxel[2])), sum = 0, count = 0;
    for (size_t i = 0; i < grid->brick_count * MURK_BRICK_SLOTS; i++) {
        const float *k = medium->kappa_t + i;
        if (!(*k > 0) || i % 8 == 0 || i % 8 == 7)
            continue;
        double second = (double)k[1] - 2 * (double)k[0] + (double)k[-1];
        sum += fabs(second);
        count++;
    }
    return sum > 0 && sqrt(M_PI / 2 / 6) * sum / count * edge > ROUGH;
}

/* Whether there are too many lamps to be gathered: lines of sight to some of the bricks, and the
   voxels of a patch each as dear as three. */
static bool too_many(const gather *g, const murk_lamps *lamps)
{
    enum { SAMPLES = 256 };
    const size_t bricks = g->to->brick_count, stride = bricks / SAMPLES + 1;
    size_t lines = 0, samples = 0;
    for (size_t b = 0; b < bricks; b += stride, samples++) {
        int32_t cell[3];
        cell_of(g, g->to, b * MURK_BRICK_SLOTS + 4 * 64 + 4 * 8 + 4, cell);
        receiver at = receiver_at(g, cell);
        murk_lamp_tree_visit(&g->tree, at.centre, count_line, &lines);
    }
    double voxels = (double)g->to->zone_count;
    double each = (double)lines / (double)samples * (g->rough ? MURK_ROUGH_LINES : 1) +
                  3 * (double)(lamps->count - lamps->zones);
    return each * voxels > LINES_A_VOXEL * voxels + LINES;
}

/* ---- zones from zones ---------------------------------------------------------------------- */

/* Light from all lamps that are not near; gives what the zones take [W]. */
static double gather_far(const gather *g, float *light)
{
    double taken = 0;
#pragma omp parallel for num_threads(g->context->threads) schedule(dynamic, 1) reduction(+ : taken)
    for (size_t b = 0; b < g->to->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            int32_t cell[3];
            if (!murk_grid_active(g->to, b, slot))
                continue;
            cell_of(g, g->to, b * MURK_BRICK_SLOTS + (size_t)slot, cell);
            receiver at = receiver_at(g, cell);
            murk_lamp_tree_visit(&g->tree, at.centre, add_far, &at);
            light[b * MURK_BRICK_SLOTS + (size_t)slot] = (float)at.light;
            taken += at.kappa_t * at.light;
        }
    return 4 * g->to->volume * taken;
}

static void add_near(gather *g, const murk_lines_through *lines, const murk_lamp *lamp,
                     float *light, double *left)
{
    const murk_grid *grid = g->medium->grid;
    int32_t cell[3], d[3];
    cell_of(g, grid, lamp->index, cell);
    murk_lamp_near_trace(&g->near, lines, cell);
    *left += 4 * g->medium->kappa_t[lamp->index] * grid->volume * lamp->radiosity * g->near.left;
    const int *reach = g->near.reach;
    for (d[0] = -reach[0]; d[0] <= reach[0]; d[0]++)
        for (d[1] = -reach[1]; d[1] <= reach[1]; d[1]++)
            for (d[2] = -reach[2]; d[2] <= reach[2]; d[2]++) {
                int64_t index = murk_lamp_near_index(&g->near, d);
                int64_t to =
                    murk_grid_slot(g->to, grid->lo[0] + cell[0] + d[0],
                                   grid->lo[1] + cell[1] + d[1], grid->lo[2] + cell[2] + d[2]);
                if (index >= 0 && to >= 0 &&
                    murk_grid_active(g->to, (size_t)to / MURK_BRICK_SLOTS, (int)(to & 511)))
                    light[to] += (float)(lamp->radiosity * g->near.light[index]);
            }
}

static murk_status gather_zones(gather *g, const murk_lamps *lamps, murk_gathered *out)
{
    enum { MOST_LINES = 4096, ALL_LINES = 1 << 14 };
    murk_lines_through lines = {0};
    size_t base = lamps->zones ? ALL_LINES / lamps->zones : 0;
    murk_status status =
        murk_lines_through_create(g->context, base > MOST_LINES ? MOST_LINES : base, &lines);
    if (status)
        return status;
    const size_t slots = g->to->brick_count * MURK_BRICK_SLOTS;
    double taken = gather_far(g, out->zone), left = 0;
    float *near = murk_alloc(slots, sizeof *near);
    if (!near) {
        murk_lines_through_clear(&lines);
        return murk_fail(g->context, MURK_ERROR_MEMORY, "out of memory for lamps");
    }
    for (size_t i = 0; i < lamps->zones; i++) {
        const murk_lamp *lamp = lamps->lamp + i;
        out->sent +=
            4 * g->medium->kappa_t[lamp->index] * g->medium->grid->volume * lamp->radiosity;
        add_near(g, &lines, lamp, near, &left);
    }
    /* No more arrives far away than has left the neighbourhood. */
    float scale = taken > left ? (float)(left / taken) : 1;
    for (size_t i = 0; i < slots; i++)
        out->zone[i] = scale * out->zone[i] + near[i];
    murk_free(near);
    murk_lines_through_clear(&lines);
    return MURK_OK;
}

/* What the zones take of the light that has been gathered [W]. */
static double power_taken(const gather *g, const float *light)
{
    double sum = 0;
    for (size_t b = 0; b < g->medium->grid->brick_count; b++) {
        const int32_t *at = g->medium->grid->brick[b];
        size_t to = (size_t)murk_grid_find(g->to, at[0], at[1], at[2]) * MURK_BRICK_SLOTS;
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++)
            sum += (double)g->medium->kappa_t[b * MURK_BRICK_SLOTS + s] * light[to + s];
    }
    return 4 * g->to->volume * sum;
}

/* ---- with the ground ----------------------------------------------------------------------- */

/* Zones and margin from the patches that are lamps. */
static void gather_from_ground(const gather *g, const murk_lamps *lamps, float *light)
{
    const double volume = g->to->volume;
    /* Without extinction the factor is 0, but not its ratio to the zone's 4 kappa V. */
    const double least = 1e-9 / g->medium->grid->voxel[0];
#pragma omp parallel for num_threads(g->context->threads) schedule(dynamic, 1)
    for (size_t b = 0; b < g->to->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            int32_t cell[3];
            if (!murk_grid_active(g->to, b, slot))
                continue;
            cell_of(g, g->to, b * MURK_BRICK_SLOTS + (size_t)slot, cell);
            receiver at = receiver_at(g, cell);
            double kappa = fmax(at.kappa_t, least), sum = 0, above[3];
            murk_sight_project(&g->sight, at.centre, above);
            if (above[2] <= 0)
                continue; /* the margin may reach below the ground */
            for (size_t i = lamps->zones; i < lamps->count; i++)
                sum += lamps->lamp[i].radiosity *
                       murk_patch_factor(&g->sight, cell, kappa, lamps->lamp[i].index);
            light[b * MURK_BRICK_SLOTS + (size_t)slot] += (float)(sum / (4 * kappa * volume));
        }
}

static void gather_on_ground(const gather *g, const murk_ground *ground, const murk_lamps *lamps,
                             float *patch)
{
#pragma omp parallel for num_threads(g->context->threads) schedule(dynamic, 8)
    for (size_t i = 0; i < ground->patch_count; i++) {
        double sum = 0;
        for (size_t n = 0; n < lamps->zones; n++) {
            const murk_lamp *lamp = lamps->lamp + n;
            int32_t cell[3];
            cell_of(g, g->medium->grid, lamp->index, cell);
            sum += lamp->radiosity *
                   murk_patch_factor(&g->sight, cell, g->medium->kappa_t[lamp->index], i);
        }
        patch[i] = (float)(sum / murk_ground_area(ground, i));
    }
}

/* -------------------------------------------------------------------------------------------- */

murk_status murk_gather(murk_context *context, const murk_medium *medium, const murk_ground *ground,
                        const murk_grid *to, murk_lamps *lamps, murk_gathered *out)
{
    gather g = {.context = context, .medium = medium, .to = to, .rough = is_rough(medium)};
    const size_t slots = to->brick_count * MURK_BRICK_SLOTS;
    murk_gathered made = {0};
    murk_sight_init(&g.sight, medium, ground);
    murk_status status = murk_lamp_tree_create(context, medium, lamps->lamp, lamps->zones, &g.tree);
    if (!status && too_many(&g, lamps)) {
        murk_lamp_tree_clear(&g.tree);
        murk_lamps_clear(lamps);
        return MURK_OK;
    }
    if (!status)
        status = murk_lamp_near_create(context, medium, &g.near);
    made.zone = murk_alloc(slots, sizeof *made.zone);
    made.patch = ground ? murk_alloc(ground->patch_count, sizeof *made.patch) : NULL;
    if (!status && (!made.zone || (ground && !made.patch)))
        status =
            murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu voxels", to->zone_count);
    if (!status && lamps->zones)
        status = gather_zones(&g, lamps, &made);
    if (!status) {
        made.kept = power_taken(&g, made.zone);
        if (ground && lamps->zones)
            gather_on_ground(&g, ground, lamps, made.patch);
        if (lamps->count > lamps->zones)
            gather_from_ground(&g, lamps, made.zone);
        made.ground = power_taken(&g, made.zone) - made.kept;
    }
    murk_lamp_near_clear(&g.near);
    murk_lamp_tree_clear(&g.tree);
    if (status)
        murk_gathered_clear(&made);
    else
        *out = made;
    return status;
}

void murk_gathered_clear(murk_gathered *gathered)
{
    murk_free(gathered->zone);
    murk_free(gathered->patch);
    *gathered = (murk_gathered){0};
}
