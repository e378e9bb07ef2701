/* SPDX-License-Identifier: Apache-2.0 */
#include "pairwise.h"

#include "factor_patch.h"
#include "pairwise_state.h"

#include <math.h>
#include <string.h>

static const double MOST_BYTES = 4.0 * 1024 * 1024 * 1024;

double murk_window_weight(const murk_pairwise *p, int axis, double d)
{
    return fmin(1, fmax(0, p->window[axis] / 2 + 0.5 - fabs(d)));
}

void murk_pairwise_add_other(murk_pairwise *p, size_t patch)
{
    p->other_at[patch] = (int64_t)p->other_count;
    p->other[p->other_count++] = patch;
}

static void release(void *state)
{
    murk_pairwise *p = state;
    if (!p)
        return;
    void *const arrays[] = {p->slot, p->cell,  p->weight,       p->area,    p->sky, p->horizon,
                            p->self, p->other, p->other_matrix, p->x,       p->y,   p->patch_sky,
                            p->px,   p->py,    p->matrix,       p->other_at};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        murk_free(arrays[i]);
    murk_offsets_clear(&p->offsets);
    murk_free(p);
}

static bool make_arrays(murk_pairwise *p)
{
    size_t n = p->zones, m = p->patches;
    p->slot = murk_alloc(n, sizeof *p->slot);
    p->cell = murk_alloc(n, sizeof *p->cell);
    p->weight = murk_alloc(n, sizeof *p->weight);
    p->sky = murk_alloc(n, sizeof *p->sky);
    p->horizon = murk_alloc(n, sizeof *p->horizon);
    p->x = murk_alloc(n, sizeof *p->x);
    p->y = murk_alloc(n, sizeof *p->y);
    p->area = murk_alloc(m, sizeof *p->area);
    p->patch_sky = murk_alloc(m, sizeof *p->patch_sky);
    p->other = murk_alloc(m, sizeof *p->other);
    p->other_at = murk_alloc(m, sizeof *p->other_at);
    p->px = murk_alloc(m, sizeof *p->px);
    p->py = murk_alloc(m, sizeof *p->py);
    return p->slot && p->cell && p->weight && p->sky && p->horizon && p->x && p->y && p->area &&
           p->patch_sky && p->other && p->other_at && p->px && p->py;
}

/* Zones in the order of their numbers: by brick, then slot. */
static void list_zones(murk_pairwise *p)
{
    const murk_grid *grid = p->sight.grid;
    size_t k = 0;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            if (!murk_grid_active(grid, b, slot))
                continue;
            const int32_t at[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
            for (int a = 0; a < 3; a++)
                p->cell[k][a] = grid->brick[b][a] * 8 + at[a] - grid->lo[a];
            p->slot[k] = b * MURK_BRICK_SLOTS + (size_t)slot;
            p->weight[k] = 4.0 * p->sight.kappa_t[p->slot[k]] * grid->volume;
            k++;
        }
    for (size_t i = 0; i < p->patches; i++) {
        p->area[i] = murk_ground_area(p->sight.ground, i);
        p->other_at[i] = -1;
    }
}

static murk_status fill_others(murk_context *context, murk_pairwise *p)
{
    p->other_matrix = murk_alloc(p->zones * p->other_count, sizeof *p->other_matrix);
    if (!p->other_matrix)
        return murk_fail(context, MURK_ERROR_MEMORY,
                         "pairwise: out of memory for the factors of %zu patches", p->other_count);
    if (p->sight.clearance < 0) /* the lines through each zone will do it */
        return MURK_OK;
#pragma omp parallel for schedule(dynamic, 4) num_threads(p->threads)
    for (size_t k = 0; k < p->zones; k++)
        for (size_t i = 0; i < p->other_count; i++)
            p->other_matrix[k * p->other_count + i] = (float)murk_patch_factor(
                &p->sight, p->cell[k], p->sight.kappa_t[p->slot[k]], p->other[i]);
    return MURK_OK;
}

/* px of the patches in `other` += sum over zones, a block of patches a thread. */
static void gather_others(const murk_pairwise *p, const double *x, double *py)
{
    enum { BLOCK = 64 };
    size_t blocks = (p->other_count + BLOCK - 1) / BLOCK;
#pragma omp parallel for schedule(dynamic, 1) num_threads(p->threads)
    for (size_t b = 0; b < blocks; b++) {
        double sum[BLOCK] = {0};
        size_t first = b * BLOCK;
        size_t count = p->other_count - first < BLOCK ? p->other_count - first : BLOCK;
        for (size_t k = 0; k < p->zones; k++)
            for (size_t i = 0; i < count; i++)
                sum[i] += x[k] * p->other_matrix[k * p->other_count + first + i];
        for (size_t i = 0; i < count; i++)
            py[p->other[first + i]] = sum[i];
    }
}

