/* SPDX-License-Identifier: Apache-2.0 */
#include "sweep_state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Below this fraction of its band's brightest source light is as good as none. */
static const double DARK = 1e-12;
/* Voxels without extinction get this optical depth instead, which no line feels: so their mean of I
   comes from the same division by kappa_t as everywhere. */
static const double CLEAR = 1e-12;

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
        struct murk_block *last =
            sweep->block_count ? &sweep->blocks[sweep->block_count - 1] : NULL;
        int axis = keys[i].key >> 4, sign = keys[i].key & 8 ? 1 : -1;
        if (last && last->count < most && last->axis == axis && last->sign == sign)
            last->count++;
        else
            sweep->blocks[sweep->block_count++] =
                (struct murk_block){.first = i, .count = 1, .axis = axis, .sign = sign};
    }
    sweep->line_count = count;
    murk_free(keys);
    return true;
}

static void measure_bricks(const murk_context *context, murk_sweep *sweep)
{
    double all = 0;
#pragma omp parallel for num_threads(context->threads) schedule(static) reduction(+ : all)
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
        all += zones; /* whole numbers: in any order the same */
    }
    sweep->zones = all;
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
        sweep->brick_source =
            murk_alloc(grid->brick_count * MURK_MOST_BANDS, sizeof *sweep->brick_source);
        sweep->brick_zones = murk_alloc(grid->brick_count, sizeof *sweep->brick_zones);
        bool ok = sweep->brick_kappa && sweep->brick_source && sweep->brick_zones &&
                  make_blocks(sweep, lines, line_count, context->threads);
#pragma omp parallel for num_threads(context->threads) schedule(dynamic, 1) reduction(&& : ok)
        for (int axis = 0; axis < 3; axis++)
            ok = ok && murk_slabs_create(&sweep->slabs[axis], grid, axis);
        if (!ok)
            status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d directions",
                               line_count);
    }
    if (status) {
        murk_sweep_release(sweep);
        return status;
    }
    measure_bricks(context, sweep);
    *out = sweep;
    return MURK_OK;
}

