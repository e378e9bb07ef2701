/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo.h"

#include <math.h>
#include <stdlib.h>

enum { NOWHERE = -1 };

/* Where a straight flight began. */
enum origin { FROM_SUN, FROM_OUTSIDE, FROM_ZONE };

struct run {
    const mc_scene *scene;
    mc_tally *tally;
    uint64_t random;
    double box_high[3], patch_size[2];
    double cell_volume, patch_area;
};

/* A packet on its way: the power w it stands for. */
struct packet {
    double at[3], along[3], w;
    enum origin origin;
};

/* SplitMix64 (Steele, Lea, Flood 2014), as a number in (0, 1). */
static double draw(struct run *run)
{
    uint64_t z = run->random += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return ((double)(z >> 12) + 0.5) * 0x1p-52;
}

static void draw_isotropic(struct run *run, double out[3])
{
    double z = 2 * draw(run) - 1, turn = 2 * M_PI * draw(run), r = sqrt(1 - z * z);
    out[0] = r * cos(turn);
    out[1] = r * sin(turn);
    out[2] = z;
}

/* Density cos(theta)/pi about an axis, towards its positive or negative end. */
static void draw_lambertian(struct run *run, int axis, double sign, double out[3])
{
    double square = draw(run), turn = 2 * M_PI * draw(run);
    out[axis] = sign * sqrt(1 - square);
    out[(axis + 1) % 3] = sqrt(square) * cos(turn);
    out[(axis + 2) % 3] = sqrt(square) * sin(turn);
}

/* ---- Straight lines through the voxels ---- */

struct ray {
    const double *at, *along;
    int cell[3];
    double t, end;
};

/* False where the line from its beginning on misses the box. */
static bool ray_begin(const struct run *run, struct ray *ray, const double at[3],
                      const double along[3])
{
    const mc_scene *s = run->scene;
    *ray = (struct ray){.at = at, .along = along, .t = 0, .end = INFINITY};
    for (int a = 0; a < 3; a++) {
        if (along[a] == 0) {
            if (at[a] < s->low[a] || at[a] > run->box_high[a])
                return false;
            continue;
        }
        double t0 = (s->low[a] - at[a]) / along[a], t1 = (run->box_high[a] - at[a]) / along[a];
        ray->t = fmax(ray->t, fmin(t0, t1));
        ray->end = fmin(ray->end, fmax(t0, t1));
    }
    if (ray->t >= ray->end)
        return false;
    for (int a = 0; a < 3; a++) {
        int n = (int)floor((at[a] + ray->t * along[a] - s->low[a]) / s->voxel[a]);
        ray->cell[a] = n < 0 ? 0 : n >= s->size[a] ? s->size[a] - 1 : n;
    }
    return true;
}

/* The next voxel and the length of the line in it; false at the end of the box. */
static bool ray_next(const struct run *run, struct ray *ray, int *zone, double *length)
{
    const mc_scene *s = run->scene;
    int across = NOWHERE;
    double least = INFINITY;
    for (int a = 0; a < 3; a++) {
        if (ray->cell[a] < 0 || ray->cell[a] >= s->size[a])
            return false;
        if (ray->along[a] == 0)
            continue;
        double wall = s->low[a] + s->voxel[a] * (ray->cell[a] + (ray->along[a] > 0));
        double t = (wall - ray->at[a]) / ray->along[a];
        if (t < least) {
            least = t;
            across = a;
        }
    }
    *zone = (ray->cell[0] * s->size[1] + ray->cell[1]) * s->size[2] + ray->cell[2];
    *length = fmax(0, least - ray->t);
    ray->t = fmax(ray->t, least);
    ray->cell[across] += ray->along[across] > 0 ? 1 : -1;
    return true;
}

static double transmittance(const struct run *run, const double at[3], const double along[3])
{
    struct ray ray;
    double depth = 0, length;
    int zone;
    if (ray_begin(run, &ray, at, along))
        while (ray_next(run, &ray, &zone, &length))
            depth += run->scene->kappa_t[zone] * length;
    return exp(-depth);
}

static bool has_ground(const mc_scene *s)
{
    return s->patches[0] > 0;
}

