/* SPDX-License-Identifier: Apache-2.0 */
#include "sweep.h"

#include "slabs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Below this fraction of the brightest source light is as good as none. */
static const double DARK = 1e-12;
/* Voxels without extinction get this optical depth instead, which no line feels: so their mean of I
   comes from the same division by kappa_t as everywhere. */
static const double CLEAR = 1e-12;

struct block {
    int first, count; /* lines, ordered by their octants */
    int axis, sign;
};

/* Everything one thread writes to. */
struct worker {
    float *tally[MURK_MOST_BANDS]; /* of the first thread: the cargo's own */
    double *patch_power[MURK_MOST_BANDS];
    double net_power[MURK_MOST_BANDS];
    double dark, beyond; /* crossings passed over */
    float *slab;         /* the bricks of a slab, each kappa_t, sources and tallies, in layers */
    murk_plane plane[MURK_BLOCK];
};

struct murk_sweep {
    const murk_grid *grid;
    const float *kappa_t;
    float clear; /* kappa_t of voxels without extinction */
    const murk_ground *ground;
    murk_region region;
    murk_line *line;
    int line_count;
    struct block *blocks;
    int block_count;
    murk_slabs slabs[3];
    float *brick_kappa;    /* largest kappa_t of each brick */
    float *brick_source;   /* largest source of each brick in any band of a run */
    uint16_t *brick_zones; /* voxels with extinction */
    double zones;
    murk_kernel_fn *kernel;
    const char *kernel_name;
    struct worker *worker;
    int worker_count;
    murk_traced traced;
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

/* Dominant axis, way along it, then the octant. */
static int line_key(const murk_grid *grid, const murk_line *line)
{
    int axis = murk_lattice_axis(grid, line->direction);
    int signs = murk_lattice_signs(line->direction);
    return axis << 4 | (signs >> axis & 1) << 3 | signs;
}

static bool make_blocks(murk_sweep *sweep, const murk_line *lines, int count, int threads)
{
    int most = (count + 2 * threads - 1) / (2 * threads);
    most = most < 1 ? 1 : most > MURK_BLOCK ? MURK_BLOCK : most;
    struct sort_key *keys = murk_alloc((size_t)count, sizeof *keys);
    sweep->line = murk_alloc((size_t)count, sizeof *sweep->line);
    sweep->blocks = murk_alloc((size_t)count, sizeof *sweep->blocks);
    if (!keys || !sweep->line || !sweep->blocks) {
        murk_free(keys);
        return false;
    }
    for (int i = 0; i < count; i++)
        keys[i] = (struct sort_key){line_key(sweep->grid, &lines[i]), i};
    qsort(keys, (size_t)count, sizeof *keys, compare_keys);
    for (int i = 0; i < count; i++) {
        sweep->line[i] = lines[keys[i].index];
        struct block *last = sweep->block_count ? &sweep->blocks[sweep->block_count - 1] : NULL;
        int axis = keys[i].key >> 4, sign = keys[i].key & 8 ? 1 : -1;
        if (last && last->count < most && last->axis == axis && last->sign == sign)
            last->count++;
        else
            sweep->blocks[sweep->block_count++] =
                (struct block){.first = i, .count = 1, .axis = axis, .sign = sign};
    }
    sweep->line_count = count;
    murk_free(keys);
    return true;
}

static void measure_bricks(murk_sweep *sweep)
{
    for (size_t b = 0; b < sweep->grid->brick_count; b++) {
        const float *kappa_t = sweep->kappa_t + b * MURK_BRICK_SLOTS;
        float most = 0;
        int zones = 0;
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            most = kappa_t[slot] > most ? kappa_t[slot] : most;
            zones += kappa_t[slot] > 0;
        }
        sweep->brick_kappa[b] = most;
        sweep->brick_zones[b] = (uint16_t)zones;
        sweep->zones += zones;
    }
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
    sweep->clear = (float)(CLEAR / fmax(grid->voxel[0], fmax(grid->voxel[1], grid->voxel[2])));
    sweep->ground = ground;
    murk_status status = murk_kernel_choose(context, &sweep->kernel, &sweep->kernel_name);
    if (!status) {
        sweep->brick_kappa = murk_alloc(grid->brick_count, sizeof *sweep->brick_kappa);
        sweep->brick_source = murk_alloc(grid->brick_count, sizeof *sweep->brick_source);
        sweep->brick_zones = murk_alloc(grid->brick_count, sizeof *sweep->brick_zones);
        bool ok = sweep->brick_kappa && sweep->brick_source && sweep->brick_zones &&
                  make_blocks(sweep, lines, line_count, context->threads);
        for (int axis = 0; ok && axis < 3; axis++)
            ok = murk_slabs_create(&sweep->slabs[axis], grid, axis);
        if (!ok)
            status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d directions",
                               line_count);
    }
    if (status) {
        murk_sweep_release(sweep);
        return status;
    }
    measure_bricks(sweep);
    *out = sweep;
    return MURK_OK;
}

