/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A line through a uniform point of the zone carries its light both ways; of what the chord l emits
 * one way, (1 - e^(-kappa l)) / (kappa l) escapes. It then goes on from zone to zone, so the 1/r^2
 * of [BG91] eq. (5) never appears. The sum of lengths in a neighbour has the geometric integral of
 * 1/r^2 as its mean; that is known exactly (factor_offset.h), so the ratio caught / length needs
 * the attenuation alone from the lines, and is exact in thin media.
 */
#include "factor_near.h"

#include "walk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Additive recurrence with the powers of 1/g, g^6 = g + 1: evenly spread in five dimensions. */
static const double GOLDEN = 1.1347241384015194;

murk_status murk_lines_through_create(murk_context *context, size_t base, murk_lines_through *out)
{
    murk_lines_through lines = {.count = 8 * base};
    lines.point = murk_alloc(lines.count, sizeof *lines.point);
    lines.direction = murk_alloc(lines.count, sizeof *lines.direction);
    if (!lines.point || !lines.direction) {
        murk_lines_through_clear(&lines);
        return murk_fail(context, MURK_ERROR_MEMORY, "pairwise: out of memory for its lines");
    }
    for (size_t i = 0; i < base; i++) {
        double x[5], step = 1;
        for (int c = 0; c < 5; c++) {
            step /= GOLDEN;
            double along = 0.5 + (double)(i + 1) * step;
            x[c] = along - floor(along);
        }
        double z = 2 * x[3] - 1, ring = sqrt(1 - z * z), phi = 2 * M_PI * x[4];
        const double d[3] = {ring * cos(phi), ring * sin(phi), z};
        for (size_t image = 0; image < 8; image++)
            for (int a = 0; a < 3; a++) {
                bool mirror = image >> a & 1;
                lines.point[8 * i + image][a] = mirror ? 1 - x[a] : x[a];
                lines.direction[8 * i + image][a] = mirror ? -d[a] : d[a];
            }
    }
    *out = lines;
    return MURK_OK;
}

size_t murk_lines_through_base(size_t total, size_t zones)
{
    enum { LEAST = 128, MOST = 1024 };
    size_t base = zones ? total / zones : LEAST;
    return base < LEAST ? LEAST : base > MOST ? MOST : base;
}

void murk_lines_through_clear(murk_lines_through *lines)
{
    murk_free(lines->point);
    murk_free(lines->direction);
    *lines = (murk_lines_through){0};
}

enum { TO_SKY = -3 };