/* A patch sees the sky where it sees no zone. */
static void set_patch_sky(murk_pairwise *p)
{
    for (size_t k = 0; k < p->zones; k++)
        p->x[k] = 1;
    memset(p->px, 0, p->patches * sizeof *p->px);
    murk_offsets_patches(p, p->x, p->px, p->y, p->py);
    gather_others(p, p->x, p->py);
    for (size_t i = 0; i < p->patches; i++)
        p->patch_sky[i] = fmax(0, p->area[i] - p->py[i]);
}

/* The window of [BG91] eq. (19) for patches that are not by offset. */
static void cut_others(murk_pairwise *p)
{
    const murk_sight *s = &p->sight;
    const double *voxel = s->grid->voxel;
    int up = 0;
    for (int a = 1; a < 3; a++)
        if (fabs(s->up[a]) > fabs(s->up[up]))
            up = a;
    for (size_t n = 0; n < p->other_count; n++) {
        size_t ia = p->other[n] % (size_t)s->ground->count[0];
        size_t ib = p->other[n] / (size_t)s->ground->count[0];
        double a = (s->ground->edge[0][ia] + s->ground->edge[0][ia + 1]) / 2 - s->origin[0];
        double b = (s->ground->edge[1][ib] + s->ground->edge[1][ib + 1]) / 2 - s->origin[1];
        for (size_t k = 0; k < p->zones; k++)
            for (int axis = 0; axis < 3; axis++) {
                double at = a * s->a[axis] + b * s->b[axis] - s->origin[2] * s->up[axis];
                if (axis != up)
                    p->other_matrix[k * p->other_count + n] *= (float)murk_window_weight(
                        p, axis, at / voxel[axis] - p->cell[k][axis] - 0.5);
            }
    }
}

double murk_pairwise_memory(const murk_medium *medium, const murk_ground *ground)
{
    murk_sight sight;
    murk_sight_init(&sight, medium, ground);
    const bool offsets = murk_pairwise_by_offset(&sight);
    const double zones = (double)medium->grid->zone_count;
    const double patches = ground ? (double)ground->patch_count : 0;
    const double others = offsets ? (double)murk_offsets_others(&sight) : patches;
    /* make_arrays(), and what both forms have for a zone and a patch */
    const double zone = 10 * sizeof(double), patch = 10 * sizeof(double);
    const double factors = offsets ? zones * (ground ? 9 : 7) * sizeof(double)
                                   : zones * (zones * sizeof(float) + 5 * sizeof(double));
    return factors + zones * zone + patches * patch + zones * others * sizeof(float);
}

static murk_status check_memory(murk_context *context, const murk_pairwise *p, bool offsets)
{
    double bytes = (double)p->zones * (double)p->other_count * sizeof(float);
    if (offsets)
        bytes += (double)p->zones * (p->patches ? 4 : 2) * sizeof(double);
    else
        bytes += (double)p->zones * (double)p->zones * sizeof(float);
    if (bytes <= MOST_BYTES)
        return MURK_OK;
    return murk_fail(context, MURK_ERROR_INPUT,
                     "pairwise: %zu zones and %zu patches have %.3g GiB of exchange factors, more "
                     "than 4 GiB; use the method lines",
                     p->zones, p->patches, bytes / (1024.0 * 1024 * 1024));
}

static murk_status fill(murk_context *context, murk_pairwise *p)
{
    bool offsets = murk_pairwise_by_offset(&p->sight);
    murk_status status = MURK_OK;
    if (offsets) {
        status = check_memory(context, p, offsets);
        if (!status)
            status = murk_pairwise_offsets(context, p);
    } else {
        p->offsets.up = -1;
        for (size_t i = 0; i < p->patches; i++)
            murk_pairwise_add_other(p, i);
    }
    if (!status)
        status = check_memory(context, p, offsets);
    if (!status)
        status = fill_others(context, p);
    if (!status && p->zones)
        status = offsets ? murk_offsets_escape(context, p) : murk_pairwise_dense(context, p);
    if (status)
        return status;
    set_patch_sky(p);
    if (p->windowed) {
        if (offsets)
            murk_offsets_window(p);
        cut_others(p);
    }
    return MURK_OK;
}

