/* SPDX-License-Identifier: Apache-2.0 */
/* The cases by name, and those that are boxes. */
#include "cases.h"

#include <math.h>

#define CASE_LIST(X)                                                                               \
    X("cloud", bench_make_cloud)                                                                   \
    X("box", bench_make_box)                                                                       \
    X("plume", bench_make_plume)                                                                   \
    X("checkerboard", bench_make_checkers)                                                         \
    X("filaments", bench_make_filaments)

#define CASE_ROW(name, make)  {name, make, bench_scene_default},
#define CASE_NAME(name, make) name,
const struct bench_case BENCH_CASES[] = {
    CASE_LIST(CASE_ROW){"figure 1", bench_make_figure_1, bench_scene_paper},
    {"100x100x10", bench_make_paper_large, bench_scene_paper},
};
const char *const BENCH_CASE_NAMES[BENCH_CASE_COUNT + 1] = {CASE_LIST(CASE_NAME) NULL};

static const double DEPTH = 8;
static const double PAPER_KAPPA_T = 0.8, PAPER_ALBEDO = 0.5 / 0.8;

/* Sizes of a box of about `count` cells, nearly a cube. */
static void box_size(double count, int32_t size[3])
{
    size[0] = size[1] = (int32_t)fmax(1, round(cbrt(count)));
    size[2] = (int32_t)fmax(1, round(count / ((double)size[0] * size[1])));
}

static void set_scale(struct bench_voxels *voxels, int32_t edge)
{
    for (int a = 0; a < 3; a++)
        voxels->voxel_size[a] = 1.0 / edge;
    voxels->albedo = BENCH_ALBEDO;
}

static bool fill_box(const int32_t size[3], double kappa_t, struct bench_voxels *out)
{
    for (int32_t i = 0; i < size[0]; i++)
        for (int32_t j = 0; j < size[1]; j++)
            for (int32_t k = 0; k < size[2]; k++) {
                float *value = bench_voxels_at(out, i, j, k);
                if (!value)
                    return false;
                *value = (float)kappa_t;
            }
    return true;
}

bool bench_make_box(double count, struct bench_voxels *out)
{
    int32_t size[3];
    box_size(count, size);
    set_scale(out, size[0]);
    return fill_box(size, DEPTH, out);
}

static bool make_paper(const int32_t size[3], double dz, struct bench_voxels *out)
{
    out->voxel_size[0] = out->voxel_size[1] = 0.1;
    out->voxel_size[2] = dz;
    out->albedo = PAPER_ALBEDO;
    return fill_box(size, PAPER_KAPPA_T, out);
}

bool bench_make_figure_1(double count, struct bench_voxels *out)
{
    (void)count;
    return make_paper((const int32_t[3]){10, 10, 10}, 0.05, out);
}

bool bench_make_paper_large(double count, struct bench_voxels *out)
{
    (void)count;
    return make_paper((const int32_t[3]){100, 100, 10}, 0.1, out);
}

bool bench_make_checkers(double count, struct bench_voxels *out)
{
    int32_t size[3];
    double bricks = fmax(1, round(count / BENCH_SLOTS));
    box_size(2 * bricks, size);
    while ((int64_t)size[0] * size[1] * size[2] < 2 * (int64_t)bricks)
        size[2]++;
    set_scale(out, BENCH_EDGE * size[0]);
    for (int32_t z = 0; z < size[2]; z++)
        for (int32_t y = 0; y < size[1]; y++)
            for (int32_t x = 0; x < size[0] && (double)out->count < bricks; x++) {
                if ((x + y + z) % 2)
                    continue;
                float *values = bench_voxels_brick(out, x, y, z);
                if (!values)
                    return false;
                for (int slot = 0; slot < BENCH_SLOTS; slot++)
                    values[slot] = (float)DEPTH;
            }
    return true;
}
