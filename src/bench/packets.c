/* SPDX-License-Identifier: Apache-2.0 */
#include "packets.h"

#include "monte_carlo.h"
#include "seconds.h"

#include <math.h>
#include <stdlib.h>

/* Enough for standard errors. */
enum { BATCHES = 8 };

/* A scene with its own arrays, and what comes out. */
struct job {
    struct bench_mc_scene scene;
    struct bench_mc_result result;
    int32_t lo[3];
    float *zones, *patches; /* what `scene` borrows: three and two arrays */
    double *numbers;        /* what `result` fills */
};

/* Where value i of voxels->kappa_t is in the dense array. */
static size_t zone_of(const struct job *job, const struct bench_voxels *voxels, size_t i)
{
    int32_t index[3];
    size_t zone = 0;
    bench_voxels_index(voxels, i, index);
    for (int a = 0; a < 3; a++)
        zone = zone * (size_t)job->scene.size[a] + (size_t)(index[a] - job->lo[a]);
    return zone;
}

static bool make_zones(struct job *job, const struct bench_voxels *voxels)
{
    struct bench_mc_scene *s = &job->scene;
    int32_t hi[3];
    bench_voxels_box(voxels, job->lo, hi);
    for (int a = 0; a < 3; a++) {
        s->size[a] = hi[a] - job->lo[a];
        s->voxel[a] = voxels->voxel_size[a];
        s->low[a] = job->lo[a] * s->voxel[a];
    }
    size_t count = bench_mc_zones(s);
    float *kappa_t = job->zones = calloc(3 * count, sizeof *job->zones);
    if (!kappa_t)
        return false;
    s->kappa_t = kappa_t;
    s->albedo = kappa_t + count;
    s->emission = kappa_t + 2 * count;
    for (size_t i = 0; i < count; i++)
        kappa_t[count + i] = (float)voxels->albedo;
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++)
        if (voxels->kappa_t[i] != 0)
            kappa_t[zone_of(job, voxels, i)] = voxels->kappa_t[i];
    return true;
}

/* The ground of bench_scene_paper(): under the box, in the plane z = 0. */
static bool make_patches(struct job *job, const murk_ground *ground)
{
    struct bench_mc_scene *s = &job->scene;
    if (!ground)
        return true;
    murk_ground_patches(ground, s->patches);
    for (int c = 0; c < 2; c++) {
        s->ground_low[c] = s->low[c];
        s->ground_high[c] = s->low[c] + s->size[c] * s->voxel[c];
    }
    size_t count = bench_mc_patches(s);
    float *reflectance = job->patches = calloc(2 * count, sizeof *job->patches);
    if (!reflectance)
        return false;
    s->ground_reflectance = reflectance;
    s->ground_emission = reflectance + count;
    for (size_t n = 0; n < count; n++) {
        int column = (int)n % s->patches[0], row = (int)n / s->patches[0];
        reflectance[n] = bench_paper_reflectance(column, row, s->patches[0], s->patches[1]);
    }
    return true;
}

static bool make_results(struct job *job)
{
    size_t zones = bench_mc_zones(&job->scene), patches = bench_mc_patches(&job->scene);
    double *numbers = job->numbers = malloc(2 * (zones + patches) * sizeof *numbers);
    if (!numbers)
        return false;
    job->result = (struct bench_mc_result){
        .zone = numbers,
        .zone_error = numbers + zones,
        .patch = numbers + 2 * zones,
        .patch_error = numbers + 2 * zones + patches,
    };
    return true;
}

static void take_light(struct job *job, const murk_scene *scene)
{
    const double *d = scene->sun.direction;
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (int a = 0; a < 3; a++)
        job->scene.sun[a] = d[a] / length;
    job->scene.irradiance = scene->sun.irradiance;
    job->scene.sky_radiance = scene->sky_radiance;
}

static void take_result(const struct job *job, const struct bench_voxels *voxels,
                        struct bench_packets *out)
{
    double error = 0, size = 0;
    for (size_t i = 0; i < voxels->count * BENCH_SLOTS; i++) {
        double kappa_t = voxels->kappa_t[i];
        if (kappa_t == 0)
            continue;
        size_t zone = zone_of(job, voxels, i);
        double b = job->result.zone[zone];
        out->radiosity[i] = (float)b;
        error += kappa_t * pow(job->result.zone_error[zone], 2);
        size += kappa_t * b * b;
    }
    out->error = sqrt(error / size);
}

murk_status bench_packets_run(const murk_scene *scene, const struct bench_voxels *voxels,
                              long packets, int threads, struct bench_packets *out)
{
    struct job job = {0};
    double start = bench_seconds();
    take_light(&job, scene);
    bool done = make_zones(&job, voxels) && make_patches(&job, scene->ground) &&
                make_results(&job) &&
                bench_mc_solve(&job.scene, true, packets, BATCHES, threads, &job.result);
    out->seconds = bench_seconds() - start;
    if (done)
        take_result(&job, voxels, out);
    free(job.zones);
    free(job.patches);
    free(job.numbers);
    return done ? MURK_OK : MURK_ERROR_MEMORY;
}
