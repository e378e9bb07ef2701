/* SPDX-License-Identifier: Apache-2.0 */
#include "sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct block {
    int first, count; /* lines */
    int axis, signs;
};

struct murk_sweep {
    const murk_grid *grid;
    const float *kappa_t;
    const murk_ground *ground;
    murk_line *line;
    int line_count;
    struct block *blocks;
    int block_count;
    int32_t *row_of[3]; /* for each brick, which of the rows along an axis it lies in */
    int32_t *row[3];    /* brick coordinate of each row that holds bricks */
    int row_count[3];
    int32_t *order[4]; /* bricks so that each stands behind those upstream, for signs +++ ... ++- */
    float *brick_kappa; /* largest kappa_t of each brick */
    murk_kernel_fn *kernel;
    const char *kernel_name;
};

/* ---- preparation --------------------------------------------------------------------------- */

struct sort_key {
    int key, index;
};

static int compare_keys(const void *a, const void *b)
{
    const struct sort_key *u = a, *v = b;
    return u->key != v->key ? (u->key < v->key ? -1 : 1)
                            : (u->index > v->index) - (u->index < v->index);
}

static bool make_blocks(murk_sweep *sweep, const murk_line *lines, int count)
{
    struct sort_key *keys = murk_alloc((size_t)count, sizeof *keys);
    sweep->line = murk_alloc((size_t)count, sizeof *sweep->line);
    sweep->blocks = murk_alloc((size_t)count, sizeof *sweep->blocks);
    if (!keys || !sweep->line || !sweep->blocks) {
        murk_free(keys);
        return false;
    }
    for (int i = 0; i < count; i++)
        keys[i] = (struct sort_key){murk_lattice_axis(sweep->grid, lines[i].direction) * 8 +
                                        murk_lattice_signs(lines[i].direction),
                                    i};
    qsort(keys, (size_t)count, sizeof *keys, compare_keys);
    for (int i = 0; i < count; i++) {
        sweep->line[i] = lines[keys[i].index];
        struct block *last = sweep->block_count ? &sweep->blocks[sweep->block_count - 1] : NULL;
        if (last && last->count < MURK_BLOCK && last->axis * 8 + last->signs == keys[i].key)
            last->count++;
        else
            sweep->blocks[sweep->block_count++] = (struct block){
                .first = i, .count = 1, .axis = keys[i].key >> 3, .signs = keys[i].key & 7};
    }
    sweep->line_count = count;
    murk_free(keys);
    return true;
}

struct brick_key {
    int32_t c[3];
    int32_t index;
};

static int compare_bricks(const void *a, const void *b)
{
    const struct brick_key *u = a, *v = b;
    for (int i = 0; i < 3; i++)
        if (u->c[i] != v->c[i])
            return u->c[i] < v->c[i] ? -1 : 1;
    return 0;
}

/* Bricks ascending in (x, +-y, +-z); the four orders with x descending are these backwards. */
static bool make_orders(murk_sweep *sweep)
{
    const murk_grid *grid = sweep->grid;
    struct brick_key *keys = murk_alloc(grid->brick_count, sizeof *keys);
    bool ok = keys;
    for (int o = 0; ok && o < 4; o++) {
        sweep->order[o] = murk_alloc(grid->brick_count, sizeof *sweep->order[o]);
        ok = sweep->order[o];
        for (size_t b = 0; ok && b < grid->brick_count; b++)
            keys[b] = (struct brick_key){{grid->brick[b][0], (o & 1 ? -1 : 1) * grid->brick[b][1],
                                          (o & 2 ? -1 : 1) * grid->brick[b][2]},
                                         (int32_t)b};
        if (ok && o)
            qsort(keys, grid->brick_count, sizeof *keys, compare_bricks);
        for (size_t b = 0; ok && b < grid->brick_count; b++)
            sweep->order[o][b] = keys[b].index;
    }
    murk_free(keys);
    return ok;
}

/* Numbers the brick coordinates that occur on one axis. */
static bool make_rows(murk_sweep *sweep, int axis)
{
    const murk_grid *grid = sweep->grid;
    struct brick_key *keys = murk_alloc(grid->brick_count, sizeof *keys);
    sweep->row_of[axis] = murk_alloc(grid->brick_count, sizeof(int32_t));
    sweep->row[axis] = murk_alloc(grid->brick_count, sizeof(int32_t));
    bool ok = keys && sweep->row_of[axis] && sweep->row[axis];
    for (size_t b = 0; ok && b < grid->brick_count; b++)
        keys[b] = (struct brick_key){{grid->brick[b][axis]}, (int32_t)b};
    if (ok)
        qsort(keys, grid->brick_count, sizeof *keys, compare_bricks);
    int count = 0;
    for (size_t i = 0; ok && i < grid->brick_count; i++) {
        if (!i || keys[i].c[0] != keys[i - 1].c[0])
            sweep->row[axis][count++] = keys[i].c[0];
        sweep->row_of[axis][keys[i].index] = count - 1;
    }
    sweep->row_count[axis] = count;
    murk_free(keys);
    return ok;
}

