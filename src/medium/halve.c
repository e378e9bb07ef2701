/* SPDX-License-Identifier: Apache-2.0 */
#include "halve.h"

#include <stdlib.h>
#include <string.h>

/* The bricks that hold the halved ones, each once and in order. */
static size_t list_bricks(const murk_bricks *bricks, const bool axes[3], int32_t (*list)[3])
{
    size_t count = 0;
    for (size_t b = 0; b < bricks->count; b++)
        for (int a = 0; a < 3; a++)
            list[b][a] = axes[a] ? bricks->brick[b][a] >> 1 : bricks->brick[b][a];
    qsort(list, bricks->count, sizeof *list, murk_brick_compare);
    for (size_t b = 0; b < bricks->count; b++)
        if (!b || murk_brick_compare(list[b], list[b - 1]))
            memmove(list[count++], list[b], sizeof *list);
    return count;
}

/* Slot of a brick's voxel in the brick that holds its half. */
static int find_slot(const int32_t brick[3], const bool axes[3], int slot)
{
    const int at[3] = {slot >> 6, slot >> 3 & 7, slot & 7};
    int to = 0;
    for (int a = 0; a < 3; a++)
        to = to << 3 | (axes[a] ? (8 * (brick[a] & 1) + at[a]) >> 1 : at[a]);
    return to;
}

static void add_brick(const murk_bricks *from, size_t b, const bool axes[3], float *sum,
                      uint8_t *count)
{
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        if (!(from->mask[b][slot >> 6] >> (slot & 63) & 1))
            continue;
        int to = find_slot(from->brick[b], axes, slot);
        sum[to] += from->values[b * MURK_BRICK_SLOTS + (size_t)slot];
        count[to]++;
    }
}

/* Turns the sums of a brick into means. */
static void divide(murk_bricks *to, size_t b, int whole, bool fill, const uint8_t *count)
{
    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
        float *value = &to->values[b * MURK_BRICK_SLOTS + (size_t)slot];
        int n = count[b * MURK_BRICK_SLOTS + (size_t)slot];
        if (!n)
            continue;
        *value = fill ? (*value + (float)(whole - n) * to->background) / (float)whole
                      : *value / (float)n;
        to->mask[b][slot >> 6] |= (uint64_t)1 << (slot & 63);
    }
}

murk_status murk_bricks_halve(murk_context *context, const murk_bricks *bricks, const bool axes[3],
                              bool fill, murk_bricks *out)
{
    const size_t all = bricks->count;
    murk_bricks halved = {.background = bricks->background,
                          .brick = murk_alloc(all, sizeof *halved.brick)};
    if (halved.brick)
        halved.count = list_bricks(bricks, axes, halved.brick);
    halved.mask = murk_alloc(halved.count, sizeof *halved.mask);
    halved.values = murk_alloc(halved.count * MURK_BRICK_SLOTS, sizeof *halved.values);
    uint8_t *count = murk_alloc(halved.count * MURK_BRICK_SLOTS, sizeof *count);
    if (!halved.brick || !halved.mask || !halved.values || !count) {
        murk_free(count);
        murk_bricks_clear(&halved);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu bricks", all);
    }
    for (size_t b = 0; b < all; b++) {
        int32_t key[3];
        for (int a = 0; a < 3; a++)
            key[a] = axes[a] ? bricks->brick[b][a] >> 1 : bricks->brick[b][a];
        const int32_t(*found)[3] =
            bsearch(key, halved.brick, halved.count, sizeof key, murk_brick_compare);
        size_t to = (size_t)(found - (const int32_t(*)[3])halved.brick) * MURK_BRICK_SLOTS;
        add_brick(bricks, b, axes, halved.values + to, count + to);
    }
    for (size_t b = 0; b < halved.count; b++)
        divide(&halved, b, 1 << (axes[0] + axes[1] + axes[2]), fill, count);
    murk_free(count);
    *out = halved;
    return MURK_OK;
}
