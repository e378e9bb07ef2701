/* SPDX-License-Identifier: Apache-2.0 */
#include "stress_media.h"

/* ---- media --------------------------------------------------------------------------------- */

/* Adds a box of uniform voxels, `tau` the optical depth of one along x; a tenth of them glow. */
static void add_box(struct stress_scene *scene, const int32_t lo[3], const int32_t size[3],
                    double tau, double albedo)
{
    size_t count = (size_t)size[0] * (size_t)size[1] * (size_t)size[2];
    uint64_t random = 31;
    scene->voxel = realloc(scene->voxel, (scene->count + count) * sizeof *scene->voxel);
    if (!scene->voxel)
        abort();
    for (int32_t i = 0; i < size[0]; i++)
        for (int32_t j = 0; j < size[1]; j++)
            for (int32_t k = 0; k < size[2]; k++)
                scene->voxel[scene->count++] =
                    (struct stress_voxel){.at = {lo[0] + i, lo[1] + j, lo[2] + k},
                                          .kappa_t = (float)(tau / scene->size[0]),
                                          .albedo = (float)albedo,
                                          .emission = (float)(check_random(&random) < 0.1)};
}

static void box(struct stress_scene *scene, int32_t nx, int32_t ny, int32_t nz, double tau,
                double albedo)
{
    add_box(scene, (const int32_t[3]){0}, (const int32_t[3]){nx, ny, nz}, tau, albedo);
}

/* Keeps the voxels that `keep` is true for. */
static void sieve(struct stress_scene *scene, bool (*keep)(const struct stress_voxel *))
{
    size_t kept = 0;
    for (size_t n = 0; n < scene->count; n++)
        if (keep(&scene->voxel[n]))
            scene->voxel[kept++] = scene->voxel[n];
    scene->count = kept;
}

void stress_porous(struct stress_scene *scene, double tau)
{
    uint64_t random = 32;
    size_t kept = 0;
    box(scene, 12, 11, 10, tau, 0.95);
    for (size_t n = 0; n < scene->count; n++) {
        double x = 1.5 * check_random(&random) - 0.5;
        if (x <= 0 && n && n + 1 < scene->count) /* corners stay */
            continue;
        scene->voxel[kept] = scene->voxel[n];
        scene->voxel[kept++].kappa_t *= (float)fmax(x, 0.1);
    }
    scene->count = kept;
}

void stress_of_albedo(struct stress_scene *scene, double albedo)
{
    box(scene, 8, 7, 6, 0.1, albedo);
}

void stress_of_any_albedo(struct stress_scene *scene, double tau)
{
    uint64_t random = 33;
    stress_porous(scene, tau);
    for (size_t n = 0; n < scene->count; n++) {
        double r = check_random(&random);
        scene->voxel[n].albedo = r < 0.2 ? 0 : r > 0.8 ? 1 : (float)r;
    }
}

void stress_thin(struct stress_scene *scene, double tau)
{
    box(scene, 8, 7, 6, tau, 0.95);
}

void stress_thick(struct stress_scene *scene, double tau)
{
    box(scene, 12, 11, 10, tau, 1 - 1e-6);
}

void stress_large(struct stress_scene *scene, double tau)
{
    box(scene, 32, 32, 32, tau, 0.95);
}

static bool is_even(const struct stress_voxel *v)
{
    return !((v->at[0] + v->at[1] + v->at[2]) & 1);
}

static bool in_even_brick(const struct stress_voxel *v)
{
    return !(((v->at[0] >> 3) + (v->at[1] >> 3) + (v->at[2] >> 3)) & 1);
}

static bool on_diagonal(const struct stress_voxel *v)
{
    return v->at[0] == v->at[1] && v->at[1] == v->at[2];
}

void stress_neighbours(struct stress_scene *scene, double tau)
{
    box(scene, 12, 11, 10, tau, 0.99);
    for (size_t n = 0; n < scene->count; n++)
        if (!is_even(&scene->voxel[n]))
            scene->voxel[n].kappa_t *= 1e-6f;
}

void stress_wild(struct stress_scene *scene, double tau)
{
    uint64_t random = 34;
    box(scene, 12, 11, 10, tau, 0.99);
    for (size_t n = 0; n < scene->count; n++)
        scene->voxel[n].kappa_t *= (float)pow(10, -6 * check_random(&random));
}

void stress_voxel_checkers(struct stress_scene *scene, double tau)
{
    box(scene, 12, 12, 12, tau, 0.99);
    sieve(scene, is_even);
}

void stress_brick_checkers(struct stress_scene *scene, double tau)
{
    box(scene, 24, 24, 24, tau, 0.99);
    sieve(scene, in_even_brick);
}

void stress_diagonal(struct stress_scene *scene, double tau)
{
    box(scene, 24, 24, 24, tau, 0.99);
    sieve(scene, on_diagonal);
}

void stress_single(struct stress_scene *scene, double tau)
{
    box(scene, 1, 1, 1, tau, 0.95);
    scene->voxel->emission = 1;
}

void stress_sheet(struct stress_scene *scene, double axis)
{
    int32_t size[3] = {16, 16, 16};
    size[(int)axis] = 1;
    box(scene, size[0], size[1], size[2], 1, 0.99);
}

void stress_clouds(struct stress_scene *scene, double distance)
{
    const int32_t size[3] = {6, 6, 6}, d = (int32_t)distance;
    add_box(scene, (const int32_t[3]){0, 0, 0}, size, 0.5, 0.99);
    add_box(scene, (const int32_t[3]){d, 3, 1}, size, 0.5, 0.99);
}

void stress_stretched(struct stress_scene *scene, double ratio)
{
    scene->size[2] *= ratio;
    stress_porous(scene, ratio > 1 ? 1 / ratio : 1);
}

void stress_of_size(struct stress_scene *scene, double metres)
{
    for (int a = 0; a < 3; a++)
        scene->size[a] = metres;
    stress_porous(scene, 0.6);
}
