/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Factors by offset: in a uniform medium they depend on the relative position alone ([BG91] section
 * 5), so one table of as many factors as there are zones is enough.
 */
#include "factor_near.h"
#include "factor_offset.h"
#include "pairwise_state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t stride(const murk_offsets *o)
{
    return 2 * (size_t)o->n[2] - 1;
}

static size_t table_count(const murk_offsets *o)
{
    return (size_t)o->n[0] * (size_t)o->n[1] * stride(o);
}

void murk_offsets_clear(murk_offsets *offsets)
{
    murk_free(offsets->number);
    murk_free(offsets->zone);
    murk_free(offsets->patch);
    murk_free(offsets->aligned);
    murk_free(offsets->cell);
    murk_free(offsets->patch_at);
    murk_free(offsets->aligned_at);
    murk_free(offsets->in);
    murk_free(offsets->out);
    *offsets = (murk_offsets){0};
}

/* The frame axis that a unit vector lies along, or -1. */
static int lattice_axis(const double v[3])
{
    for (int a = 0; a < 3; a++)
        if (fabs(v[a]) > 1 - 1e-12)
            return a;
    return -1;
}

/* The lattice column that [e0, e1] on a ground axis is, or -1. */
static int32_t lattice_column(const murk_sight *s, const double v[3], double origin, int axis,
                              const double edge[2])
{
    double size = s->grid->voxel[axis];
    double f0 = (edge[0] - origin) * v[axis], f1 = (edge[1] - origin) * v[axis];
    double column = rint(fmin(f0, f1) / size);
    if (fabs(fmin(f0, f1) / size - column) > 1e-5 || fabs(fmax(f0, f1) / size - column - 1) > 1e-5)
        return -1;
    return column >= 0 && (column + 1) * size < s->box[axis] * (1 + 1e-9) ? (int32_t)column : -1;
}

/* Whether a patch is a cell of the lattice under the box; its columns on the ground's axes. */
static bool find_columns(const murk_sight *s, size_t patch, int32_t column[2])
{
    const murk_ground *ground = s->ground;
    const size_t at[2] = {patch % (size_t)ground->count[0], patch / (size_t)ground->count[0]};
    const double *const across[2] = {s->a, s->b};
    if (lattice_axis(s->up) < 0)
        return false;
    for (int c = 0; c < 2; c++) {
        int axis = lattice_axis(across[c]);
        if (axis < 0)
            return false;
        column[c] = lattice_column(s, across[c], s->origin[c], axis, ground->edge[c] + at[c]);
        if (column[c] < 0)
            return false;
    }
    return true;
}

size_t murk_offsets_others(const murk_sight *sight)
{
    size_t others = 0;
    int32_t column[2];
    for (size_t i = 0; sight->ground && i < sight->ground->patch_count; i++)
        others += !find_columns(sight, i, column);
    return others;
}

/* Parts the patches into those by offset and the others. */
static void sort_patches(murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    const murk_sight *s = &p->sight;
    int axis_a = lattice_axis(s->a), axis_b = lattice_axis(s->b), up = lattice_axis(s->up);
    o->up = up;
    for (size_t i = 0; i < p->patches; i++) {
        int32_t column[2];
        if (!find_columns(s, i, column)) {
            o->aligned_at[i] = -1;
            murk_pairwise_add_other(p, i);
            continue;
        }
        int32_t *cell = o->cell[o->aligned_count];
        cell[axis_a] = column[0];
        cell[axis_b] = column[1];
        cell[up] = 0;
        o->aligned_at[i] = (int64_t)o->aligned_count;
        o->aligned[o->aligned_count++] = i;
        const int32_t m[3] = {up == 0 ? 1 : o->n[0], up == 1 ? 1 : o->n[1], up == 2 ? 1 : o->n[2]};
        o->patch_at[((size_t)cell[0] * (size_t)m[1] + (size_t)cell[1]) * (size_t)m[2] +
                    (size_t)cell[2]] = (int64_t)i;
    }
    if (!o->aligned_count)
        o->up = -1;
}

static void fill_zone_table(murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    double kappa = p->sight.kappa_uniform;
    int32_t n1 = o->n[1], n2 = o->n[2];
#pragma omp parallel for schedule(dynamic, 64) num_threads(p->threads)
    for (int32_t i = 0; i < o->n[0] * n1 * n2; i++) {
        const int offset[3] = {i / (n1 * n2), i / n2 % n1, i % n2};
        double *row = o->zone + (size_t)(i / n2) * stride(o) + (n2 - 1);
        row[offset[2]] = row[-offset[2]] =
            kappa * kappa * murk_factor_offset_zone(p->sight.grid->voxel, offset, kappa);
    }
}

