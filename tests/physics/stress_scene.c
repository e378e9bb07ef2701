/* SPDX-License-Identifier: Apache-2.0 */
#include "stress_check.h"

enum { PATCHES = 6, BRICK = 512 };

void stress_scene_clear(struct stress_scene *scene)
{
    free(scene->voxel);
    memset(scene, 0, sizeof *scene);
}

struct stress_scene stress_copy(const struct stress_scene *scene)
{
    struct stress_scene copy = *scene;
    copy.voxel = malloc((scene->count + 1) * sizeof *copy.voxel);
    if (!copy.voxel)
        abort();
    memcpy(copy.voxel, scene->voxel, scene->count * sizeof *copy.voxel);
    return copy;
}

struct stress_scene stress_move(const struct stress_scene *scene, const struct stress_motion *m)
{
    struct stress_scene moved = stress_copy(scene);
    for (int a = 0; a < 3; a++) {
        moved.size[a] = scene->size[m->from[a]] * m->scale;
        double d = scene->sun.direction[m->from[a]];
        moved.sun.direction[a] = m->flip[a] ? -d : d;
        if (m->from[a] == 2)
            moved.up = a == 1 ? MURK_UP_Y : MURK_UP_Z;
    }
    for (size_t n = 0; n < scene->count; n++) {
        struct stress_voxel *v = &moved.voxel[n];
        for (int a = 0; a < 3; a++) {
            int32_t i = scene->voxel[n].at[m->from[a]];
            v->at[a] = m->shift[a] + (m->flip[a] ? -1 - i : i);
        }
        v->kappa_t = (float)(v->kappa_t / m->scale);
        v->emission = (float)(v->emission * m->light);
    }
    moved.sun.irradiance *= m->light;
    moved.sky *= m->light;
    moved.ground_emission *= m->light;
    return moved;
}

/* ---- in memory ----------------------------------------------------------------------------- */

/* The box of the voxels, both ends included; without any, that of voxel (0, 0, 0). */
static void find_box(const struct stress_scene *scene, int32_t lo[3], int32_t hi[3])
{
    for (int a = 0; a < 3; a++) {
        lo[a] = hi[a] = scene->count ? scene->voxel[0].at[a] : 0;
        for (size_t n = 1; n < scene->count; n++) {
            int32_t i = scene->voxel[n].at[a];
            lo[a] = i < lo[a] ? i : lo[a];
            hi[a] = i > hi[a] ? i : hi[a];
        }
    }
}

static murk_status make_ground(struct world *w, const struct stress_scene *scene)
{
    int32_t lo[3], hi[3];
    find_box(scene, lo, hi);
    int up = scene->up == MURK_UP_Z ? 2 : 1;
    const int axes[2] = {0, 3 - up};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.up = scene->up;
    ground.height = (lo[up] - scene->gap) * scene->size[up];
    for (int c = 0; c < 2; c++) {
        ground.extent_min[c] = lo[axes[c]] * scene->size[axes[c]];
        ground.extent_max[c] = (hi[axes[c]] + 1) * scene->size[axes[c]];
        ground.patches[c] = PATCHES;
    }
    ground.reflectance = scene->reflectance;
    ground.emission = scene->ground_emission;
    return murk_ground_create(w->context, &ground, &w->ground);
}

/* Sorts voxels into bricks. */
struct bricks {
    size_t count;
    int32_t (*at)[3];
    float *kappa_t, *albedo, *emission;
};

static size_t brick_of(struct bricks *bricks, const int32_t voxel[3])
{
    int32_t at[3];
    for (int a = 0; a < 3; a++)
        at[a] = voxel[a] >> 3;
    for (size_t b = bricks->count; b-- > 0;)
        if (!memcmp(bricks->at[b], at, sizeof at))
            return b;
    memcpy(bricks->at[bricks->count], at, sizeof at);
    return bricks->count++;
}

static bool fill_bricks(struct bricks *bricks, const struct stress_scene *scene)
{
    enum { MOST_BRICKS = 4096 };
    bricks->at = malloc(MOST_BRICKS * sizeof *bricks->at);
    float **fields[] = {&bricks->kappa_t, &bricks->albedo, &bricks->emission};
    for (int f = 0; f < 3; f++)
        if (!(*fields[f] = calloc((size_t)MOST_BRICKS * BRICK, sizeof(float))))
            return false;
    for (size_t n = 0; bricks->at && n < scene->count; n++) {
        const struct stress_voxel *v = &scene->voxel[n];
        size_t slot = brick_of(bricks, v->at) * BRICK +
                      (size_t)(64 * (v->at[0] & 7) + 8 * (v->at[1] & 7) + (v->at[2] & 7));
        bricks->kappa_t[slot] = v->kappa_t;
        bricks->albedo[slot] = v->albedo;
        bricks->emission[slot] = v->emission;
        if (bricks->count == MOST_BRICKS)
            return false;
    }
    return bricks->at;
}

