/* SPDX-License-Identifier: Apache-2.0 */
/* Sums over factors by offset. z runs fastest in every table, so inner loops are straight. */
#include "pairwise_state.h"

#include <stdlib.h>
#include <string.h>

static size_t stride(const murk_offsets *o)
{
    return 2 * (size_t)o->n[2] - 1;
}

static int low(const murk_offsets *o, int axis, int at)
{
    return at > o->reach[axis] ? at - o->reach[axis] : 0;
}

static int high(const murk_offsets *o, int axis, int at) /* exclusive */
{
    int end = at + o->reach[axis] + 1;
    return end < o->n[axis] ? end : o->n[axis];
}

/* sum[z] of one column of cells from another: row[d] is the factor at distance d. */
static void add_column(const murk_offsets *o, const double *restrict row, const double *in,
                       double *restrict sum)
{
    for (int j = 0; j < o->n[2]; j++) {
        double value = in[j];
        const double *factor = row - j;
        int end = high(o, 2, j);
        for (int z = low(o, 2, j); z < end; z++)
            sum[z] += value * factor[z];
    }
}

void murk_offsets_zones(const murk_pairwise *p, const double *x, double *y)
{
    const murk_offsets *o = &p->offsets;
    size_t n1 = (size_t)o->n[1], n2 = (size_t)o->n[2];
    for (size_t c = 0; c < p->zones; c++)
        o->in[c] = x[o->number[c]];
    memset(o->out, 0, p->zones * sizeof *o->out);
#pragma omp parallel for schedule(dynamic, 4) num_threads(p->threads)
    for (int column = 0; column < o->n[0] * o->n[1]; column++) {
        int ix = column / o->n[1], iy = column % o->n[1];
        double *sum = o->out + (size_t)column * n2;
        for (int jx = low(o, 0, ix); jx < high(o, 0, ix); jx++)
            for (int jy = low(o, 1, iy); jy < high(o, 1, iy); jy++) {
                size_t at = (size_t)abs(jx - ix) * n1 + (size_t)abs(jy - iy);
                add_column(o, o->zone + at * stride(o) + n2 - 1,
                           o->in + ((size_t)jx * n1 + (size_t)jy) * n2, sum);
            }
    }
    for (size_t c = 0; c < p->zones; c++)
        y[o->number[c]] = o->out[c];
}

/* Index in the table of patches of the factor between a patch's cell and the zone (x, y, 0). */
static size_t patch_row(const murk_offsets *o, const int32_t cell[3], int x, int y)
{
    size_t at = (size_t)(o->up == 0 ? x : abs(x - cell[0])) * (size_t)o->n[1] +
                (size_t)(o->up == 1 ? y : abs(y - cell[1]));
    return at * stride(o) + (o->up == 2 ? 0 : (size_t)(o->n[2] - 1 - cell[2]));
}

/* Cells over a patch, or patches under a cell, on one axis. */
static void window(const murk_offsets *o, int axis, int at, bool patches, int range[2])
{
    bool whole = axis == o->up;
    range[0] = whole ? 0 : low(o, axis, at);
    range[1] = whole ? (patches ? 1 : o->n[axis]) : high(o, axis, at);
}

static int64_t patch_at(const murk_offsets *o, const int32_t cell[3])
{
    size_t m1 = o->up == 1 ? 1 : (size_t)o->n[1], m2 = o->up == 2 ? 1 : (size_t)o->n[2];
    return o->patch_at[((size_t)cell[0] * m1 + (size_t)cell[1]) * m2 + (size_t)cell[2]];
}

/* The column of cells at (x, y) takes the light of the patches. */
static void light_column(const murk_offsets *o, const double *px, int x, int y, double *sum)
{
    int rx[2], ry[2];
    window(o, 0, x, true, rx);
    window(o, 1, y, true, ry);
    int32_t cell[3];
    for (cell[0] = rx[0]; cell[0] < rx[1]; cell[0]++)
        for (cell[1] = ry[0]; cell[1] < ry[1]; cell[1]++)
            for (cell[2] = 0; cell[2] < (o->up == 2 ? 1 : o->n[2]); cell[2]++) {
                int64_t i = patch_at(o, cell);
                if (i < 0)
                    continue;
                const double *factor = o->patch + patch_row(o, cell, x, y);
                int rz[2];
                window(o, 2, cell[2], false, rz);
                for (int z = rz[0]; z < rz[1]; z++)
                    sum[z] += px[i] * factor[z];
            }
}

