/* SPDX-License-Identifier: Apache-2.0 */
/*
 * As in exchange/factor_near.c, lines through the zone give the mean attenuation of the light on a
 * voxel, and the integral of 1/r^2 is exact; but here voxels without extinction count too.
 */
#include "lamp_near.h"

#include "factor_offset.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Up to this distance, in longest edges of a voxel, voxels are near. */
static const double NEAR = 3;

static void cell_offset(const murk_lamp_near *near, size_t index, int32_t out[3])
{
    for (int a = 2; a >= 0; a--) {
        size_t width = (size_t)(2 * near->reach[a] + 1);
        out[a] = (int32_t)(index % width) - near->reach[a];
        index /= width;
    }
}

int64_t murk_lamp_near_index(const murk_lamp_near *near, const int32_t offset[3])
{
    int64_t index = 0;
    for (int a = 0; a < 3; a++) {
        if (abs(offset[a]) > near->reach[a])
            return -1;
        index = index * (2 * near->reach[a] + 1) + offset[a] + near->reach[a];
    }
    return near->geometry[index] > 0 ? index : -1;
}

murk_status murk_lamp_near_create(murk_context *context, const murk_medium *medium,
                                  murk_lamp_near *out)
{
    const double *size = medium->grid->voxel;
    double limit = NEAR * fmax(size[0], fmax(size[1], size[2])) * (1 + 1e-6);
    murk_lamp_near near = {.medium = medium};
    for (int a = 0; a < 3; a++)
        near.reach[a] = (int)(limit / size[a]) + 1; /* the rim is beyond */
    near.count = murk_near_count(near.reach);
    double **arrays[] = {&near.geometry, &near.light, &near.length, &near.taken};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        *arrays[i] = murk_alloc(near.count, sizeof(double));
    if (!near.geometry || !near.light || !near.length || !near.taken) {
        murk_lamp_near_clear(&near);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for lamps");
    }
#pragma omp parallel for schedule(dynamic, 16) num_threads(context->threads)
    for (size_t i = near.count / 2; i < near.count; i++) {
        int32_t cell[3];
        double r2 = 0;
        cell_offset(&near, i, cell);
        for (int a = 0; a < 3; a++)
            r2 += pow(cell[a] * size[a], 2);
        if (r2 <= limit * limit)
            near.geometry[i] = near.geometry[near.count - 1 - i] =
                murk_factor_offset_zone(size, cell, 0);
    }
    *out = near;
    return MURK_OK;
}

void murk_lamp_near_clear(murk_lamp_near *near)
{
    murk_free(near->geometry);
    murk_free(near->light);
    murk_free(near->length);
    murk_free(near->taken);
    *near = (murk_lamp_near){0};
}

static double kappa_at(const murk_lamp_near *near, const int32_t cell[3])
{
    const murk_grid *grid = near->medium->grid;
    int64_t slot =
        murk_grid_slot(grid, grid->lo[0] + cell[0], grid->lo[1] + cell[1], grid->lo[2] + cell[2]);
    return slot < 0 ? 0 : near->medium->kappa_t[slot];
}

/* (1 - exp(-kappa l)) / kappa */
static double optical_length(double kappa, double length)
{
    double x = kappa * length;
    return length * (x < 0.03 ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : -expm1(-x) / x);
}

/* Follows light that leaves the cell at p, a position in it in cells, until it is beyond reach;
   gives what is left. */
static double follow(murk_lamp_near *near, const double *kappa, const double p[3],
                     const double direction[3], double t, double light)
{
    const double *size = near->medium->grid->voxel;
    int64_t stride[3], index = (int64_t)near->count / 2, width = 1;
    double step[3], next[3];
    for (int a = 2; a >= 0; a--) {
        bool up = direction[a] > 0;
        stride[a] = up ? width : -width;
        width *= 2 * near->reach[a] + 1;
        step[a] = direction[a] == 0 ? INFINITY : size[a] / fabs(direction[a]);
        next[a] = direction[a] == 0 ? INFINITY : step[a] * (up ? 1 - p[a] : p[a]);
    }
    for (;;) {
        int a = next[0] < next[1] ? 0 : 1;
        a = next[2] < next[a] ? 2 : a;
        next[a] += step[a];
        index += stride[a];
        if (!(near->geometry[index] > 0))
            return light;
        double end = fmin(next[0], fmin(next[1], next[2]));
        double taken = light * optical_length(kappa[index], end - t);
        near->length[index] += end - t;
        near->taken[index] += taken;
        light -= kappa[index] * taken;
        t = end;
    }
}

/* Sums over the lines: both ways of each, the part that stays in the cell and its chord. */
struct sums {
    double self, chord, left;
};

static struct sums trace(murk_lamp_near *near, const murk_lines_through *lines, const double *kappa,
                         double own)
{
    const double *size = near->medium->grid->voxel, lo[3] = {0, 0, 0};
    struct sums sums = {0};
    memset(near->length, 0, near->count * sizeof *near->length);
    memset(near->taken, 0, near->count * sizeof *near->taken);
    for (size_t i = 0; i < lines->count; i++) {
        double p[3], t[2];
        for (int a = 0; a < 3; a++)
            p[a] = lines->point[i][a] * size[a];
        if (!murk_box_chord(lo, size, p, lines->direction[i], t))
            continue;
        double chord = own * (t[1] - t[0]), escape = murk_chord_escape(chord);
        sums.self += 1 - escape;
        sums.chord += chord / 2;
        for (int way = 0; way < 2; way++) {
            double direction[3];
            for (int a = 0; a < 3; a++)
                direction[a] = way ? -lines->direction[i][a] : lines->direction[i][a];
            sums.left +=
                follow(near, kappa, lines->point[i], direction, way ? -t[0] : t[1], escape) / 2;
        }
    }
    sums.self /= (double)lines->count;
    sums.chord /= (double)lines->count;
    sums.left /= (double)lines->count;
    return sums;
}

void murk_lamp_near_trace(murk_lamp_near *near, const murk_lines_through *lines,
                          const int32_t cell[3])
{
    const double volume = near->medium->grid->volume;
    const size_t self = near->count / 2;
    double *kappa = near->light; /* until it is known */
    for (size_t i = 0; i < near->count; i++) {
        int32_t at[3];
        cell_offset(near, i, at);
        for (int a = 0; a < 3; a++)
            at[a] += cell[a];
        kappa[i] = near->geometry[i] > 0 ? kappa_at(near, at) : 0;
    }
    const double own = kappa[self];
    struct sums sums = trace(near, lines, kappa, own);
    const double kept = own * near->geometry[self] / (4 * volume) * sums.self / sums.chord;
    double taken = 0, by_lines = fmax(0, 1 - kept - sums.left);
    for (size_t i = 0; i < near->count; i++) {
        double mean = near->length[i] > 0 ? near->taken[i] / near->length[i] : 0;
        double light = own * near->geometry[i] * mean / (4 * volume);
        if (i == self)
            light = kept;
        else
            taken += kappa[i] / own * light;
        near->light[i] = light;
    }
    /* The lines know exactly what all voxels take where that is everything, and worse the fewer of
       them take anything: there the sum is the better one. */
    double certain = by_lines + sums.left > 0 ? by_lines / (by_lines + sums.left) : 0;
    double scale = taken > 0 ? 1 + certain * (by_lines / taken - 1) : 1;
    for (size_t i = 0; i < near->count; i++)
        near->light[i] *= i == self ? 1 : scale;
    near->left = fmax(0, 1 - kept - scale * taken);
}