static void dismiss(murk_sweep *sweep)
{
    for (int t = 0; t < sweep->worker_count; t++) {
        struct worker *worker = &sweep->worker[t];
        for (int b = 0; b < MURK_MOST_BANDS; b++) {
            if (t)
                murk_free(worker->tally[b]);
            murk_free(worker->patch_power[b]);
        }
        murk_free(worker->slab);
        for (int i = 0; i < MURK_BLOCK; i++)
            murk_plane_clear(&worker->plane[i]);
    }
    murk_free(sweep->worker);
    sweep->worker = NULL;
    sweep->worker_count = 0;
}

void murk_sweep_release(murk_sweep *sweep)
{
    if (!sweep)
        return;
    dismiss(sweep);
    murk_free(sweep->line);
    murk_free(sweep->blocks);
    for (int axis = 0; axis < 3; axis++)
        murk_slabs_clear(&sweep->slabs[axis]);
    murk_free(sweep->brick_kappa);
    murk_free(sweep->brick_source);
    murk_free(sweep->brick_zones);
    murk_free(sweep);
}

void murk_sweep_limit(murk_sweep *sweep, const murk_region *region)
{
    sweep->region = *region;
}

const char *murk_sweep_kernel(const murk_sweep *sweep)
{
    return sweep->kernel_name;
}

const murk_traced *murk_sweep_traced(const murk_sweep *sweep)
{
    return &sweep->traced;
}

/* ---- one block of lines -------------------------------------------------------------------- */

struct run {
    const murk_sweep *sweep;
    const murk_cargo *cargo;
    murk_incoming incoming[MURK_MOST_BANDS];
    int bands;
    double power_factor;
    float dark; /* light up to this is none */
};

/* The lattices of a block, laid for a slab. */
struct lattices {
    murk_lattice lattice[MURK_BLOCK];
    murk_boundary boundary[MURK_BLOCK];
    murk_layers layers[MURK_BLOCK];
};

static size_t brick_floats(int bands)
{
    return (size_t)(1 + 2 * bands) * MURK_BRICK_SLOTS;
}

/* Lays out the bricks of a slab in layers. */
static void load_slab(const struct run *run, const murk_slabs *slabs, int s, struct worker *worker)
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
        layers += brick_floats(run->bands);
    }
}

static void store_slab(const struct run *run, const murk_slabs *slabs, int s, struct worker *worker)
{
    const float *tally = worker->slab + (size_t)(1 + run->bands) * MURK_BRICK_SLOTS;
    for (size_t i = slabs->first[s]; i < slabs->first[s + 1]; i++) {
        for (int b = 0; b < run->bands; b++)
            murk_slabs_add(slabs->axis, tally + b * MURK_BRICK_SLOTS,
                           worker->tally[b] + (size_t)slabs->brick[i] * MURK_BRICK_SLOTS);
        tally += brick_floats(run->bands);
    }
}