static void dismiss(murk_sweep *sweep)
{
    for (int t = 0; t < sweep->worker_count; t++) {
        struct murk_worker *worker = &sweep->worker[t];
        for (int b = 0; b < MURK_MOST_BANDS; b++) {
            if (t) {
                murk_free(worker->tally[b]);
                murk_free(worker->slope_tally[b]);
            }
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

void murk_sweep_bend(murk_sweep *sweep, const murk_bent *bent)
{
    sweep->bent = bent && bent->count ? bent : NULL;
    dismiss(sweep);
}

const char *murk_sweep_kernel(const murk_sweep *sweep)
{
    return sweep->kernel_name;
}

const murk_traced *murk_sweep_traced(const murk_sweep *sweep)
{
    return &sweep->traced;
}

/* ---- all blocks ---------------------------------------------------------------------------- */

/* Zeroed, made if it is not there. */
static bool clear(float **tally, size_t slots)
{
    if (*tally)
        memset(*tally, 0, slots * sizeof **tally);
    else
        *tally = murk_alloc(slots, sizeof **tally);
    return *tally;
}

/* Gives each thread zeroed sums; their memory stays for the next run. */
static bool hire(murk_sweep *sweep, int count, const murk_cargo *cargo, int bands, bool bent)
{
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS, widest = 0;
    size_t slopes = bent ? sweep->bent->count * MURK_BENT_SLOTS : 0;
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
        struct murk_worker *worker = &sweep->worker[t];
        murk_free(worker->slab);
        worker->slab = murk_alloc(widest, murk_laid_floats(bands, bent) * sizeof(float));
        bool ok = worker->slab;
        for (int b = 0; ok && b < bands; b++) {
            if (!t) {
                worker->tally[b] = cargo[b].tally;
                worker->slope_tally[b] = cargo[b].slope_tally;
            }
            ok = (!cargo->tally || clear(&worker->tally[b], slots)) &&
                 (!slopes || clear(&worker->slope_tally[b], slopes));
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

/* A linear fit has 12 times the moment for its slope: the mean of p^2 over a voxel is 1/12. */
static void sum_slopes(const murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int b)
{
    const struct murk_worker *worker = sweep->worker;
    int count = sweep->worker_count;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t brick = 0; brick < sweep->grid->brick_count; brick++) {
        if (sweep->bent->place[brick] == MURK_NOT_BENT)
            continue;
        size_t first = (size_t)sweep->bent->place[brick] * MURK_BENT_SLOTS;
        const float *kappa_t = sweep->kappa_t + brick * MURK_BRICK_SLOTS;
        for (size_t i = 0; i < MURK_BENT_SLOTS; i++) {
            float sum = 0, kappa = kappa_t[i % MURK_BRICK_SLOTS];
            for (int t = 0; t < count; t++)
                sum += worker[t].slope_tally[b][first + i];
            cargo->slope_tally[first + i] = kappa > 0 ? 12 * sum / kappa : 0;
        }
    }
}

/* Sums up what one band has brought about. The power is what the zones took, where that is known:
   of a line that hardly loses anything no difference is left. */
static void sum_up(const murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int b,
                   double power_factor)
{
    const struct murk_worker *worker = sweep->worker;
    size_t slots = sweep->grid->brick_count * MURK_BRICK_SLOTS;
    int count = sweep->worker_count;
    double taken = 0;
    if (cargo->tally) {
#pragma omp parallel for num_threads(context->threads) schedule(static) reduction(+ : taken)
        for (size_t i = 0; i < slots; i++) {
            float sum = 0;
            for (int t = 0; t < count; t++)
                sum += worker[t].tally[b][i];
            cargo->tally[i] = sum / fmaxf(sweep->kappa_t[i], sweep->clear);
            taken += sweep->kappa_t[i] > 0 ? sum : 0;
        }
    }
    if (cargo->slope_tally && sweep->bent)
        sum_slopes(context, sweep, cargo, b);
    for (size_t i = 0; cargo->patch_power && sweep->ground && i < sweep->ground->patch_count; i++) {
        cargo->patch_power[i] = 0;
        for (int t = 0; t < count; t++)
            cargo->patch_power[i] += worker[t].patch_power[b][i];
    }
    cargo->net_power = power_factor * sweep->grid->volume * taken;
    for (int t = 0; !cargo->tally && t < count; t++)
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

/* The brightest that anything is in a band, and in each brick. */
static float find_brightest(const murk_context *context, const murk_sweep *sweep,
                            const murk_cargo *cargo, int band)
{
    const float *source = cargo->source;
    const murk_incoming *incoming = &cargo->incoming;
    float most = (float)fmax(fabs(incoming->sky), fabs(incoming->horizon));
    if (incoming->patch && sweep->ground)
        most = fmaxf(most, largest(incoming->patch, sweep->ground->patch_count));
#pragma omp parallel for num_threads(context->threads) schedule(static) reduction(max : most)
    for (size_t brick = 0; brick < sweep->grid->brick_count; brick++) {
        float here = source ? largest(source + brick * MURK_BRICK_SLOTS, MURK_BRICK_SLOTS) : 0;
        sweep->brick_source[brick * MURK_MOST_BANDS + (size_t)band] = here;
        most = fmaxf(most, here);
    }
    return most;
}

murk_status murk_sweep_run(murk_context *context, murk_sweep *sweep, murk_cargo *cargo, int bands,
                           double power_factor)
{
    double start = murk_seconds();
    int count = context->threads < sweep->block_count ? context->threads : sweep->block_count;
    count = count < 1 ? 1 : count;
    struct murk_run run = {
        .sweep = sweep, .cargo = cargo, .bands = bands, .power_factor = power_factor};
    float most = 0;
    for (int b = 0; b < bands; b++) {
        run.incoming[b] = cargo[b].incoming;
        float brightest = find_brightest(context, sweep, &cargo[b], b);
        run.dark[b] = (float)(DARK * brightest);
        most = fmaxf(most, brightest);
    }
    run.bent = sweep->bent && cargo->slope_tally;
    bool ok = hire(sweep, count, cargo, bands, run.bent);
    double lines = sweep->zones * sweep->line_count;
    sweep->traced.crossings += lines;
    if (ok && most > 0 && sweep->grid->brick_count) {
#pragma omp parallel for num_threads(count) schedule(static, 1) reduction(&& : ok)
        for (int t = 0; t < count; t++)
            for (int i = t; i < sweep->block_count; i += count)
                ok = ok && murk_cross_block(&run, &sweep->blocks[i], &sweep->worker[t]);
    } else {
        sweep->traced.dark += lines;
    }
    if (!ok)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the lines of %d directions",
                         sweep->line_count);
    for (int b = 0; b < bands; b++)
        sum_up(context, sweep, &cargo[b], b, power_factor);
    for (int t = 0; t < count; t++) {
        sweep->traced.dark += sweep->worker[t].dark;
        sweep->traced.beyond += sweep->worker[t].beyond;
    }
    sweep->traced.seconds += murk_seconds() - start;
    return MURK_OK;
}
