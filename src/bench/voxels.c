/* SPDX-License-Identifier: Apache-2.0 */
#include "voxels.h"

#include <stdlib.h>
#include <string.h>

void bench_voxels_release(struct bench_voxels *voxels)
{
    free(voxels->brick);
    free(voxels->kappa_t);
    free(voxels->bucket);
    memset(voxels, 0, sizeof *voxels);
}

/* ---- bricks -------------------------------------------------------------------------------- */

static size_t hash(int32_t x, int32_t y, int32_t z)
{
    uint64_t h = (uint64_t)(uint32_t)x * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ (uint32_t)y) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 31) ^ (uint32_t)z) * 0x94D049BB133111EBu;
    return (size_t)(h ^ (h >> 30));
}

/* The bucket that holds a brick, or the free one where it belongs. */
static size_t *find(const struct bench_voxels *voxels, int32_t x, int32_t y, int32_t z)
{
    size_t mask = voxels->bucket_count - 1;
    for (size_t i = hash(x, y, z) & mask;; i = (i + 1) & mask) {
        if (!voxels->bucket[i])
            return &voxels->bucket[i];
        const int32_t *at = voxels->brick + 3 * (voxels->bucket[i] - 1);
        if (at[0] == x && at[1] == y && at[2] == z)
            return &voxels->bucket[i];
    }
}

/* A hash table of this many buckets (a power of two) for the bricks there are. */
static bool fill_buckets(struct bench_voxels *voxels, size_t buckets)
{
    size_t *bucket = calloc(buckets, sizeof *bucket);
    if (!bucket)
        return false;
    free(voxels->bucket);
    voxels->bucket = bucket;
    voxels->bucket_count = buckets;
    for (size_t b = 0; b < voxels->count; b++) {
        const int32_t *at = voxels->brick + 3 * b;
        *find(voxels, at[0], at[1], at[2]) = b + 1;
    }
    return true;
}

static bool grow(struct bench_voxels *voxels)
{
    size_t capacity = voxels->capacity ? 2 * voxels->capacity : 64;
    int32_t *brick = realloc(voxels->brick, capacity * 3 * sizeof *brick);
    if (brick)
        voxels->brick = brick;
    float *kappa_t = realloc(voxels->kappa_t, capacity * BENCH_SLOTS * sizeof *kappa_t);
    if (kappa_t)
        voxels->kappa_t = kappa_t;
    if (!brick || !kappa_t || !fill_buckets(voxels, 2 * capacity))
        return false;
    voxels->capacity = capacity;
    return true;
}

float *bench_voxels_brick(struct bench_voxels *voxels, int32_t x, int32_t y, int32_t z)
{
    if (voxels->count == voxels->capacity && !grow(voxels))
        return NULL;
    size_t *bucket = find(voxels, x, y, z);
    if (!*bucket) {
        int32_t *at = voxels->brick + 3 * voxels->count;
        at[0] = x;
        at[1] = y;
        at[2] = z;
        memset(voxels->kappa_t + voxels->count * BENCH_SLOTS, 0,
               BENCH_SLOTS * sizeof *voxels->kappa_t);
        *bucket = ++voxels->count;
    }
    return voxels->kappa_t + (*bucket - 1) * BENCH_SLOTS;
}

float *bench_voxels_at(struct bench_voxels *voxels, int32_t i, int32_t j, int32_t k)
{
    float *brick = bench_voxels_brick(voxels, i >> 3, j >> 3, k >> 3);
    return brick ? brick + 64 * (i & 7) + 8 * (j & 7) + (k & 7) : NULL;
}

/* ---- all voxels ---------------------------------------------------------------------------- */

size_t bench_voxels_active(const struct bench_voxels *voxels)
{
    size_t active = 0;
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++)
        active += voxels->kappa_t[i] != 0;
    return active;
}

void bench_voxels_index(const struct bench_voxels *voxels, size_t i, int32_t index[3])
{
    const int32_t *at = voxels->brick + 3 * (i / BENCH_SLOTS);
    index[0] = at[0] * BENCH_EDGE + (int32_t)(i >> 6 & 7);
    index[1] = at[1] * BENCH_EDGE + (int32_t)(i >> 3 & 7);
    index[2] = at[2] * BENCH_EDGE + (int32_t)(i & 7);
}