static void fill_patch_table(murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    const double *voxel = p->sight.grid->voxel;
    double kappa = p->sight.kappa_uniform;
    int up = o->up, a = (up + 1) % 3, b = (up + 2) % 3;
    bool turned = p->sight.up[up] < 0;
    const double size[3] = {voxel[a], voxel[b], voxel[up]};
#pragma omp parallel for schedule(dynamic, 64) num_threads(p->threads)
    for (int32_t i = 0; i < o->n[0] * o->n[1] * o->n[2]; i++) {
        const int at[3] = {i / (o->n[1] * o->n[2]), i / o->n[2] % o->n[1], i % o->n[2]};
        const int offset[3] = {at[a], at[b], turned ? o->n[up] - 1 - at[up] : at[up]};
        double factor = kappa * murk_factor_offset_patch(size, offset, p->sight.clearance, kappa);
        double *row = o->patch + (size_t)(i / o->n[2]) * stride(o);
        if (up == 2)
            row[at[2]] = factor;
        else
            row[o->n[2] - 1 + at[2]] = row[o->n[2] - 1 - at[2]] = factor;
    }
}

void murk_offsets_window(murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    for (int a = 0; a < 3; a++)
        o->reach[a] = (int)fmin(ceil(p->window[a] / 2 + 0.5) - 1, o->n[a] - 1);
    for (int32_t x = 0; x < o->n[0]; x++)
        for (int32_t y = 0; y < o->n[1]; y++)
            for (size_t i = 0; i < stride(o); i++) {
                const double d[3] = {x, y, (double)i - (o->n[2] - 1)};
                size_t at = ((size_t)x * (size_t)o->n[1] + (size_t)y) * stride(o) + i;
                for (int a = 0; a < 3; a++) {
                    double weight = murk_window_weight(p, a, d[a]);
                    o->zone[at] *= weight;
                    if (o->patch && a != o->up)
                        o->patch[at] *= weight;
                }
            }
}

/* s[x] = sum of t[|x - j|] over j on one axis, in place. */
static void sum_along(double *line, size_t step, int32_t n, double *work)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        work[i] = sum += line[(size_t)i * step];
    double first = line[0];
    for (int32_t i = 0; i < n; i++)
        line[(size_t)i * step] = work[i] + work[n - 1 - i] - first;
}

/* Row sums of V_mV_k by cell. */
static bool sum_zone_table(const murk_offsets *o, double *sum)
{
    size_t n0 = (size_t)o->n[0], n1 = (size_t)o->n[1], n2 = (size_t)o->n[2];
    double *work = murk_alloc(n0 + n1 + n2, sizeof *work);
    if (!work)
        return false;
    for (size_t i = 0; i < n0 * n1; i++)
        memcpy(sum + i * n2, o->zone + i * stride(o) + n2 - 1, n2 * sizeof *sum);
    for (size_t i = 0; i < n0 * n1; i++)
        sum_along(sum + i * n2, 1, o->n[2], work);
    for (size_t x = 0; x < n0; x++)
        for (size_t z = 0; z < n2; z++)
            sum_along(sum + x * n1 * n2 + z, n2, o->n[1], work);
    for (size_t i = 0; i < n1 * n2; i++)
        sum_along(sum + i, n1 * n2, o->n[0], work);
    murk_free(work);
    return true;
}

/* Adds to the sums over zones, by cell, the patches by offset; returns the largest share of
   4 kappa V. */
static double sum_rows(murk_pairwise *p, const double *by_cell, double *sum)
{
    double most = 0;
    for (size_t c = 0; c < p->zones; c++)
        sum[p->offsets.number[c]] = by_cell[c];
    memset(p->x, 0, p->zones * sizeof *p->x);
    for (size_t i = 0; i < p->patches; i++)
        p->px[i] = 1;
    murk_offsets_patches(p, p->x, p->px, sum, p->py);
    for (size_t k = 0; k < p->zones; k++)
        most = fmax(most, sum[k] / p->weight[k]);
    return most;
}

/* The zone that cell c's zone is the image of: lines alone tell up from down, and the box looks the
   same from its mirror images beside. */
static size_t mirror(const murk_offsets *o, const int32_t c[3], int vertical)
{
    size_t at = 0;
    for (int a = 0; a < 3; a++) {
        int32_t other = o->n[a] - 1 - c[a];
        bool turn = vertical >= 0 && a != vertical && other < c[a];
        at = at * (size_t)o->n[a] + (size_t)(turn ? other : c[a]);
    }
    return o->number[at];
}