static murk_status make_medium(struct world *w, const struct stress_scene *scene)
{
    struct bricks bricks = {0};
    murk_status status = MURK_ERROR_MEMORY;
    if (fill_bricks(&bricks, scene)) {
        murk_brick_array array = {.count = bricks.count,
                                  .brick = *bricks.at,
                                  .kappa_t = bricks.kappa_t,
                                  .albedo = bricks.albedo,
                                  .emission = bricks.emission};
        memcpy(array.voxel_size, scene->size, sizeof array.voxel_size);
        status = murk_medium_from_bricks(w->context, &array, &w->medium);
    }
    free(bricks.at);
    free(bricks.kappa_t);
    free(bricks.albedo);
    free(bricks.emission);
    return status;
}

bool stress_open(struct world *w, const struct stress_scene *scene)
{
    memset(w, 0, sizeof *w);
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    options.threads = 1;
    if (murk_context_create(&options, &w->context))
        return false;
    if (make_medium(w, scene) || (scene->ground && make_ground(w, scene))) {
        fprintf(stderr, "%s\n", murk_context_message(w->context));
        world_close(w);
        return false;
    }
    w->scene = (murk_scene){
        .medium = w->medium, .ground = w->ground, .sun = scene->sun, .sky_radiance = scene->sky};
    return true;
}

/* ---- solutions ----------------------------------------------------------------------------- */

static void judge(struct stress_solution *out, double b)
{
    out->bad += !isfinite(b);
    out->negative += b < 0;
}

static void read_solution(const struct world *w, const struct stress_scene *scene,
                          struct stress_solution *out)
{
    size_t count = 0;
    murk_solution_voxels(w->solution, 0, NULL, NULL, &count);
    float *all = malloc((count + 1) * sizeof *all), patch[PATCHES * PATCHES];
    if (!all || !out->B)
        abort();
    murk_solution_voxels(w->solution, count, NULL, all, &count);
    for (size_t n = 0; n < count; n++)
        judge(out, all[n]);
    free(all);
    for (size_t n = 0; n < scene->count; n++)
        out->B[n] = (float)murk_solution_radiosity(w->solution, scene->voxel[n].at);
    if (!w->ground)
        return;
    murk_solution_ground(w->solution, patch);
    for (int i = 0; i < PATCHES * PATCHES; i++) {
        judge(out, patch[i]);
        out->patches_of_one = fmax(out->patches_of_one, fabs(patch[i] - 1.0));
    }
}

bool stress_solve(const struct stress_scene *scene, const murk_solve_options *options,
                  struct stress_solution *out)
{
    memset(out, 0, sizeof *out);
    struct world w;
    if (!stress_open(&w, scene))
        return false;
    out->status = murk_solve(w.context, &w.scene, options, &w.solution);
    bool solved = w.solution;
    if (solved) {
        out->B = malloc((scene->count + 1) * sizeof *out->B);
        read_solution(&w, scene, out);
        out->report = *murk_solution_report(w.solution);
    } else
        fprintf(stderr, "%s\n", murk_context_message(w.context));
    world_close(&w);
    return solved;
}

void stress_solution_clear(struct stress_solution *solution)
{
    free(solution->B);
    memset(solution, 0, sizeof *solution);
}

static double norm_of(const struct stress_scene *scene, const float *a, const float *b, bool below)
{
    double sum = 0;
    for (size_t n = 0; n < scene->count; n++) {
        double d = (double)a[n] - (b ? b[n] : 0), kappa_t = scene->voxel[n].kappa_t;
        if (stress_is_zone(scene, n) && !(below && d > 0))
            sum += kappa_t * d * d;
    }
    return sqrt(sum);
}

double stress_norm(const struct stress_scene *scene, const float *a, const float *b)
{
    return norm_of(scene, a, b, false);
}

double stress_norm_below(const struct stress_scene *scene, const float *a, const float *b)
{
    return norm_of(scene, a, b, true);
}