void bench_voxels_box(const struct bench_voxels *voxels, int32_t lo[3], int32_t hi[3])
{
    for (int a = 0; a < 3; a++) {
        lo[a] = INT32_MAX;
        hi[a] = INT32_MIN;
    }
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++) {
        int32_t index[3];
        if (voxels->kappa_t[i] == 0)
            continue;
        bench_voxels_index(voxels, i, index);
        for (int a = 0; a < 3; a++) {
            lo[a] = index[a] < lo[a] ? index[a] : lo[a];
            hi[a] = index[a] >= hi[a] ? index[a] + 1 : hi[a];
        }
    }
}

/* The value that `count` of them are above, nearly. */
static float threshold(const struct bench_voxels *voxels, size_t count)
{
    enum { BINS = 1 << 16 };
    size_t bins[BINS + 1] = {0};
    size_t total = voxels->count * BENCH_SLOTS, above = 0;
    float lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < total; i++) {
        lo = fminf(lo, voxels->kappa_t[i]);
        hi = fmaxf(hi, voxels->kappa_t[i]);
    }
    float scale = BINS / (hi - lo);
    for (size_t i = 0; i < total; i++)
        bins[(size_t)(scale * (voxels->kappa_t[i] - lo))]++;
    int bin = BINS;
    while (bin > 0 && above + bins[bin] <= count)
        above += bins[bin--];
    return lo + ((float)bin + 1) / scale;
}

bool bench_voxels_keep(struct bench_voxels *voxels, size_t count, double rim)
{
    float limit = threshold(voxels, count);
    size_t kept = 0;
    for (size_t b = 0; b < voxels->count; b++) {
        const float *from = voxels->kappa_t + b * BENCH_SLOTS;
        float *to = voxels->kappa_t + kept * BENCH_SLOTS;
        bool any = false;
        for (int slot = 0; slot < BENCH_SLOTS; slot++) {
            bool inside = from[slot] >= limit;
            to[slot] = inside ? from[slot] - limit + (float)rim : 0;
            any |= inside;
        }
        if (any)
            memmove(voxels->brick + 3 * kept++, voxels->brick + 3 * b, 3 * sizeof *voxels->brick);
    }
    voxels->count = kept;
    return fill_buckets(voxels, voxels->bucket_count);
}

bool bench_voxels_set_depth(struct bench_voxels *voxels, int axis, double depth)
{
    int32_t lo[3], hi[3], index[3];
    bench_voxels_box(voxels, lo, hi);
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    size_t width = (size_t)(hi[u] - lo[u]);
    double *column = calloc(width * (size_t)(hi[v] - lo[v]), sizeof *column), deepest = 0;
    if (!column)
        return false;
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++) {
        if (voxels->kappa_t[i] == 0)
            continue;
        bench_voxels_index(voxels, i, index);
        double *sum = &column[(size_t)(index[v] - lo[v]) * width + (size_t)(index[u] - lo[u])];
        *sum += voxels->kappa_t[i] * voxels->voxel_size[axis];
        deepest = fmax(deepest, *sum);
    }
    free(column);
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++)
        voxels->kappa_t[i] *= (float)(depth / deepest);
    return true;
}

bool bench_voxels_widen(struct bench_voxels *voxels)
{
    int32_t lo[3], hi[3];
    float most = 0;
    bench_voxels_box(voxels, lo, hi);
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++)
        most = fmaxf(most, voxels->kappa_t[i]);
    for (int a = 0; a < 3; a++) {
        int32_t size = hi[a] - lo[a], below = a < 2 ? size / 2 : 0;
        lo[a] -= below;
        hi[a] += size - below;
    }
    for (int n = 0; n < 16; n++) {
        int32_t index[3];
        for (int a = 0; a < 3; a++)
            index[a] = (n < 8 ? lo[a] : hi[a] - 2) + (n >> a & 1);
        float *value = bench_voxels_at(voxels, index[0], index[1], index[2]);
        if (!value)
            return false;
        *value = most;
    }
    return true;
}

murk_status bench_voxels_medium(murk_context *context, const struct bench_voxels *voxels,
                                murk_medium **out)
{
    murk_brick_array bricks = {.count = voxels->count,
                               .brick = voxels->brick,
                               .kappa_t = voxels->kappa_t,
                               .albedo_value = voxels->albedo};
    memcpy(bricks.voxel_size, voxels->voxel_size, sizeof bricks.voxel_size);
    return murk_medium_from_bricks(context, &bricks, out);
}