/* Part of what leaves each zone and the box that goes up: y. */
static murk_status find_upwards(murk_context *context, murk_pairwise *p)
{
    murk_lines_through lines = {0};
    int vertical = lattice_axis(p->sight.up);
    size_t base = murk_lines_through_base(1 << 17, p->zones / (vertical < 0 ? 1 : 4) + 1);
    murk_status status = murk_lines_through_create(context, base, &lines);
    if (status)
        return status;
#pragma omp parallel for schedule(dynamic, 16) num_threads(p->threads)
    for (size_t k = 0; k < p->zones; k++)
        if (mirror(&p->offsets, p->cell[k], vertical) == k)
            p->y[k] = murk_near_upwards(&p->sight, &lines, p->cell[k]);
    for (size_t k = 0; k < p->zones; k++)
        p->y[k] = p->y[mirror(&p->offsets, p->cell[k], vertical)];
    murk_lines_through_clear(&lines);
    return MURK_OK;
}

/*
 * What a row lacks to 4 kappa V leaves for sky, horizon or nothing. A sum beyond it is an error of
 * the quadrature (1e-8 deep in a thick medium, where nothing should be left), and would let light
 * grow at each scattering; so the factors are scaled down by it.
 */
murk_status murk_offsets_escape(murk_context *context, murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    bool ground = p->sight.ground, horizon = ground && p->sight.ground->horizon;
    double *by_cell = murk_alloc(p->zones, sizeof *by_cell);
    murk_status status = MURK_OK;
    if (!by_cell || !sum_zone_table(o, by_cell))
        status = murk_fail(context, MURK_ERROR_MEMORY, "pairwise: out of memory for row sums");
    else if (ground)
        status = find_upwards(context, p);
    if (status) {
        murk_free(by_cell);
        return status;
    }
    double most = sum_rows(p, by_cell, p->sky);
    double scale = most > 1 ? 1 / most : 1;
    for (size_t i = 0; i < table_count(o); i++) {
        o->zone[i] *= scale;
        if (o->patch)
            o->patch[i] *= scale;
    }
    for (size_t c = 0; c < p->zones; c++) {
        size_t k = o->number[c];
        double rest = fmax(0, p->weight[k] - p->sky[k] * scale), others = 0;
        float *row = p->other_matrix + k * p->other_count;
        for (size_t i = 0; i < p->other_count; i++)
            others += row[i];
        if (others > rest)
            for (size_t i = 0; i < p->other_count; i++)
                row[i] *= (float)(rest / others);
        rest = fmax(0, rest - others);
        double up = ground ? p->y[k] * (p->weight[k] - scale * by_cell[c]) : rest;
        p->sky[k] = fmin(rest, fmax(0, up));
        p->horizon[k] = horizon ? rest - p->sky[k] : 0;
    }
    murk_free(by_cell);
    return MURK_OK;
}

murk_status murk_pairwise_offsets(murk_context *context, murk_pairwise *p)
{
    murk_offsets *o = &p->offsets;
    const murk_grid *grid = p->sight.grid;
    for (int a = 0; a < 3; a++) {
        o->n[a] = grid->hi[a] - grid->lo[a];
        o->reach[a] = o->n[a] - 1;
    }
    o->z0 = grid->lo[2] & 7;
    o->up = -1;
    o->number = murk_alloc(p->zones, sizeof *o->number);
    o->zone = murk_alloc(table_count(o), sizeof *o->zone);
    o->aligned = murk_alloc(p->patches, sizeof *o->aligned);
    o->cell = murk_alloc(p->patches, sizeof *o->cell);
    o->patch_at = murk_alloc(p->zones, sizeof *o->patch_at);
    o->aligned_at = murk_alloc(p->patches, sizeof *o->aligned_at);
    o->in = murk_alloc(p->zones, sizeof *o->in);
    o->out = murk_alloc(p->zones, sizeof *o->out);
    murk_status memory = MURK_ERROR_MEMORY;
    if (!o->number || !o->zone || !o->aligned || !o->cell || !o->patch_at || !o->aligned_at ||
        !o->in || !o->out)
        return murk_fail(context, memory, "pairwise: out of memory for %zu zones", p->zones);
    for (size_t k = 0; k < p->zones; k++) {
        const int32_t *c = p->cell[k];
        o->number[((size_t)c[0] * (size_t)o->n[1] + (size_t)c[1]) * (size_t)o->n[2] +
                  (size_t)c[2]] = k;
        o->patch_at[k] = -1;
    }
    sort_patches(p);
    fill_zone_table(p);
    if (o->up >= 0) {
        o->patch = murk_alloc(table_count(o), sizeof *o->patch);
        if (!o->patch)
            return murk_fail(context, memory, "pairwise: out of memory for %zu zones", p->zones);
        fill_patch_table(p);
    }
    return MURK_OK;
}