murk_status murk_sweep_create(murk_context *context, const murk_grid *grid, const float *kappa_t,
                              const murk_ground *ground, const murk_line *lines, int line_count,
                              murk_sweep **out)
{
    murk_sweep *sweep = murk_alloc(1, sizeof *sweep);
    if (!sweep)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    sweep->grid = grid;
    sweep->kappa_t = kappa_t;
    sweep->ground = ground;
    murk_status status = murk_kernel_choose(context, &sweep->kernel, &sweep->kernel_name);
    if (!status) {
        sweep->brick_kappa = murk_alloc(grid->brick_count, sizeof(float));
        if (!sweep->brick_kappa || !make_blocks(sweep, lines, line_count) || !make_orders(sweep) ||
            !make_rows(sweep, 0) || !make_rows(sweep, 1) || !make_rows(sweep, 2))
            status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d directions",
                               line_count);
    }
    if (status) {
        murk_sweep_release(sweep);
        return status;
    }
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            sweep->brick_kappa[b] =
                fmaxf(sweep->brick_kappa[b], kappa_t[b * MURK_BRICK_SLOTS + (size_t)slot]);
    *out = sweep;
    return MURK_OK;
}

void murk_sweep_release(murk_sweep *sweep)
{
    if (!sweep)
        return;
    murk_free(sweep->line);
    murk_free(sweep->blocks);
    for (int o = 0; o < 4; o++)
        murk_free(sweep->order[o]);
    for (int a = 0; a < 3; a++) {
        murk_free(sweep->row_of[a]);
        murk_free(sweep->row[a]);
    }
    murk_free(sweep->brick_kappa);
    murk_free(sweep);
}

const char *murk_sweep_kernel(const murk_sweep *sweep)
{
    return sweep->kernel_name;
}

/* ---- one block of lines -------------------------------------------------------------------- */

/* Copies a brick between slot order (x, y, z) and layers across `axis`, rows v, columns u. */
static void to_layers(int axis, const float *slots, float *layers)
{
    if (axis == 0)
        memcpy(layers, slots, MURK_BRICK_SLOTS * sizeof *layers);
    else if (axis == 1)
        for (int x = 0; x < 8; x++)
            for (int y = 0; y < 8; y++)
                memcpy(layers + y * 64 + x * 8, slots + x * 64 + y * 8, 8 * sizeof *layers);
    else
        for (int xy = 0; xy < 64; xy++)
            for (int z = 0; z < 8; z++)
                layers[z * 64 + xy] = slots[xy * 8 + z];
}

static void add_layers(int axis, const float *layers, float *slots)
{
    if (axis == 0)
        for (int i = 0; i < MURK_BRICK_SLOTS; i++)
            slots[i] += layers[i];
    else if (axis == 1)
        for (int x = 0; x < 8; x++)
            for (int y = 0; y < 8; y++)
                for (int z = 0; z < 8; z++)
                    slots[x * 64 + y * 8 + z] += layers[y * 64 + x * 8 + z];
    else
        for (int xy = 0; xy < 64; xy++)
            for (int z = 0; z < 8; z++)
                slots[xy * 8 + z] += layers[z * 64 + xy];
}

/* Everything one thread writes to. */
struct worker {
    float *tally;
    double *patch_power;
    double net_power;
    murk_layers *layers; /* of the rows of each lattice in a block */
    murk_plane plane[MURK_BLOCK];
};

struct run {
    const murk_sweep *sweep;
    const float *source;
    const murk_incoming *incoming;
    double power_factor;
};

static bool cross_brick(const struct run *run, const struct block *block,
                        const murk_lattice *lattice, struct worker *worker, size_t b)
{
    const murk_sweep *sweep = run->sweep;
    const murk_grid *grid = sweep->grid;
    int axis = block->axis, row = sweep->row_of[axis][b];
    _Alignas(64) float kappa_t[MURK_BRICK_SLOTS], source[MURK_BRICK_SLOTS], sum[MURK_BRICK_SLOTS];
    to_layers(axis, sweep->kappa_t + b * MURK_BRICK_SLOTS, kappa_t);
    if (run->source)
        to_layers(axis, run->source + b * MURK_BRICK_SLOTS, source);
    else
        memset(source, 0, sizeof source);
    memset(sum, 0, sizeof sum);
    int32_t u = grid->brick[b][lattice->u] * MURK_BRICK_EDGE - grid->lo[lattice->u];
    int32_t v = grid->brick[b][lattice->v] * MURK_BRICK_EDGE - grid->lo[lattice->v];
    for (int i = 0; i < block->count; i++) {
        const murk_lattice *l = &lattice[i];
        const murk_layers *layers = &worker->layers[i * sweep->row_count[axis] + row];
        murk_window window;
        if (!murk_plane_open(&worker->plane[i], u + layers->first[0], u + layers->last[0],
                             v + layers->first[1], v + layers->last[1], &window))
            return false;
        sweep->kernel(&(murk_kernel_job){
            .kappa_t = kappa_t,
            .source = source,
            .tally = sum,
            .plane = window.state - layers->first[1] * window.stride - layers->first[0],
            .stride = window.stride,
            .layer = layers->layer,
            .sign = l->sign,
            .weight = (float)l->weight,
            .thin = sweep->brick_kappa[b] * l->length < MURK_THIN,
        });
        murk_plane_close(&worker->plane[i], &window);
    }
    if (worker->tally)
        add_layers(axis, sum, worker->tally + b * MURK_BRICK_SLOTS);
    return true;
}

