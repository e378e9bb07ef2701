/* SPDX-License-Identifier: Apache-2.0 */
#include "slabs.h"

#include "kernel.h"

#include <stdlib.h>
#include <string.h>

struct key {
    int32_t c[3];
    int32_t index;
};

/* Bit 4 layer + chunk of the 16 voxels of two rows. */
static uint32_t find_chunks(const uint64_t mask[8], int axis)
{
    uint32_t chunks = 0;
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        if (!(mask[slot >> 6] >> (slot & 63) & 1))
            continue;
        const int at[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
        int row = at[axis == 0 ? 1 : 0];
        chunks |= 1u << (MURK_LAYER_CHUNKS * at[axis] + row / 2);
    }
    return chunks;
}

static bool allocate(murk_slabs *slabs, size_t bricks)
{
    slabs->row = murk_alloc(bricks, sizeof *slabs->row);
    slabs->first = murk_alloc(bricks + 1, sizeof *slabs->first);
    slabs->brick = murk_alloc(bricks, sizeof *slabs->brick);
    slabs->mixed = murk_alloc(bricks, sizeof *slabs->mixed);
    slabs->chunks = murk_alloc(bricks, sizeof *slabs->chunks);
    return slabs->row && slabs->first && slabs->brick && slabs->mixed && slabs->chunks;
}

bool murk_slabs_create(murk_slabs *slabs, const murk_grid *grid, int axis)
{
    size_t bricks = grid->brick_count;
    slabs->axis = axis;
    slabs->u = axis == 2 ? 1 : 2;
    slabs->v = axis == 0 ? 1 : 0;
    struct key *keys = murk_alloc(bricks, sizeof *keys);
    if (!keys || !allocate(slabs, bricks)) {
        murk_free(keys);
        return false;
    }
    for (size_t b = 0; b < bricks; b++)
        keys[b] = (struct key){
            {grid->brick[b][axis], grid->brick[b][slabs->u], grid->brick[b][slabs->v]}, (int32_t)b};
    qsort(keys, bricks, sizeof *keys, murk_brick_compare);
    for (size_t i = 0; i < bricks; i++) {
        if (!i || keys[i].c[0] != keys[i - 1].c[0]) {
            slabs->row[slabs->count] = keys[i].c[0];
            slabs->first[slabs->count++] = i;
        }
        slabs->brick[i] = keys[i].index;
        slabs->chunks[i] = find_chunks(grid->mask[keys[i].index], axis);
        keys[i].c[2] = -keys[i].c[2];
        keys[i].index = (int32_t)i;
    }
    slabs->first[slabs->count] = bricks;
    qsort(keys, bricks, sizeof *keys, murk_brick_compare);
    for (size_t i = 0; i < bricks; i++)
        slabs->mixed[i] = keys[i].index;
    for (int s = 0; s < slabs->count; s++) {
        size_t width = slabs->first[s + 1] - slabs->first[s];
        slabs->widest = width > slabs->widest ? width : slabs->widest;
    }
    murk_free(keys);
    return true;
}

void murk_slabs_clear(murk_slabs *slabs)
{
    murk_free(slabs->row);
    murk_free(slabs->first);
    murk_free(slabs->brick);
    murk_free(slabs->mixed);
    murk_free(slabs->chunks);
    memset(slabs, 0, sizeof *slabs);
}

typedef float four __attribute__((vector_size(16)));

/* Transposes the 8 x 8 matrix at `from`, with rows 8 apart, to rows `stride` apart; the baseline of
   every processor has vectors of four. */
static inline void transpose(const float *from, float *to, ptrdiff_t stride)
{
    for (int i = 0; i < 8; i += 4)
        for (int j = 0; j < 8; j += 4) {
            four a, b, c, d;
            memcpy(&a, from + (i + 0) * 8 + j, sizeof a);
            memcpy(&b, from + (i + 1) * 8 + j, sizeof b);
            memcpy(&c, from + (i + 2) * 8 + j, sizeof c);
            memcpy(&d, from + (i + 3) * 8 + j, sizeof d);
            four ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
            four cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
            four ef = __builtin_shufflevector(a, b, 2, 6, 3, 7);
            four gh = __builtin_shufflevector(c, d, 2, 6, 3, 7);
            a = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
            b = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
            c = __builtin_shufflevector(ef, gh, 0, 1, 4, 5);
            d = __builtin_shufflevector(ef, gh, 2, 3, 6, 7);
            memcpy(to + (j + 0) * stride + i, &a, sizeof a);
            memcpy(to + (j + 1) * stride + i, &b, sizeof b);
            memcpy(to + (j + 2) * stride + i, &c, sizeof c);
            memcpy(to + (j + 3) * stride + i, &d, sizeof d);
        }
}

void murk_slabs_layers(int axis, const float *slots, float *layers)
{
    if (axis == 0)
        memcpy(layers, slots, MURK_BRICK_SLOTS * sizeof *layers);
    else if (axis == 1)
        for (int x = 0; x < 8; x++)
            for (int y = 0; y < 8; y++)
                memcpy(layers + y * 64 + x * 8, slots + x * 64 + y * 8, 8 * sizeof *layers);
    else
        for (int x = 0; x < 8; x++) /* y z to z y */
            transpose(slots + x * 64, layers + x * 8, 64);
}

void murk_slabs_add(int axis, const float *layers, float *slots)
{
    if (axis == 0) {
        for (int i = 0; i < MURK_BRICK_SLOTS; i++)
            slots[i] += layers[i];
    } else if (axis == 1) {
        for (int x = 0; x < 8; x++)
            for (int y = 0; y < 8; y++)
                for (int z = 0; z < 8; z++)
                    slots[x * 64 + y * 8 + z] += layers[y * 64 + x * 8 + z];
    } else {
        float rows[64], turned[64];
        for (int x = 0; x < 8; x++) {
            for (int z = 0; z < 8; z++)
                memcpy(rows + 8 * z, layers + z * 64 + x * 8, 8 * sizeof *rows);
            transpose(rows, turned, 8);
            for (int i = 0; i < 64; i++)
                slots[x * 64 + i] += turned[i];
        }
    }
}