/* The patch that a line meets, or NOWHERE. */
static int find_patch(const struct run *run, const double at[3], const double along[3])
{
    const mc_scene *s = run->scene;
    int index[2];
    if (!has_ground(s) || !(along[2] < 0))
        return NOWHERE;
    double t = (s->height - at[2]) / along[2];
    for (int c = 0; c < 2; c++) {
        double x = floor((at[c] + t * along[c] - s->ground_low[c]) / run->patch_size[c]);
        if (!(x >= 0 && x < s->patches[c]))
            return NOWHERE;
        index[c] = (int)x;
    }
    return index[1] * s->patches[0] + index[0];
}

/* ---- Packets ---- */

static void leave_zone(struct run *run, int zone, struct packet *p)
{
    const mc_scene *s = run->scene;
    int index[3] = {zone / s->size[2] / s->size[1], zone / s->size[2] % s->size[1],
                    zone % s->size[2]};
    for (int a = 0; a < 3; a++)
        p->at[a] = s->low[a] + s->voxel[a] * (index[a] + draw(run));
    draw_isotropic(run, p->along);
    p->origin = FROM_ZONE;
}

static void place_on_patch(struct run *run, int patch, double at[3])
{
    const mc_scene *s = run->scene;
    int index[2] = {patch % s->patches[0], patch / s->patches[0]};
    for (int c = 0; c < 2; c++)
        at[c] = s->ground_low[c] + run->patch_size[c] * (index[c] + draw(run));
    at[2] = s->height;
}

static void leave_patch(struct run *run, int patch, struct packet *p)
{
    place_on_patch(run, patch, p->at);
    draw_lambertian(run, 2, 1, p->along);
    p->origin = FROM_OUTSIDE;
}

/* One flight. Every zone on the line gets its expected share of the packet; where the packet
   itself ends is drawn. False when it is lost. `direct`: light of sun and sky, whose transmitted
   part is accounted for at the patches. */
static bool fly(struct run *run, struct packet *p, bool direct)
{
    const mc_scene *s = run->scene;
    mc_tally *tally = run->tally;
    double target = -log(draw(run)), depth = 0, tau = 1, length;
    int zone, stopped = NOWHERE;
    struct ray ray;
    if (ray_begin(run, &ray, p->at, p->along))
        while (ray_next(run, &ray, &zone, &length)) {
            depth += s->kappa_t[zone] * length;
            double after = exp(-depth);
            tally->zone[zone] += p->w * (tau - after);
            tau = after;
            if (stopped == NOWHERE && depth > target)
                stopped = zone;
        }
    if (p->origin == FROM_ZONE)
        tally->escaped += p->w * tau;
    else
        *(p->origin == FROM_SUN ? &tally->sun : &tally->diffuse) += p->w * (1 - tau);
    int patch = direct ? NOWHERE : find_patch(run, p->at, p->along);
    if (patch != NOWHERE)
        tally->patch[patch] += p->w * tau;
    if (stopped != NOWHERE) {
        if (draw(run) >= s->albedo[stopped])
            return false;
        leave_zone(run, stopped, p);
        return true;
    }
    if (patch == NOWHERE || draw(run) >= s->ground_reflectance[patch])
        return false;
    leave_patch(run, patch, p);
    return true;
}

static void follow(struct run *run, struct packet *p, bool direct)
{
    for (; fly(run, p, direct); direct = false)
        continue;
}

/* ---- Sources ---- */

/* A point of the box's surface, faces chosen by the given areas; the axis is returned. */
static int place_on_box(struct run *run, const double area[3], const double side[3], double at[3])
{
    const mc_scene *s = run->scene;
    double u = draw(run) * (area[0] + area[1] + area[2]);
    int axis = u < area[0] ? 0 : u < area[0] + area[1] ? 1 : 2;
    for (int a = 0; a < 3; a++)
        at[a] = s->low[a] + (run->box_high[a] - s->low[a]) * draw(run);
    at[axis] = side[axis] > 0 ? s->low[axis] : run->box_high[axis];
    return axis;
}

