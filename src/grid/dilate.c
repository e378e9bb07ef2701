/* SPDX-License-Identifier: Apache-2.0 */
#include "grid.h"

#include <stdlib.h>
#include <string.h>

/* The active voxels of a brick and its 26 neighbours as bits, one z-column of 24 a word. */
typedef struct block {
    uint32_t column[24][24];
} block;

static void load_block(const murk_grid *grid, const int32_t c[3], block *out)
{
    memset(out, 0, sizeof *out);
    for (int bx = 0; bx < 3; bx++)
        for (int by = 0; by < 3; by++)
            for (int bz = 0; bz < 3; bz++) {
                int32_t b = murk_grid_find(grid, c[0] + bx - 1, c[1] + by - 1, c[2] + bz - 1);
                if (b == MURK_NO_BRICK)
                    continue;
                for (int x = 0; x < 8; x++)
                    for (int y = 0; y < 8; y++) {
                        uint32_t bits = (uint8_t)(grid->mask[b][x] >> 8 * y);
                        out->column[8 * bx + x][8 * by + y] |= bits << 8 * bz;
                    }
            }
}

/* Dilates the middle brick: along z by shifts, then along y and x by ors. */
static void dilate_block(const block *in, int margin, uint64_t mask[8])
{
    uint32_t along_z[24][24], along_y[24][8];
    for (int x = 0; x < 24; x++)
        for (int y = 0; y < 24; y++) {
            uint32_t bits = in->column[x][y], sum = bits;
            for (int m = 1; m <= margin; m++)
                sum |= bits << m | bits >> m;
            along_z[x][y] = sum;
        }
    for (int x = 0; x < 24; x++)
        for (int y = 0; y < 8; y++) {
            along_y[x][y] = 0;
            for (int m = -margin; m <= margin; m++)
                along_y[x][y] |= along_z[x][8 + y + m];
        }
    for (int x = 0; x < 8; x++) {
        mask[x] = 0;
        for (int y = 0; y < 8; y++) {
            uint32_t bits = 0;
            for (int m = -margin; m <= margin; m++)
                bits |= along_y[8 + x + m][y];
            mask[x] |= (uint64_t)(uint8_t)(bits >> 8) << 8 * y;
        }
    }
}

/* Which of the 26 neighbours voxels of this brick can reach within margin. */
static bool reaches(const uint64_t mask[8], int margin, int dx, int dy, int dz)
{
    uint64_t yz = 0;
    int x0 = dx > 0 ? 8 - margin : 0, x1 = dx < 0 ? margin : 8;
    for (int x = x0; x < x1; x++)
        yz |= mask[x];
    int y0 = dy > 0 ? 8 - margin : 0, y1 = dy < 0 ? margin : 8;
    uint8_t z = 0;
    for (int y = y0; y < y1; y++)
        z |= (uint8_t)(yz >> 8 * y);
    uint8_t zs = (uint8_t)(dz > 0 ? 0xFFu << (8 - margin) : dz < 0 ? 0xFFu >> (8 - margin) : 0xFFu);
    return z & zs;
}

murk_status murk_grid_dilate(murk_context *context, const murk_grid *grid, int margin,
                             murk_grid **out)
{
    size_t capacity = 0, count = 0;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int n = 0; n < 27; n++)
            capacity += reaches(grid->mask[b], margin, n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1);

    murk_bricks bricks = {.brick = murk_alloc(capacity, sizeof *bricks.brick)};
    if (!bricks.brick)
        goto failed;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int n = 0; n < 27; n++) {
            int d[3] = {n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
            if (!reaches(grid->mask[b], margin, d[0], d[1], d[2]))
                continue;
            for (int a = 0; a < 3; a++)
                bricks.brick[count][a] = grid->brick[b][a] + d[a];
            count++;
        }
    qsort(bricks.brick, count, sizeof *bricks.brick, murk_brick_compare);
    for (size_t i = 0; i < count; i++)
        if (!i || murk_brick_compare(bricks.brick[i], bricks.brick[bricks.count - 1]))
            memmove(bricks.brick[bricks.count++], bricks.brick[i], sizeof *bricks.brick);

    bricks.mask = murk_alloc(bricks.count, sizeof *bricks.mask);
    if (!bricks.mask)
        goto failed;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t i = 0; i < bricks.count; i++) {
        block around;
        load_block(grid, bricks.brick[i], &around);
        dilate_block(&around, margin, bricks.mask[i]);
    }
    /* The same transform, as the matrix that murk_grid_create() takes apart again. */
    for (int c = 0; c < 3; c++) {
        bricks.index_to_world[4 * c + 3] = grid->corner[c];
        for (int a = 0; a < 3; a++) {
            bricks.index_to_world[4 * c + a] = grid->axis[a][c] * grid->voxel[a];
            bricks.index_to_world[4 * c + 3] -= bricks.index_to_world[4 * c + a] * grid->lo[a];
        }
    }
    bricks.index_to_world[15] = 1;
    murk_status status = murk_grid_create(context, &bricks, true, out);
    murk_bricks_clear(&bricks);
    return status;
failed:
    murk_bricks_clear(&bricks);
    return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the margin around the medium");
}