/* Line i of the block through the brick at a position in its slab. */
static bool cross_brick(const struct run *run, const struct lattices *lines, int i,
                        const murk_slabs *slabs, int s, size_t at, struct worker *worker)
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
    if (sweep->brick_source[b] <= run->dark && murk_window_dark(&window, run->bands, run->dark)) {
        worker->dark += sweep->brick_zones[b];
        murk_plane_close(&worker->plane[i], &window);
        return true;
    }
    float *bricks = worker->slab + at * brick_floats(run->bands);
    sweep->kernel(&(murk_kernel_job){
        .kappa_t = bricks,
        .source = bricks + MURK_BRICK_SLOTS,
        .tally = bricks + (size_t)(1 + run->bands) * MURK_BRICK_SLOTS,
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
static bool cross_slab(const struct run *run, const struct lattices *lines, int first, int last,
                       const murk_slabs *slabs, int s, struct worker *worker)
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

/* First and last lines of a lattice that any brick can meet. */
static void find_range(const murk_sweep *sweep, const murk_lattice *lattice,
                       const murk_slabs *slabs, int32_t first[2], int32_t last[2])
{
    const int across[2] = {slabs->u, slabs->v};
    for (int end = 0; end < 2; end++) {
        murk_layers layers;
        murk_lattice_layers(lattice, sweep->grid, slabs->row[end ? slabs->count - 1 : 0], &layers);
        for (int c = 0; c < 2; c++) {
            int32_t width = sweep->grid->hi[across[c]] - sweep->grid->lo[across[c]];
            int32_t low = layers.first[c] - (MURK_BRICK_EDGE - 1), high = layers.last[c] + width;
            first[c] = end && first[c] < low ? first[c] : low;
            last[c] = end && last[c] > high ? last[c] : high;
        }
    }
}

static bool lay_lines(const struct run *run, const struct block *block, struct lattices *lines,
                      struct worker *worker)
{
    const murk_sweep *sweep = run->sweep;
    for (int i = 0; i < block->count; i++) {
        int32_t first[2], last[2];
        murk_lattice_lay(&lines->lattice[i], sweep->grid, &sweep->line[block->first + i]);
        murk_boundary_lay(&lines->boundary[i], sweep->grid, sweep->ground, &lines->lattice[i],
                          run->incoming[0].uniform);
        find_range(sweep, &lines->lattice[i], &sweep->slabs[block->axis], first, last);
        if (!murk_plane_reset(&worker->plane[i], &lines->boundary[i], run->incoming, run->bands,
                              first, last))
            return false;
    }
    return true;
}

static bool run_block(const struct run *run, const struct block *block, struct worker *worker)
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

/* ---- all blocks ---------------------------------------------------------------------------- */

/* Gives each thread zeroed sums; their memory stays for the next run. */
static bool hire(murk_sweep *sweep, int count, const murk_cargo *cargo, int bands)
{
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS, widest = 0;
    size_t patches = sweep->ground && cargo->patch_power ? sweep->ground->patch_count : 0;
    for (int axis = 0; axis < 3; axis++)
        widest = sweep->slabs[axis].widest > widest ? sweep->slabs[axis].widest : widest;
    if (count != sweep->worker_count) {
        dismiss(sweep);
        sweep->worker = murk_alloc((size_t)count, sizeof *sweep->worker);
        if (!sweep->worker)
            return false;
        sweep->worker_count = count;
    }
    for (int t = 0; t < count; t++) {
        struct worker *worker = &sweep->worker[t];
        murk_free(worker->slab);
        worker->slab = murk_alloc(widest, brick_floats(bands) * sizeof(float));
        bool ok = worker->slab;
        for (int b = 0; ok && b < bands; b++) {
            if (!t)
                worker->tally[b] = cargo[b].tally;
            if (cargo->tally && worker->tally[b])
                memset(worker->tally[b], 0, slots * sizeof(float));
            else if (cargo->tally)
                worker->tally[b] = murk_alloc(slots, sizeof(float));
            ok = !cargo->tally || worker->tally[b];
            murk_free(worker->patch_power[b]);
            worker->patch_power[b] = patches ? murk_alloc(patches, sizeof(double)) : NULL;
            ok = ok && (!patches || worker->patch_power[b]);
            worker->net_power[b] = 0;
        }
        if (!ok)
            return false;
        worker->dark = worker->beyond = 0;
    }
    return true;
}

static void sum_up(const murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int b)
{
    const struct worker *worker = sweep->worker;
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS;
    int count = sweep->worker_count;
    if (cargo->tally) {
#pragma omp parallel for num_threads(context->threads) schedule(static)
        for (size_t i = 0; i < slots; i++) {
            float sum = 0;
            for (int t = 0; t < count; t++)
                sum += worker[t].tally[b][i];
            cargo->tally[i] = sum / fmaxf(sweep->kappa_t[i], sweep->clear);
        }
    }
    for (size_t i = 0; cargo->patch_power && sweep->ground && i < sweep->ground->patch_count; i++) {
        cargo->patch_power[i] = 0;
        for (int t = 0; t < count; t++)
            cargo->patch_power[i] += worker[t].patch_power[b][i];
    }
    cargo->net_power = 0;
    for (int t = 0; t < count; t++)
        cargo->net_power += worker[t].net_power[b];
}

/* The magnitude of a float orders like its bits, and integers have no rounding that would keep the
   compiler from taking many maxima at once. */
static float largest(const float *values, size_t count)
{
    uint32_t most = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, values + i, sizeof bits);
        bits &= 0x7FFFFFFF;
        most = bits > most ? bits : most;
    }
    float value;
    memcpy(&value, &most, sizeof value);
    return value;
}

