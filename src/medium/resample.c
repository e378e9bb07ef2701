/* SPDX-License-Identifier: Apache-2.0 */
#include "resample.h"

#include "halve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A voxel of the target spans this many voxels of the source at most; so many points along an edge
   are looked at. */
enum { SPAN_MAX = 4 };

/* Points with less than this part of their weight on active voxels are off the source. */
static const double LEAST_WEIGHT = 1e-6;

/* Indices beyond this are nowhere. */
static const double INDEX_MAX = 1 << 30;

/* source index = matrix * target index + shift. */
typedef struct mapping {
    double matrix[3][3], shift[3];
} mapping;

typedef struct resampling {
    murk_context *context;
    murk_bricks source; /* the given one or, once halved, an own one; shared until then */
    bool halved;
    bool fill; /* the background counts */
    mapping map;
    int points[3]; /* along the edges of a target voxel */
} resampling;

static mapping find_mapping(const double source[16], const double target[16], double centre)
{
    mapping map = {0};
    for (int row = 0; row < 3; row++) {
        double length2 = 0;
        for (int c = 0; c < 3; c++)
            length2 += source[4 * c + row] * source[4 * c + row];
        for (int c = 0; c < 3; c++) { /* the axes stand at right angles */
            double inverse = source[4 * c + row] / length2;
            for (int a = 0; a < 3; a++)
                map.matrix[row][a] += inverse * target[4 * c + a];
            map.shift[row] += inverse * (target[4 * c + 3] - source[4 * c + 3]);
        }
        /* Centres of voxels are at integers from here on. */
        map.shift[row] += centre * (map.matrix[row][0] + map.matrix[row][1] + map.matrix[row][2]);
        map.shift[row] -= centre;
    }
    return map;
}

/* Whether a target voxel spans more than SPAN_MAX source voxels along any axis of the source. */
static bool find_long_axes(const mapping *map, bool axes[3])
{
    for (int row = 0; row < 3; row++) {
        axes[row] = false;
        for (int a = 0; a < 3; a++)
            axes[row] |= fabs(map->matrix[row][a]) > SPAN_MAX + 1e-6;
    }
    return axes[0] || axes[1] || axes[2];
}

static murk_status halve_long_axes(resampling *r)
{
    bool axes[3];
    while (find_long_axes(&r->map, axes)) {
        murk_bricks halved;
        murk_status status = murk_bricks_halve(r->context, &r->source, axes, r->fill, &halved);
        if (status)
            return status;
        if (r->halved)
            murk_bricks_clear(&r->source);
        r->source = halved;
        r->halved = true;
        for (int row = 0; row < 3; row++) {
            if (!axes[row])
                continue;
            for (int a = 0; a < 3; a++)
                r->map.matrix[row][a] /= 2;
            r->map.shift[row] = (r->map.shift[row] + 0.5) / 2 - 0.5;
        }
    }
    return MURK_OK;
}

static void find_points(resampling *r)
{
    for (int a = 0; a < 3; a++) {
        double span = 0;
        for (int row = 0; row < 3; row++)
            span = fmax(span, fabs(r->map.matrix[row][a]));
        r->points[a] = (int)fmax(1, ceil(span - 1e-6));
    }
}

/* ---- points -------------------------------------------------------------------------------- */

/* Bricks that were found, by the low bits of their places. */
enum { CACHE_EDGE = 4, CACHE_SLOTS = CACHE_EDGE * CACHE_EDGE * CACHE_EDGE };
typedef struct cache {
    struct {
        int32_t place[3];
        bool known;
        int64_t brick; /* -1: there is none */
    } slot[CACHE_SLOTS];
} cache;

static int64_t find_brick(const murk_bricks *source, cache *found, const int32_t place[3])
{
    const int mask = CACHE_EDGE - 1;
    int n = ((place[0] & mask) * CACHE_EDGE + (place[1] & mask)) * CACHE_EDGE + (place[2] & mask);
    if (found->slot[n].known && !memcmp(found->slot[n].place, place, sizeof found->slot[n].place))
        return found->slot[n].brick;
    const int32_t(*at)[3] =
        bsearch(place, source->brick, source->count, sizeof *source->brick, murk_brick_compare);
    memcpy(found->slot[n].place, place, sizeof found->slot[n].place);
    found->slot[n].known = true;
    found->slot[n].brick = at ? at - (const int32_t(*)[3])source->brick : -1;
    return found->slot[n].brick;
}

/* Weighted sums over voxels: of the values, and of the weights of active ones. */
typedef struct sums {
    double value, weight;
} sums;

static void add_voxel(const resampling *r, cache *found, const int32_t at[3], double weight,
                      sums *to)
{
    const int32_t place[3] = {at[0] >> 3, at[1] >> 3, at[2] >> 3};
    int64_t brick = find_brick(&r->source, found, place);
    int slot = (at[0] & 7) << 6 | (at[1] & 7) << 3 | (at[2] & 7);
    if (brick >= 0 && (r->source.mask[brick][slot >> 6] >> (slot & 63) & 1)) {
        to->value += weight * r->source.values[brick * MURK_BRICK_SLOTS + slot];
        to->weight += weight;
    } else if (r->fill) {
        to->value += weight * r->source.background;
    }
}