/* What falls on the box itself. */
static void shine_on_box(struct run *run, bool sun, long packets)
{
    const mc_scene *s = run->scene;
    double face[3], area[3], edge[3], side[3];
    for (int a = 0; a < 3; a++)
        edge[a] = run->box_high[a] - s->low[a];
    for (int a = 0; a < 3; a++) {
        face[a] = edge[(a + 1) % 3] * edge[(a + 2) % 3];
        area[a] = sun ? face[a] * fabs(s->sun[a]) : 2 * face[a];
    }
    double power = (area[0] + area[1] + area[2]) * (sun ? s->irradiance : M_PI * s->sky_radiance);
    for (long n = 0; n < packets; n++) {
        struct packet p = {.w = power / (double)packets, .origin = sun ? FROM_SUN : FROM_OUTSIDE};
        for (int a = 0; a < 3; a++)
            side[a] = sun ? s->sun[a] : draw(run) - 0.5;
        int axis = place_on_box(run, area, side, p.at);
        if (sun)
            for (int a = 0; a < 3; a++)
                p.along[a] = s->sun[a];
        else
            draw_lambertian(run, axis, side[axis] > 0 ? 1 : -1, p.along);
        if (sun || !has_ground(s) || p.along[2] < 0) /* from below comes only the ground's light */
            follow(run, &p, true);
    }
}

/* What falls through the box on the ground, found by looking back from there. */
static void shine_on_ground(struct run *run, bool sun, long packets)
{
    const mc_scene *s = run->scene;
    int count = s->patches[0] * s->patches[1];
    double irradiance = sun ? -s->irradiance * s->sun[2] : M_PI * s->sky_radiance;
    for (long n = 0; n < packets; n++) {
        int patch = (int)(draw(run) * count);
        struct packet p;
        double back[3] = {-s->sun[0], -s->sun[1], -s->sun[2]};
        place_on_patch(run, patch, p.at);
        if (!sun)
            draw_lambertian(run, 2, 1, back);
        p.w =
            irradiance * run->patch_area * count / (double)packets * transmittance(run, p.at, back);
        run->tally->patch[patch] += p.w;
        if (draw(run) >= s->ground_reflectance[patch])
            continue;
        leave_patch(run, patch, &p);
        follow(run, &p, false);
    }
}

/* The number drawn with the probability power[i] / sum. */
static int pick(struct run *run, const double *sums, int count)
{
    double u = draw(run) * sums[count - 1];
    int low = 0, high = count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (u < sums[middle])
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* What zones or patches emit by themselves. */
static void emit(struct run *run, bool zones, long packets)
{
    const mc_scene *s = run->scene;
    int count = zones ? s->size[0] * s->size[1] * s->size[2] : s->patches[0] * s->patches[1];
    double *sums = malloc((size_t)count * sizeof *sums), sum = 0;
    for (int i = 0; sums && i < count; i++) {
        sum += zones ? 4.0 * s->kappa_t[i] * (1 - s->albedo[i]) * s->emission[i] * run->cell_volume
                     : s->ground_emission[i] * run->patch_area;
        sums[i] = sum;
    }
    for (long n = 0; sum > 0 && n < packets; n++) {
        struct packet p = {.w = sum / (double)packets};
        int chosen = pick(run, sums, count);
        if (zones)
            leave_zone(run, chosen, &p);
        else
            leave_patch(run, chosen, &p);
        follow(run, &p, false);
    }
    free(sums);
}

void mc_run(const mc_scene *scene, uint64_t seed, long packets, mc_tally *tally)
{
    const mc_scene *s = scene;
    struct run run = {.scene = s, .tally = tally, .random = seed * 0xD1342543DE82EF95u};
    run.cell_volume = s->voxel[0] * s->voxel[1] * s->voxel[2];
    for (int a = 0; a < 3; a++)
        run.box_high[a] = s->low[a] + s->size[a] * s->voxel[a];
    for (int c = 0; c < 2 && has_ground(s); c++)
        run.patch_size[c] = (s->ground_high[c] - s->ground_low[c]) / s->patches[c];
    run.patch_area = run.patch_size[0] * run.patch_size[1];
    for (int sun = 0; sun < 2; sun++) {
        if (!((sun ? s->irradiance : s->sky_radiance) > 0))
            continue;
        shine_on_box(&run, sun, packets);
        if (has_ground(s))
            shine_on_ground(&run, sun, packets);
    }
    emit(&run, true, packets);
    if (has_ground(s))
        emit(&run, false, packets);
}