/* The light of all cells on a patch. */
static double light_patch(const murk_offsets *o, const int32_t cell[3])
{
    int rx[2], ry[2], rz[2];
    double sum = 0;
    window(o, 0, cell[0], false, rx);
    window(o, 1, cell[1], false, ry);
    window(o, 2, cell[2], false, rz);
    for (int x = rx[0]; x < rx[1]; x++)
        for (int y = ry[0]; y < ry[1]; y++) {
            const double *factor = o->patch + patch_row(o, cell, x, y);
            const double *in = o->in + ((size_t)x * (size_t)o->n[1] + (size_t)y) * (size_t)o->n[2];
            for (int z = rz[0]; z < rz[1]; z++)
                sum += in[z] * factor[z];
        }
    return sum;
}

void murk_offsets_patches(const murk_pairwise *p, const double *x, const double *px, double *y,
                          double *py)
{
    const murk_offsets *o = &p->offsets;
    if (o->up < 0)
        return;
    for (size_t c = 0; c < p->zones; c++) {
        o->in[c] = x[o->number[c]];
        o->out[c] = y[o->number[c]];
    }
#pragma omp parallel num_threads(p->threads)
    {
#pragma omp for schedule(dynamic, 4) nowait
        for (int column = 0; column < o->n[0] * o->n[1]; column++)
            light_column(o, px, column / o->n[1], column % o->n[1],
                         o->out + (size_t)column * (size_t)o->n[2]);
#pragma omp for schedule(dynamic, 4)
        for (size_t i = 0; i < o->aligned_count; i++)
            py[o->aligned[i]] = light_patch(o, o->cell[i]);
    }
    for (size_t c = 0; c < p->zones; c++)
        y[o->number[c]] = o->out[c];
}

/* Sum of factor[z] x over the cells z0 <= z < z1 of column (x, y), x by zone number: the numbers
   are in one run as far as a brick goes. */
static double sum_run(const murk_offsets *o, const double *factor, const double *x, int ix, int iy,
                      int z0, int z1)
{
    const size_t *number =
        o->number + ((size_t)ix * (size_t)o->n[1] + (size_t)iy) * (size_t)o->n[2];
    double sum = 0;
    while (z0 < z1) {
        int run = 8 - ((z0 + o->z0) & 7);
        int end = z0 + run < z1 ? z0 + run : z1;
        const double *in = x + number[z0];
        for (int z = z0; z < end; z++)
            sum += factor[z] * in[z - z0];
        z0 = end;
    }
    return sum;
}

static double zone_row(const murk_pairwise *p, size_t zone, const double *x)
{
    const murk_offsets *o = &p->offsets;
    const int32_t *c = p->cell[zone];
    size_t n1 = (size_t)o->n[1];
    int z0 = low(o, 2, c[2]), z1 = high(o, 2, c[2]);
    double sum = 0;
    for (int jx = low(o, 0, c[0]); jx < high(o, 0, c[0]); jx++)
        for (int jy = low(o, 1, c[1]); jy < high(o, 1, c[1]); jy++) {
            size_t at = (size_t)abs(jx - c[0]) * n1 + (size_t)abs(jy - c[1]);
            sum += sum_run(o, o->zone + at * stride(o) + o->n[2] - 1 - c[2], x, jx, jy, z0, z1);
        }
    sum -= o->zone[o->n[2] - 1] * x[zone];
    if (o->up < 0)
        return sum;
    int range[3][2];
    for (int a = 0; a < 3; a++)
        window(o, a, c[a], true, range[a]);
    int32_t cell[3];
    for (cell[0] = range[0][0]; cell[0] < range[0][1]; cell[0]++)
        for (cell[1] = range[1][0]; cell[1] < range[1][1]; cell[1]++)
            for (cell[2] = range[2][0]; cell[2] < range[2][1]; cell[2]++) {
                int64_t i = patch_at(o, cell);
                if (i >= 0)
                    sum += o->patch[patch_row(o, cell, c[0], c[1]) + (size_t)c[2]] *
                           x[p->zones + (size_t)i];
            }
    return sum;
}

double murk_offsets_row(const murk_pairwise *p, size_t element, const double *x)
{
    const murk_offsets *o = &p->offsets;
    if (element < p->zones)
        return zone_row(p, element, x);
    int64_t i = o->up < 0 ? -1 : o->aligned_at[element - p->zones];
    if (i < 0)
        return 0;
    const int32_t *cell = o->cell[i];
    int range[3][2];
    for (int a = 0; a < 3; a++)
        window(o, a, cell[a], false, range[a]);
    double sum = 0;
    for (int ix = range[0][0]; ix < range[0][1]; ix++)
        for (int iy = range[1][0]; iy < range[1][1]; iy++)
            sum += sum_run(o, o->patch + patch_row(o, cell, ix, iy), x, ix, iy, range[2][0],
                           range[2][1]);
    return sum;
}
