/* SPDX-License-Identifier: Apache-2.0 */
/* Media where a turbulent field in space is above a threshold: cloud and plume. */
#include "cases.h"
#include "noise.h"

#include <math.h>

/* A field over the box [-1, 1] x [-1, 1] x [0, height]. */
struct field {
    double height;
    double filled;     /* part of the box that is active */
    double wavelength; /* of the largest eddies */
    uint32_t seed;
    /* How far inside the medium a point is; noise is the turbulence there. */
    double (*depth)(const double point[3], double noise);
    /* What the extinction at this height is multiplied with. */
    double (*thickness)(double z);
};

/* Amplitude of an octave over that of the one before. */
static const double GAIN = 0.6;
/* Extinction at the rim, where the field is at the threshold. */
static const double RIM = 0.1;

static double cloud_depth(const double point[3], double noise)
{
    double z = 1.3 * (point[2] - 1);
    return 1 - point[0] * point[0] - point[1] * point[1] - z * z + 0.6 * noise;
}

static double cloud_thickness(double z)
{
    (void)z;
    return 1;
}

static double plume_radius(double z)
{
    return 0.2 + 0.1 * z;
}

/* A column that widens and bends as it rises. */
static double plume_depth(const double point[3], double noise)
{
    const double z = point[2], radius = plume_radius(z);
    const double along[3] = {0.5 * z, 0, 0}, across[3] = {0.5 * z, 7, 0};
    double x = point[0] - 0.1 * z * bench_noise(along, 2, GAIN, 31);
    double y = point[1] - 0.1 * z * bench_noise(across, 2, GAIN, 37);
    return 1 - (x * x + y * y) / (radius * radius) + noise;
}

/* The same smoke through ever larger cross-sections. */
static double plume_thickness(double z)
{
    return pow(plume_radius(0) / plume_radius(z), 2);
}

static const struct field CLOUD = {2, 0.2, 0.7, 11, cloud_depth, cloud_thickness};
static const struct field PLUME = {6, 0.1, 0.5, 23, plume_depth, plume_thickness};

static void point_of(const struct bench_voxels *voxels, size_t i, double point[3])
{
    const int32_t *at = voxels->brick + 3 * (i / BENCH_SLOTS);
    const size_t in[3] = {i >> 6 & 7, i >> 3 & 7, i & 7};
    for (int a = 0; a < 3; a++)
        point[a] = (at[a] * BENCH_EDGE + (double)in[a] + 0.5) * voxels->voxel_size[a];
    point[0] -= 1;
    point[1] -= 1;
}

/* The field's depth in whole bricks over the box. */
static bool sample(const struct field *field, struct bench_voxels *out)
{
    double step = out->voxel_size[0], brick = BENCH_EDGE * step;
    int octaves = (int)fmax(1, floor(log2(field->wavelength / step)));
    for (int32_t x = 0; x * brick < 2; x++)
        for (int32_t y = 0; y * brick < 2; y++)
            for (int32_t z = 0; z * brick < field->height; z++)
                if (!bench_voxels_brick(out, x, y, z))
                    return false;
    for (size_t i = 0; i < out->count * BENCH_SLOTS; i++) {
        double point[3], at[3];
        point_of(out, i, point);
        for (int a = 0; a < 3; a++)
            at[a] = point[a] / field->wavelength;
        out->kappa_t[i] = (float)field->depth(point, bench_noise(at, octaves, GAIN, field->seed));
    }
    return true;
}

static bool make(const struct field *field, double count, int axis, double optical_depth,
                 struct bench_voxels *out)
{
    double box = 4 * field->height;
    for (int a = 0; a < 3; a++)
        out->voxel_size[a] = cbrt(field->filled * box / count);
    out->albedo = BENCH_ALBEDO;
    if (!sample(field, out) || !bench_voxels_keep(out, (size_t)count, RIM))
        return false;
    for (size_t i = 0; i < out->count * BENCH_SLOTS; i++) {
        double point[3];
        point_of(out, i, point);
        out->kappa_t[i] *= (float)field->thickness(point[2]);
    }
    return bench_voxels_set_depth(out, axis, optical_depth);
}

bool bench_make_cloud(double count, struct bench_voxels *out)
{
    return make(&CLOUD, count, 2, 10, out);
}

bool bench_make_plume(double count, struct bench_voxels *out)
{
    return make(&PLUME, count, 0, 5, out);
}
