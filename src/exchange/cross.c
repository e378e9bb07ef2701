/* SPDX-License-Identifier: Apache-2.0 */
/* One block of lines through the medium, slab by slab. */
#include "sweep_state.h"

#include <string.h>

/* The lattices of a block, laid for a slab. */
struct lattices {
    murk_lattice lattice[MURK_BLOCK];
    murk_boundary boundary[MURK_BLOCK];
    murk_layers layers[MURK_BLOCK];
};

/* Slopes in the order of the kernel: along u, v and the dominant axis. */
static void order_of(const murk_slabs *slabs, int order[3])
{
    order[0] = slabs->u;
    order[1] = slabs->v;
    order[2] = slabs->axis;
}

static void load_slopes(const struct murk_run *run, const murk_slabs *slabs, int32_t place,
                        float *slope)
{
    int order[3];
    order_of(slabs, order);
    memset(slope, 0, 2 * (size_t)run->bands * MURK_BENT_SLOTS * sizeof *slope);
    for (int b = 0; b < run->bands; b++)
        for (int a = 0; a < 3 && run->cargo[b].slope; a++)
            murk_slabs_layers(slabs->axis,
                              run->cargo[b].slope + (size_t)place * MURK_BENT_SLOTS +
                                  order[a] * MURK_BRICK_SLOTS,
                              slope + (3 * b + a) * MURK_BRICK_SLOTS);
}

static void store_slopes(const struct murk_run *run, const murk_slabs *slabs, int32_t place,
                         const float *tally, struct murk_worker *worker)
{
    int order[3];
    order_of(slabs, order);
    for (int b = 0; b < run->bands; b++)
        for (int a = 0; a < 3; a++)
            murk_slabs_add(slabs->axis, tally + (3 * b + a) * MURK_BRICK_SLOTS,
                           worker->slope_tally[b] + (size_t)place * MURK_BENT_SLOTS +
                               order[a] * MURK_BRICK_SLOTS);
}

/* Lays out the bricks of a slab in layers. */
static void load_slab(const struct murk_run *run, const murk_slabs *slabs, int s,
                      struct murk_worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    float *layers = worker->slab;
    for (size_t i = slabs->first[s]; i < slabs->first[s + 1]; i++) {
        size_t from = (size_t)slabs->brick[i] * MURK_BRICK_SLOTS;
        float *source = layers + MURK_BRICK_SLOTS;
        murk_slabs_layers(slabs->axis, sweep->kappa_t + from, layers);
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            layers[slot] = layers[slot] > sweep->clear ? layers[slot] : sweep->clear;
        for (int b = 0; b < run->bands; b++, source += MURK_BRICK_SLOTS) {
            if (run->cargo[b].source)
                murk_slabs_layers(slabs->axis, run->cargo[b].source + from, source);
            else
                memset(source, 0, MURK_BRICK_SLOTS * sizeof *source);
        }
        memset(source, 0, (size_t)run->bands * MURK_BRICK_SLOTS * sizeof *source);
        if (run->bent && sweep->bent->place[slabs->brick[i]] != MURK_NOT_BENT)
            load_slopes(run, slabs, sweep->bent->place[slabs->brick[i]],
                        layers + murk_laid_flat(run->bands));
        layers += murk_laid_floats(run->bands, run->bent);
    }
}

static void store_slab(const struct murk_run *run, const murk_slabs *slabs, int s,
                       struct murk_worker *worker)
{
    const float *layers = worker->slab;
    const size_t tally = (size_t)(1 + run->bands) * MURK_BRICK_SLOTS;
    const size_t slopes = murk_laid_flat(run->bands) + (size_t)run->bands * MURK_BENT_SLOTS;
    for (size_t i = slabs->first[s]; i < slabs->first[s + 1]; i++) {
        for (int b = 0; b < run->bands; b++)
            murk_slabs_add(slabs->axis, layers + tally + b * MURK_BRICK_SLOTS,
                           worker->tally[b] + (size_t)slabs->brick[i] * MURK_BRICK_SLOTS);
        if (run->bent && run->sweep->bent->place[slabs->brick[i]] != MURK_NOT_BENT)
            store_slopes(run, slabs, run->sweep->bent->place[slabs->brick[i]], layers + slopes,
                         worker);
        layers += murk_laid_floats(run->bands, run->bent);
    }
}

/* Whether a brick and the lines that come to it carry no light to speak of in any band. */
static bool is_dark(const struct murk_run *run, size_t brick, const murk_window *window)
{
    const float *source = run->sweep->brick_source + brick * MURK_MOST_BANDS;
    for (int b = 0; b < run->bands; b++)
        if (source[b] > run->dark[b])
            return false;
    return murk_window_dark(window, run->bands, run->dark);
}