static bool run_block(const struct run *run, const struct block *block, struct worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    const murk_grid *grid = sweep->grid;
    murk_lattice lattice[MURK_BLOCK];
    murk_boundary boundary[MURK_BLOCK];
    int rows = sweep->row_count[block->axis];
    for (int i = 0; i < block->count; i++) {
        murk_lattice_lay(&lattice[i], grid, &sweep->line[block->first + i]);
        murk_boundary_lay(&boundary[i], grid, sweep->ground, &lattice[i], run->incoming->uniform);
        if (!murk_plane_reset(&worker->plane[i], &boundary[i], run->incoming))
            return false;
        for (int r = 0; r < rows; r++)
            murk_lattice_layers(&lattice[i], grid, sweep->row[block->axis][r],
                                &worker->layers[i * rows + r]);
    }
    /* Bricks upstream come first: the order of the signs, or its reverse. */
    bool ascending = block->signs & 1;
    int signs = ascending ? block->signs : ~block->signs & 7;
    const int32_t *order = sweep->order[(~signs >> 1) & 3];
    for (size_t n = 0; n < grid->brick_count; n++) {
        size_t at = ascending ? n : grid->brick_count - 1 - n;
        if (!cross_brick(run, block, lattice, worker, (size_t)order[at]))
            return false;
    }
    for (int i = 0; i < block->count; i++)
        worker->net_power += murk_plane_leave(
            &worker->plane[i], run->power_factor * lattice[i].weight * lattice[i].area,
            worker->patch_power);
    return true;
}

/* ---- all blocks ---------------------------------------------------------------------------- */

static bool hire(const murk_sweep *sweep, struct worker *worker, bool tally, bool patches)
{
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS;
    int rows = 0;
    for (int a = 0; a < 3; a++)
        rows = sweep->row_count[a] > rows ? sweep->row_count[a] : rows;
    worker->layers = murk_alloc((size_t)rows * MURK_BLOCK, sizeof *worker->layers);
    if (tally)
        worker->tally = murk_alloc(slots, sizeof(float));
    if (patches && sweep->ground)
        worker->patch_power = murk_alloc(sweep->ground->patch_count, sizeof(double));
    return worker->layers && (!tally || worker->tally) &&
           (!patches || !sweep->ground || worker->patch_power);
}

static void sum_up(const murk_sweep *sweep, const struct worker *workers, int count, float *tally,
                   double *patch_power)
{
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS;
    for (size_t i = 0; tally && i < slots; i++) {
        float sum = 0;
        for (int t = 0; t < count; t++)
            sum += workers[t].tally[i];
        tally[i] = sum;
    }
    for (size_t i = 0; patch_power && sweep->ground && i < sweep->ground->patch_count; i++) {
        patch_power[i] = 0;
        for (int t = 0; t < count; t++)
            patch_power[i] += workers[t].patch_power[i];
    }
}

murk_status murk_sweep_run(murk_context *context, murk_sweep *sweep, const float *source,
                           const murk_incoming *incoming, double power_factor, float *tally,
                           double *patch_power, double *net_power)
{
    int count = context->threads < sweep->block_count ? context->threads : sweep->block_count;
    count = count < 1 ? 1 : count;
    struct worker *workers = murk_alloc((size_t)count, sizeof *workers);
    bool ok = workers;
    for (int t = 0; ok && t < count; t++)
        ok = hire(sweep, &workers[t], tally, patch_power);
    const struct run job = {sweep, source, incoming, power_factor};
    if (ok && sweep->grid->brick_count) {
#pragma omp parallel for num_threads(count) schedule(static, 1) reduction(&& : ok)
        for (int t = 0; t < count; t++)
            for (int i = t; i < sweep->block_count; i += count)
                ok = ok && run_block(&job, &sweep->blocks[i], &workers[t]);
    }
    if (ok) {
        sum_up(sweep, workers, count, tally, patch_power);
        double net = 0;
        for (int t = 0; t < count; t++)
            net += workers[t].net_power;
        if (net_power)
            *net_power = net;
    }
    for (int t = 0; workers && t < count; t++) {
        murk_free(workers[t].tally);
        murk_free(workers[t].patch_power);
        murk_free(workers[t].layers);
        for (int i = 0; i < MURK_BLOCK; i++)
            murk_plane_clear(&workers[t].plane[i]);
    }
    murk_free(workers);
    return ok ? MURK_OK
              : murk_fail(context, MURK_ERROR_MEMORY,
                          "out of memory for the lines of %d directions", sweep->line_count);
}
