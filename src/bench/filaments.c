/* SPDX-License-Identifier: Apache-2.0 */
/* Thin curves through a large empty box. */
#include "cases.h"
#include "noise.h"

#include <math.h>

enum { EDGE = 1000, CURVE = 1000 }; /* voxels: of the box, along a curve */
static const double RADIUS = 1.5;   /* of a curve, in voxels */
static const double BEND = 0.1;     /* change of direction in a step of one voxel */
static const double DEPTH_OF_A_VOXEL = 0.3;

/* Fills a ball; *left is how many voxels are still wanted. */
static bool fill_ball(const double centre[3], double *left, struct bench_voxels *out)
{
    int32_t lo[3], hi[3];
    for (int a = 0; a < 3; a++) {
        lo[a] = (int32_t)fmax(0, floor(centre[a] - RADIUS));
        hi[a] = (int32_t)fmin(EDGE - 1, floor(centre[a] + RADIUS));
    }
    for (int32_t i = lo[0]; i <= hi[0]; i++)
        for (int32_t j = lo[1]; j <= hi[1]; j++)
            for (int32_t k = lo[2]; k <= hi[2]; k++) {
                double x = i + 0.5 - centre[0], y = j + 0.5 - centre[1], z = k + 0.5 - centre[2];
                if (x * x + y * y + z * z > RADIUS * RADIUS || *left < 1)
                    continue;
                float *value = bench_voxels_at(out, i, j, k);
                if (!value)
                    return false;
                if (*value == 0)
                    *left -= 1;
                *value = (float)(DEPTH_OF_A_VOXEL / out->voxel_size[0]);
            }
    return true;
}

static void make_unit(double direction[3])
{
    double length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                         direction[2] * direction[2]);
    for (int a = 0; a < 3; a++)
        direction[a] /= length;
}

/* One curve, which turns back at the walls. */
static bool draw_curve(uint64_t *random, double *left, struct bench_voxels *out)
{
    double at[3], direction[3];
    for (int a = 0; a < 3; a++) {
        at[a] = EDGE * bench_random(random);
        direction[a] = bench_random(random) - 0.5;
    }
    make_unit(direction);
    for (int step = 0; step < CURVE && *left >= 1; step++) {
        if (!fill_ball(at, left, out))
            return false;
        for (int a = 0; a < 3; a++) {
            direction[a] += BEND * (2 * bench_random(random) - 1);
            if (at[a] + direction[a] < 0 || at[a] + direction[a] > EDGE)
                direction[a] = -direction[a];
        }
        make_unit(direction);
        for (int a = 0; a < 3; a++)
            at[a] += direction[a];
    }
    return true;
}

bool bench_make_filaments(double count, struct bench_voxels *out)
{
    uint64_t random = 1991;
    double left = count;
    for (int a = 0; a < 3; a++)
        out->voxel_size[a] = 1.0 / EDGE;
    out->albedo = BENCH_ALBEDO;
    while (left >= 1)
        if (!draw_curve(&random, &left, out))
            return false;
    return true;
}