/* The trilinear interpolant at a place in the source's index space. */
static void add_point(const resampling *r, cache *found, const double place[3], sums *to)
{
    int32_t low[3];
    double part[3];
    for (int a = 0; a < 3; a++) {
        double base = floor(place[a]);
        if (!(fabs(base) < INDEX_MAX)) {
            to->value += r->fill ? r->source.background : 0;
            return;
        }
        low[a] = (int32_t)base;
        part[a] = place[a] - base;
    }
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        int32_t at[3];
        for (int a = 0; a < 3; a++) {
            int high = corner >> a & 1;
            at[a] = low[a] + high;
            weight *= high ? part[a] : 1 - part[a];
        }
        if (weight > 0)
            add_voxel(r, found, at, weight, to);
    }
}

/* The sums over the points of a target voxel. */
static sums sum_voxel(const resampling *r, cache *found, const double voxel[3])
{
    const int *n = r->points;
    sums all = {0};
    for (int i = 0; i < n[0] * n[1] * n[2]; i++) {
        const int step[3] = {i / (n[1] * n[2]), i / n[2] % n[1], i % n[2]};
        double target[3], place[3];
        for (int a = 0; a < 3; a++)
            target[a] = voxel[a] + (step[a] + 0.5) / n[a] - 0.5;
        for (int row = 0; row < 3; row++) {
            const double *m = r->map.matrix[row];
            place[row] = m[0] * target[0] + m[1] * target[1] + m[2] * target[2] + r->map.shift[row];
        }
        add_point(r, found, place, &all);
    }
    return all;
}

/* Gives the number of voxels that the source covers. */
static uint64_t fill_brick(const resampling *r, cache *found, murk_bricks *out, size_t b)
{
    const double points = r->points[0] * r->points[1] * r->points[2];
    uint64_t covered = 0;
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        if (!(out->mask[b][slot >> 6] >> (slot & 63) & 1))
            continue;
        const double voxel[3] = {8.0 * out->brick[b][0] + (slot >> 6),
                                 8.0 * out->brick[b][1] + (slot >> 3 & 7),
                                 8.0 * out->brick[b][2] + (slot & 7)};
        sums all = sum_voxel(r, found, voxel);
        bool near = all.weight > LEAST_WEIGHT * points;
        double value = r->fill ? all.value / points
                       : near  ? all.value / all.weight
                               : out->background;
        out->values[b * MURK_BRICK_SLOTS + (size_t)slot] = (float)value;
        covered += near;
    }
    return covered;
}

/* ---- all of it ----------------------------------------------------------------------------- */

/* Makes voxels inactive that are NaN or infinite; gives their number. */
static uint64_t drop_invalid(murk_bricks *source)
{
    uint64_t count = 0;
    for (size_t b = 0; b < source->count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            uint64_t bit = (uint64_t)1 << (slot & 63);
            float value = source->values[b * MURK_BRICK_SLOTS + (size_t)slot];
            if (!(source->mask[b][slot >> 6] & bit) || isfinite(value))
                continue;
            source->mask[b][slot >> 6] &= ~bit;
            count++;
        }
    return count;
}

static murk_status create_bricks(murk_context *context, const murk_bricks *target, float background,
                                 murk_bricks *out)
{
    *out = (murk_bricks){.count = target->count,
                         .brick = murk_alloc(target->count, sizeof *out->brick),
                         .mask = murk_alloc(target->count, sizeof *out->mask),
                         .values = murk_alloc(target->count * MURK_BRICK_SLOTS, sizeof(float)),
                         .background = background};
    if (!out->brick || !out->mask || !out->values) {
        murk_bricks_clear(out);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu bricks", target->count);
    }
    memcpy(out->brick, target->brick, target->count * sizeof *out->brick);
    memcpy(out->mask, target->mask, target->count * sizeof *out->mask);
    memcpy(out->index_to_world, target->index_to_world, sizeof out->index_to_world);
    return MURK_OK;
}

murk_status murk_resample(murk_context *context, murk_bricks *source, const murk_bricks *target,
                          const murk_resample_options *options, murk_bricks *out,
                          murk_resample_report *report)
{
    murk_bricks made = {0};
    uint64_t covered = 0, invalid = drop_invalid(source);
    resampling r = {.context = context,
                    .source = *source,
                    .fill = options->absence == MURK_ABSENT_IS_BACKGROUND,
                    .map = find_mapping(source->index_to_world, target->index_to_world,
                                        options->corner ? 0.5 : 0)};
    murk_status status = halve_long_axes(&r);
    if (!status)
        status = create_bricks(context, target, source->background, &made);
    if (!status) {
        find_points(&r);
#pragma omp parallel num_threads(context->threads) reduction(+ : covered)
        {
            cache found = {0};
#pragma omp for schedule(dynamic, 16)
            for (size_t b = 0; b < made.count; b++)
                covered += fill_brick(&r, &found, &made, b);
        }
        *out = made;
        *report = (murk_resample_report){.covered = covered, .invalid = invalid};
    }
    if (r.halved)
        murk_bricks_clear(&r.source);
    return status;
}