/* Where a ray that leaves p for good ends: TO_SKY, or as murk_ground_patch() says. */
static int64_t ray_end(const murk_sight *sight, const double p[3], const double d[3])
{
    double rise = sight->up[0] * d[0] + sight->up[1] * d[1] + sight->up[2] * d[2];
    if (!sight->ground || rise >= 0)
        return TO_SKY;
    double at[3];
    murk_sight_project(sight, p, at);
    double t = -at[2] / rise;
    const double end[3] = {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
    murk_sight_project(sight, end, at);
    return murk_ground_patch(sight->ground, at[0], at[1]);
}

static void tally_end(murk_near *near, int64_t end, double light)
{
    if (end == TO_SKY)
        near->up += light;
    else if (end < 0)
        near->down += light;
    else
        near->ground += light;
    if (end >= 0 && near->patch)
        near->patch[end] += light;
}

/* Takes the light of a ray from zone to zone; returns what leaves the medium. */
static double follow(const murk_sight *sight, const int32_t cell[3], const double p[3],
                     const double d[3], double t0, double light, murk_near *near)
{
    const murk_grid *grid = sight->grid;
    murk_walk walk;
    murk_step step;
    murk_walk_start(&walk, grid, p, d, t0, INFINITY);
    while (murk_walk_next(&walk, &step) && light > 1e-9) {
        double kappa = sight->kappa_t[(size_t)step.brick * MURK_BRICK_SLOTS + (size_t)step.slot];
        if (kappa <= 0)
            continue;
        double length = step.t1 - step.t0;
        double caught = -light * expm1(-kappa * length);
        const int32_t *corner = grid->brick[step.brick];
        const int32_t at[3] = {step.slot >> 6, step.slot >> 3 & 7, step.slot & 7};
        size_t index = 0;
        bool inside = true;
        for (int a = 0; a < 3; a++) {
            int32_t offset = corner[a] * 8 + at[a] - grid->lo[a] - cell[a];
            inside = inside && abs(offset) <= near->reach[a];
            index = index * (size_t)(2 * near->reach[a] + 1) + (size_t)(offset + near->reach[a]);
        }
        if (inside) {
            near->length[index] += length;
            near->caught[index] += caught / kappa;
        }
        light -= caught;
    }
    return light;
}

/* The part of line `index` through a cell that lies in it. */
static void chord_in_cell(const murk_sight *sight, const murk_lines_through *lines, size_t index,
                          const int32_t cell[3], double p[3], double t[2])
{
    const double *size = sight->grid->voxel;
    double lo[3], hi[3];
    for (int a = 0; a < 3; a++) {
        lo[a] = cell[a] * size[a];
        hi[a] = (cell[a] + 1) * size[a];
        p[a] = (cell[a] + lines->point[index][a]) * size[a];
    }
    if (!murk_box_chord(lo, hi, p, lines->direction[index], t))
        t[0] = t[1] = 0;
}

void murk_near_trace(const murk_sight *sight, const murk_lines_through *lines,
                     const int32_t cell[3], double kappa, murk_near *near)
{
    size_t count = murk_near_count(near->reach);
    memset(near->length, 0, count * sizeof *near->length);
    memset(near->caught, 0, count * sizeof *near->caught);
    size_t patches = near->patch ? sight->ground->patch_count : 0;
    if (patches)
        memset(near->patch, 0, patches * sizeof *near->patch);
    near->self = near->chord = near->up = near->down = near->ground = 0;
    for (size_t i = 0; i < lines->count; i++) {
        const double *d = lines->direction[i];
        double p[3], t[2];
        chord_in_cell(sight, lines, i, cell, p, t);
        double chord = kappa * (t[1] - t[0]), escape = murk_chord_escape(chord);
        near->self += 2 * (1 - escape);
        near->chord += chord;
        for (int way = 0; way < 2; way++) {
            const double to[3] = {way ? -d[0] : d[0], way ? -d[1] : d[1], way ? -d[2] : d[2]};
            double light = follow(sight, cell, p, to, way ? -t[0] : t[1], escape, near);
            tally_end(near, ray_end(sight, p, to), light);
        }
    }
    double share = 0.5 / (double)lines->count;
    near->self *= share;
    near->chord *= share;
    near->up *= share;
    near->down *= share;
    near->ground *= share;
    for (size_t i = 0; i < patches; i++)
        near->patch[i] *= share;
    for (size_t i = 0; i < count; i++) {
        near->length[i] *= share;
        near->caught[i] *= share;
    }
}

double murk_near_upwards(const murk_sight *sight, const murk_lines_through *lines,
                         const int32_t cell[3])
{
    double sum = 0, up = 0;
    for (size_t i = 0; i < lines->count; i++) {
        const double *d = lines->direction[i];
        double p[3], t[2];
        chord_in_cell(sight, lines, i, cell, p, t);
        double escape = murk_chord_escape(sight->kappa_uniform * (t[1] - t[0]));
        double rise = sight->up[0] * d[0] + sight->up[1] * d[1] + sight->up[2] * d[2];
        double ahead = escape * exp(-murk_sight_depth(sight, p, d, t[1], INFINITY));
        double back = escape * exp(-murk_sight_depth(sight, p, d, -INFINITY, t[0]));
        sum += ahead + back;
        up += rise > 0 ? ahead : back;
    }
    return sum > 0 ? up / sum : 1;
}
