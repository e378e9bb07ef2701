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
    int32_t *order[4];  /* bricks so that each stands behind those upstream, for signs +++ ... ++- */
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
    return u->key != v->key ? (u->key < v->key ? -1 : 1) : (u->index > v->index) - (u->index < v->index);
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
            sweep->blocks[sweep->block_count++] =
                (struct block){.first = i, .count = 1, .axis = keys[i].key >> 3, .signs = keys[i].key & 7};
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
        if (!sweep->brick_kappa || !make_blocks(sweep, lines, line_count) || !make_orders(sweep))
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
    murk_layer *layer; /* MURK_BLOCK times the most layers of a lattice */
    float *plane;      /* states of the lines of a block, and what they were at the start */
    size_t plane_capacity;
};

struct run {
    const murk_sweep *sweep;
    const float *source;
    const murk_incoming *incoming;
    double power_factor;
};

static void cross_brick(const struct run *run, const struct block *block, const murk_lattice *lattice,
                        float *const *plane, size_t b, float *tally)
{
    const murk_sweep *sweep = run->sweep;
    const murk_grid *grid = sweep->grid;
    _Alignas(64) float kappa_t[MURK_BRICK_SLOTS], source[MURK_BRICK_SLOTS], sum[MURK_BRICK_SLOTS];
    to_layers(block->axis, sweep->kappa_t + b * MURK_BRICK_SLOTS, kappa_t);
    if (run->source)
        to_layers(block->axis, run->source + b * MURK_BRICK_SLOTS, source);
    else
        memset(source, 0, sizeof source);
    memset(sum, 0, sizeof sum);
    for (int i = 0; i < block->count; i++) {
        const murk_lattice *l = &lattice[i];
        int32_t cell[3];
        for (int a = 0; a < 3; a++)
            cell[a] = grid->brick[b][a] * MURK_BRICK_EDGE - grid->lo[a];
        ptrdiff_t stride = l->ray_hi[0] - l->ray_lo[0];
        double length = l->area > 0 ? grid->volume / l->area : 0;
        sweep->kernel(&(murk_kernel_job){
            .kappa_t = kappa_t,
            .source = source,
            .tally = sum,
            .plane = plane[i] + (cell[l->v] - l->ray_lo[1]) * stride + (cell[l->u] - l->ray_lo[0]),
            .stride = stride,
            .layer = l->layer + (cell[l->axis] - l->first_layer),
            .sign = l->sign,
            .weight = (float)l->weight,
            .thin = sweep->brick_kappa[b] * length < MURK_THIN,
        });
    }
    if (tally)
        add_layers(block->axis, sum, tally + b * MURK_BRICK_SLOTS);
}

static bool reserve(struct worker *worker, size_t floats)
{
    if (floats <= worker->plane_capacity)
        return true;
    murk_free(worker->plane);
    worker->plane = murk_alloc(floats, sizeof(float));
    worker->plane_capacity = worker->plane ? floats : 0;
    return worker->plane;
}

static bool run_block(const struct run *run, const struct block *block, struct worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    const murk_grid *grid = sweep->grid;
    murk_lattice lattice[MURK_BLOCK];
    murk_boundary boundary[MURK_BLOCK];
    float *plane[MURK_BLOCK];
    size_t size[MURK_BLOCK], total = 0;
    size_t most_layers = (size_t)murk_lattice_layers(grid);
    for (int i = 0; i < block->count; i++) {
        murk_lattice *l = &lattice[i];
        murk_lattice_lay(l, grid, &sweep->line[block->first + i],
                         worker->layer + (size_t)i * most_layers);
        murk_boundary_lay(&boundary[i], grid, sweep->ground, l);
        size[i] = (size_t)(l->ray_hi[0] - l->ray_lo[0]) * (size_t)(l->ray_hi[1] - l->ray_lo[1]);
        total += size[i];
    }
    if (!reserve(worker, 2 * total))
        return false;
    float *before = worker->plane + total;
    for (int i = 0; i < block->count; i++) {
        plane[i] = i ? plane[i - 1] + size[i - 1] : worker->plane;
        murk_boundary_enter(&boundary[i], &lattice[i], run->incoming, plane[i],
                            lattice[i].ray_hi[0] - lattice[i].ray_lo[0]);
    }
    memcpy(before, worker->plane, total * sizeof *before);
    int signs = block->signs & 1 ? block->signs : ~block->signs & 7;
    const int32_t *order = sweep->order[(~signs >> 1) & 3];
    for (size_t n = 0; n < grid->brick_count; n++) {
        size_t at = block->signs & 1 ? n : grid->brick_count - 1 - n;
        cross_brick(run, block, lattice, plane, (size_t)order[at], worker->tally);
    }
    for (int i = 0; i < block->count; i++)
        worker->net_power += murk_boundary_leave(
            &boundary[i], &lattice[i], before + (plane[i] - worker->plane), plane[i],
            lattice[i].ray_hi[0] - lattice[i].ray_lo[0],
            run->power_factor * lattice[i].weight * lattice[i].area, worker->patch_power);
    return true;
}

/* ---- all blocks ---------------------------------------------------------------------------- */

static bool hire(const murk_sweep *sweep, struct worker *worker, bool tally, bool patches)
{
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS;
    worker->layer = murk_alloc((size_t)murk_lattice_layers(sweep->grid) * MURK_BLOCK,
                               sizeof *worker->layer);
    if (tally)
        worker->tally = murk_alloc(slots, sizeof(float));
    if (patches && sweep->ground)
        worker->patch_power = murk_alloc(sweep->ground->patch_count, sizeof(double));
    return worker->layer && (!tally || worker->tally) &&
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
        murk_free(workers[t].layer);
        murk_free(workers[t].plane);
    }
    murk_free(workers);
    return ok ? MURK_OK
              : murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the lines of %d directions",
                          sweep->line_count);
}