/* Line i of the block through the brick at a position in its slab. */
static bool cross_brick(const struct murk_run *run, const struct lattices *lines, int i,
                        const murk_slabs *slabs, int s, size_t at, struct murk_worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    const murk_lattice *lattice = &lines->lattice[i];
    const murk_layers *layers = &lines->layers[i];
    size_t b = (size_t)slabs->brick[slabs->first[s] + at];
    int32_t u = sweep->grid->brick[b][slabs->u] * MURK_BRICK_EDGE - sweep->grid->lo[slabs->u];
    int32_t v = sweep->grid->brick[b][slabs->v] * MURK_BRICK_EDGE - sweep->grid->lo[slabs->v];
    murk_window window;
    if (!murk_plane_open(&worker->plane[i], u + layers->first[0], u + layers->last[0],
                         v + layers->first[1], v + layers->last[1], &window))
        return false;
    if (is_dark(run, b, &window)) {
        worker->dark += sweep->brick_zones[b];
        murk_plane_close(&worker->plane[i], &window);
        return true;
    }
    float *bricks = worker->slab + at * murk_laid_floats(run->bands, run->bent);
    float *slope = run->bent && sweep->bent->place[b] != MURK_NOT_BENT
                       ? bricks + murk_laid_flat(run->bands)
                       : NULL;
    sweep->kernel(&(murk_kernel_job){
        .kappa_t = bricks,
        .source = bricks + MURK_BRICK_SLOTS,
        .tally = bricks + (size_t)(1 + run->bands) * MURK_BRICK_SLOTS,
        .slope = slope,
        .slope_tally = slope ? slope + (size_t)run->bands * MURK_BENT_SLOTS : NULL,
        .chunks = slabs->chunks[slabs->first[s] + at],
        .bands = run->bands,
        .depth = murk_depth_of(sweep->brick_kappa[b] * lattice->length),
        .plane = window.state - layers->first[1] * window.stride - layers->first[0],
        .stride = window.stride,
        .band = window.band,
        .layer = layers->layer,
        .sign = lattice->sign,
        .weight = (float)(lattice->weight / lattice->length),
    });
    murk_plane_close(&worker->plane[i], &window);
    return true;
}

/* The lines of a block that go the same ways along u and v, first ... last, through a slab. */
static bool cross_slab(const struct murk_run *run, const struct lattices *lines, int first,
                       int last, const murk_slabs *slabs, int s, struct murk_worker *worker)
{
    const double *slope = lines->lattice[first].direction;
    const bool up[3] = {slope[0] > 0, slope[1] > 0, slope[2] > 0};
    bool up_u = up[slabs->u], up_v = up[slabs->v];
    bool ends = run->sweep->region.limited &&
                !(lines->boundary[first].heading < 0 && worker->patch_power[0]);
    size_t start = slabs->first[s], count = slabs->first[s + 1] - start;
    for (size_t n = 0; n < count; n++) {
        size_t at = up_u ? n : count - 1 - n;
        if (up_u != up_v)
            at = (size_t)slabs->mixed[start + at] - start;
        size_t b = (size_t)slabs->brick[start + at];
        if (ends && !murk_region_ahead(&run->sweep->region, run->sweep->grid->brick[b], up)) {
            worker->beyond += (last - first + 1) * (double)run->sweep->brick_zones[b];
            continue;
        }
        for (int i = first; i <= last; i++)
            if (!cross_brick(run, lines, i, slabs, s, at, worker))
                return false;
    }
    return true;
}

static bool lay_lines(const struct murk_run *run, const struct murk_block *block,
                      struct lattices *lines, struct murk_worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    for (int i = 0; i < block->count; i++) {
        murk_lattice_lay(&lines->lattice[i], sweep->grid, &sweep->line[block->first + i]);
        murk_boundary_lay(&lines->boundary[i], sweep->grid, sweep->ground, &lines->lattice[i],
                          run->incoming[0].uniform);
        if (!murk_plane_reset(&worker->plane[i], &lines->boundary[i], run->incoming, run->bands))
            return false;
    }
    return true;
}

bool murk_cross_block(const struct murk_run *run, const struct murk_block *block,
                      struct murk_worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    const murk_slabs *slabs = &sweep->slabs[block->axis];
    struct lattices lines;
    if (!lay_lines(run, block, &lines, worker))
        return false;
    for (int n = 0; n < slabs->count; n++) {
        int s = block->sign > 0 ? n : slabs->count - 1 - n;
        load_slab(run, slabs, s, worker);
        for (int i = 0; i < block->count; i++)
            murk_lattice_layers(&lines.lattice[i], sweep->grid, slabs->row[s], &lines.layers[i]);
        for (int first = 0, last; first < block->count; first = last + 1) {
            int signs = murk_lattice_signs(lines.lattice[first].direction);
            for (last = first; last + 1 < block->count; last++)
                if (murk_lattice_signs(lines.lattice[last + 1].direction) != signs)
                    break;
            if (!cross_slab(run, &lines, first, last, slabs, s, worker))
                return false;
        }
        if (worker->tally[0])
            store_slab(run, slabs, s, worker);
    }
    for (int i = 0; i < block->count; i++)
        murk_plane_leave(&worker->plane[i],
                         run->power_factor * lines.lattice[i].weight * lines.lattice[i].area,
                         worker->patch_power[0] ? worker->patch_power : NULL, worker->net_power);
    return true;
}