/* The brightest that anything is in any band, and in each brick. */
static float find_brightest(const murk_context *context, const murk_sweep *sweep,
                            const murk_cargo *cargo, int bands)
{
    float most = 0;
#pragma omp parallel for num_threads(context->threads) schedule(static) reduction(max : most)
    for (size_t brick = 0; brick < sweep->grid->brick_count; brick++) {
        float here = 0;
        for (int b = 0; b < bands; b++)
            if (cargo[b].source)
                here = fmaxf(here,
                             largest(cargo[b].source + brick * MURK_BRICK_SLOTS, MURK_BRICK_SLOTS));
        sweep->brick_source[brick] = here;
        most = fmaxf(most, here);
    }
    for (int b = 0; b < bands; b++) {
        const murk_incoming *incoming = &cargo[b].incoming;
        most = fmaxf(most, (float)fmax(fabs(incoming->sky), fabs(incoming->horizon)));
        if (incoming->patch && sweep->ground)
            most = fmaxf(most, largest(incoming->patch, sweep->ground->patch_count));
    }
    return most;
}

murk_status murk_sweep_run(murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int bands,
                           double power_factor)
{
    double start = murk_seconds();
    int count = context->threads < sweep->block_count ? context->threads : sweep->block_count;
    count = count < 1 ? 1 : count;
    struct run run = {.sweep = sweep, .cargo = cargo, .bands = bands, .power_factor = power_factor};
    for (int b = 0; b < bands; b++)
        run.incoming[b] = cargo[b].incoming;
    float most = find_brightest(context, sweep, cargo, bands);
    run.dark = (float)(DARK * most);
    bool ok = hire(sweep, count, cargo, bands);
    double lines = sweep->zones * sweep->line_count;
    sweep->traced.crossings += lines;
    if (ok && most > 0 && sweep->grid->brick_count) {
#pragma omp parallel for num_threads(count) schedule(static, 1) reduction(&& : ok)
        for (int t = 0; t < count; t++)
            for (int i = t; i < sweep->block_count; i += count)
                ok = ok && run_block(&run, &sweep->blocks[i], &sweep->worker[t]);
    } else {
        sweep->traced.dark += lines;
    }
    if (!ok)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the lines of %d directions",
                         sweep->line_count);
    for (int b = 0; b < bands; b++)
        sum_up(context, sweep, &cargo[b], b);
    for (int t = 0; t < count; t++) {
        sweep->traced.dark += sweep->worker[t].dark;
        sweep->traced.beyond += sweep->worker[t].beyond;
    }
    sweep->traced.seconds += murk_seconds() - start;
    return MURK_OK;
}