static murk_status init(murk_context *context, const murk_medium *medium, const murk_ground *ground,
                        const murk_solve_options *options, void **state)
{
    murk_pairwise *p = murk_alloc(1, sizeof *p);
    if (!p)
        return murk_fail(context, MURK_ERROR_MEMORY, "pairwise: out of memory");
    murk_sight_init(&p->sight, medium, ground);
    p->threads = context->threads;
    p->zones = medium->grid->zone_count;
    p->patches = ground ? ground->patch_count : 0;
    for (int a = 0; a < 3; a++) {
        int m = options ? options->window[a] : 0;
        p->window[a] = m > 0 ? m : INFINITY;
        p->windowed = p->windowed || m > 0;
    }
    murk_status status = MURK_OK;
    if (!make_arrays(p))
        status = murk_fail(context, MURK_ERROR_MEMORY, "pairwise: out of memory for %zu zones",
                           p->zones);
    if (!status) {
        list_zones(p);
        status = fill(context, p);
    }
    if (status) {
        release(p);
        return status;
    }
    *state = p;
    return MURK_OK;
}

/* y += sums over the stored matrices. */
static void apply_matrices(const murk_pairwise *p, const double *x, const double *px, double *y)
{
#pragma omp parallel for schedule(static) num_threads(p->threads)
    for (size_t k = 0; k < p->zones; k++) {
        double sum = 0;
        const float *patch = p->other_matrix + k * p->other_count;
        for (size_t i = 0; i < p->other_count; i++)
            sum += patch[i] * px[p->other[i]];
        if (p->matrix) {
            const float *row = p->matrix + k * p->zones;
            for (size_t j = 0; j < p->zones; j++)
                sum += row[j] * x[j];
            sum += p->self[k] * x[k];
        }
        y[k] += sum;
    }
}

static void apply_band(murk_pairwise *p, const murk_radiosity *in, murk_incident *out)
{
    for (size_t k = 0; k < p->zones; k++)
        p->x[k] = in->zone ? in->zone[p->slot[k]] : 0;
    for (size_t i = 0; i < p->patches; i++)
        p->px[i] = in->patch ? in->patch[i] : 0;
    memset(p->y, 0, p->zones * sizeof *p->y);
    if (p->offsets.zone)
        murk_offsets_zones(p, p->x, p->y);
    murk_offsets_patches(p, p->x, p->px, p->y, p->py);
    apply_matrices(p, p->x, p->px, p->y);
    gather_others(p, p->x, p->py);
    double power = 0;
    for (size_t k = 0; k < p->zones; k++) {
        double net =
            p->y[k] + p->sky[k] * in->sky + p->horizon[k] * in->horizon - p->weight[k] * p->x[k];
        out->zone[p->slot[k]] = (float)(net / p->weight[k]);
        power += net; /* what the zones exchange with one another cancels in the sum */
    }
    for (size_t i = 0; i < p->patches; i++)
        out->patch[i] = (float)((p->py[i] + p->patch_sky[i] * in->sky) / p->area[i]);
    out->net_power = power;
}

static murk_status apply(murk_context *context, void *state, const murk_radiosity *in,
                         murk_incident *out, int bands)
{
    (void)context;
    for (int b = 0; b < bands; b++)
        apply_band(state, &in[b], &out[b]);
    return MURK_OK;
}

static double row(void *state, size_t element, const double *x, double *self)
{
    const murk_pairwise *p = state;
    double sum = p->offsets.zone ? murk_offsets_row(p, element, x) : 0;
    *self = 0;
    if (element >= p->zones) {
        size_t patch = element - p->zones;
        int64_t at = p->other_at[patch];
        for (size_t k = 0; at >= 0 && k < p->zones; k++)
            sum += p->other_matrix[k * p->other_count + (size_t)at] * x[k];
        return sum / p->area[patch];
    }
    const float *patches = p->other_matrix + element * p->other_count;
    for (size_t i = 0; i < p->other_count; i++)
        sum += patches[i] * x[p->zones + p->other[i]];
    if (p->matrix) {
        const float *factors = p->matrix + element * p->zones;
        for (size_t j = 0; j < p->zones; j++)
            sum += factors[j] * x[j];
        *self = p->self[element] / p->weight[element];
    } else {
        *self = p->offsets.zone[p->offsets.n[2] - 1] / p->weight[element];
    }
    return sum / p->weight[element];
}

const murk_exchange_method murk_exchange_pairwise = {
    .name = "pairwise", .init = init, .apply = apply, .row = row, .release = release};
