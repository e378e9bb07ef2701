/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo.h"

#include "monte_carlo_line.h"

#include <math.h>
#include <stdlib.h>

enum { NOWHERE = -1 };

/* What is left of a packet behind this depth, 1e-17, changes no sum. */
static const double DEEPEST = 40;

/* Below this part of its power at the start a packet lives on with the probability SURVIVAL. */
static const double FAINT = 0.1, SURVIVAL = 0.25;

/* Where a straight flight began. */
enum origin { FROM_SUN, FROM_OUTSIDE, FROM_ZONE };

/* Coordinates of a packet at its start that are spread evenly: which element or side, place,
   direction. */
enum { CHOICE, PLACE, ALONG = PLACE + 3, SPREAD = ALONG + 2 };

struct run {
    const struct bench_mc_scene *scene;
    struct bench_mc_tally *tally;
    bool exact;
    uint64_t random;
    double spread[SPREAD];
    double box_high[3], patch_size[2];
    double cell_volume, patch_area;
};

/* A packet on its way: the power w it stands for, and its power when it started. */
struct packet {
    double at[3], along[3], w, start;
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

/* Starts a sequence of packets: random, so that batches are independent. */
static void spread_begin(struct run *run)
{
    for (int d = 0; d < SPREAD; d++)
        run->spread[d] = draw(run);
}

/* The next point of an additive recurrence (Weyl 1916): multiples of the powers of 1/g, g the
   positive root of x^7 = x + 1. Each point by itself is uniformly distributed. */
static void spread_next(struct run *run)
{
    double power = 1;
    for (int d = 0; d < SPREAD; d++) {
        power /= 1.1127756842787055;
        run->spread[d] = fmod(run->spread[d] + power, 1);
    }
}

static void turn_isotropic(double u, double v, double out[3])
{
    double z = 2 * u - 1, turn = 2 * M_PI * v, r = sqrt(1 - z * z);
    out[0] = r * cos(turn);
    out[1] = r * sin(turn);
    out[2] = z;
}

/* Density cos(theta)/pi about an axis, towards its positive or negative end. */
static void turn_lambertian(double u, double v, int axis, double sign, double out[3])
{
    double turn = 2 * M_PI * v;
    out[axis] = sign * sqrt(1 - u);
    out[(axis + 1) % 3] = sqrt(u) * cos(turn);
    out[(axis + 2) % 3] = sqrt(u) * sin(turn);
}

static double transmittance(const struct run *run, const double at[3], const double along[3])
{
    struct bench_mc_line line;
    double depth = 0, length;
    int zone;
    if (bench_mc_line_begin(&line, run->scene, at, along))
        while (depth < DEEPEST && bench_mc_line_next(&line, &zone, &length))
            depth += run->scene->kappa_t[zone] * length;
    return exp(-depth);
}

static bool has_ground(const struct bench_mc_scene *s)
{
    return s->patches[0] > 0;
}

/* The patch that a line meets, and where; or NOWHERE. */
static int find_patch(const struct run *run, const double at[3], const double along[3],
                      double meets[3])
{
    const struct bench_mc_scene *s = run->scene;
    int index[2];
    if (!has_ground(s) || !(along[2] < 0))
        return NOWHERE;
    double t = (s->height - at[2]) / along[2];
    for (int c = 0; c < 2; c++) {
        meets[c] = at[c] + t * along[c];
        double x = floor((meets[c] - s->ground_low[c]) / run->patch_size[c]);
        if (!(x >= 0 && x < s->patches[c]))
            return NOWHERE;
        index[c] = (int)x;
    }
    meets[2] = s->height;
    return index[1] * s->patches[0] + index[0];
}

/* ---- Packets ---- */

/* Points of zones and patches at fractions of their edges. */
static void place_in_zone(const struct run *run, int zone, const double part[3], double at[3])
{
    const struct bench_mc_scene *s = run->scene;
    const int index[3] = {zone / s->size[2] / s->size[1], zone / s->size[2] % s->size[1],
                          zone % s->size[2]};
    for (int a = 0; a < 3; a++)
        at[a] = s->low[a] + s->voxel[a] * (index[a] + part[a]);
}

static void place_on_patch(const struct run *run, int patch, const double part[2], double at[3])
{
    const struct bench_mc_scene *s = run->scene;
    const int index[2] = {patch % s->patches[0], patch / s->patches[0]};
    for (int c = 0; c < 2; c++)
        at[c] = s->ground_low[c] + run->patch_size[c] * (index[c] + part[c]);
    at[2] = s->height;
}

/* From where the packet is (exact), or from anywhere in the element. */
static void leave_zone(struct run *run, int zone, struct packet *p)
{
    if (!run->exact)
        place_in_zone(run, zone, (double[3]){draw(run), draw(run), draw(run)}, p->at);
    turn_isotropic(draw(run), draw(run), p->along);
    p->origin = FROM_ZONE;
}

static void leave_patch(struct run *run, int patch, struct packet *p)
{
    if (!run->exact)
        place_on_patch(run, patch, (double[2]){draw(run), draw(run)}, p->at);
    turn_lambertian(draw(run), draw(run), 2, 1, p->along);
    p->origin = FROM_OUTSIDE;
}

/* Whether a packet lives on that keeps this part of itself. */
static bool survive(struct run *run, struct packet *p, double part)
{
    p->w *= part;
    if (p->w >= FAINT * p->start)
        return true;
    p->w /= SURVIVAL;
    return p->w > 0 && draw(run) < SURVIVAL;
}

/* One flight. Every zone on the line gets its expected share of the packet; where the packet
   itself ends is drawn. False when it is lost. `direct`: light of sun and sky, whose transmitted
   part is accounted for at the patches. */
static bool fly(struct run *run, struct packet *p, bool direct)
{
    const struct bench_mc_scene *s = run->scene;
    struct bench_mc_tally *tally = run->tally;
    double target = -log(draw(run)), depth = 0, tau = 1, length, meets[3], stop = 0;
    int zone, stopped = NOWHERE;
    struct bench_mc_line line;
    if (bench_mc_line_begin(&line, s, p->at, p->along))
        while (depth < DEEPEST && bench_mc_line_next(&line, &zone, &length)) {
            if (!(s->kappa_t[zone] > 0))
                continue;
            depth += s->kappa_t[zone] * length;
            double after = exp(-depth);
            tally->zone[zone] += p->w * (tau - after);
            tau = after;
            if (stopped == NOWHERE && depth > target) {
                stopped = zone;
                stop = line.t - (depth - target) / s->kappa_t[zone];
            }
        }
    if (p->origin == FROM_ZONE)
        tally->escaped += p->w * tau;
    else
        *(p->origin == FROM_SUN ? &tally->sun : &tally->diffuse) += p->w * (1 - tau);
    int patch = direct ? NOWHERE : find_patch(run, p->at, p->along, meets);
    if (patch != NOWHERE)
        tally->patch[patch] += p->w * tau;
    if (stopped == NOWHERE && patch == NOWHERE)
        return false;
    for (int a = 0; a < 3; a++)
        p->at[a] = stopped == NOWHERE ? meets[a] : p->at[a] + stop * p->along[a];
    if (!survive(run, p, stopped == NOWHERE ? s->ground_reflectance[patch] : s->albedo[stopped]))
        return false;
    if (stopped == NOWHERE)
        leave_patch(run, patch, p);
    else
        leave_zone(run, stopped, p);
    return true;
}

static void follow(struct run *run, struct packet *p, bool direct)
{
    for (p->start = p->w; fly(run, p, direct); direct = false)
        continue;
}

/* ---- Sources ---- */

/* A point of the box's surface, faces chosen by the given areas; the axis is returned. */
static int place_on_box(struct run *run, const double area[3], const double side[3], double at[3])
{
    const struct bench_mc_scene *s = run->scene;
    double u = run->spread[CHOICE] * (area[0] + area[1] + area[2]);
    int axis = u < area[0] ? 0 : u < area[0] + area[1] ? 1 : 2;
    for (int a = 0; a < 3; a++)
        at[a] = s->low[a] + (run->box_high[a] - s->low[a]) * run->spread[PLACE + a];
    at[axis] = side[axis] > 0 ? s->low[axis] : run->box_high[axis];
    return axis;
}

/* What falls on the box itself. */
static void shine_on_box(struct run *run, bool sun, long packets)
{
    const struct bench_mc_scene *s = run->scene;
    double face[3], area[3], edge[3], side[3];
    for (int a = 0; a < 3; a++)
        edge[a] = run->box_high[a] - s->low[a];
    for (int a = 0; a < 3; a++) {
        face[a] = edge[(a + 1) % 3] * edge[(a + 2) % 3];
        area[a] = sun ? face[a] * fabs(s->sun[a]) : 2 * face[a];
    }
    double power = (area[0] + area[1] + area[2]) * (sun ? s->irradiance : M_PI * s->sky_radiance);
    spread_begin(run);
    for (long n = 0; n < packets; n++) {
        struct packet p = {.w = power / (double)packets, .origin = sun ? FROM_SUN : FROM_OUTSIDE};
        spread_next(run);
        for (int a = 0; a < 3; a++)
            side[a] = sun ? s->sun[a] : draw(run) - 0.5;
        int axis = place_on_box(run, area, side, p.at);
        if (sun)
            for (int a = 0; a < 3; a++)
                p.along[a] = s->sun[a];
        else
            turn_lambertian(run->spread[ALONG], run->spread[ALONG + 1], axis,
                            side[axis] > 0 ? 1 : -1, p.along);
        if (sun || !has_ground(s) || p.along[2] < 0) /* from below comes only the ground's light */
            follow(run, &p, true);
    }
}

/* What falls through the box on the ground, found by looking back from there. */
static void shine_on_ground(struct run *run, bool sun, long packets)
{
    const struct bench_mc_scene *s = run->scene;
    int count = s->patches[0] * s->patches[1];
    double irradiance = sun ? -s->irradiance * s->sun[2] : M_PI * s->sky_radiance;
    spread_begin(run);
    for (long n = 0; n < packets; n++) {
        spread_next(run);
        int patch = (int)(run->spread[CHOICE] * count);
        struct packet p;
        double back[3] = {-s->sun[0], -s->sun[1], -s->sun[2]};
        place_on_patch(run, patch, &run->spread[PLACE], p.at);
        if (!sun)
            turn_lambertian(run->spread[ALONG], run->spread[ALONG + 1], 2, 1, back);
        p.w =
            irradiance * run->patch_area * count / (double)packets * transmittance(run, p.at, back);
        run->tally->patch[patch] += p.w;
        p.w *= s->ground_reflectance[patch];
        leave_patch(run, patch, &p);
        if (p.w > 0)
            follow(run, &p, false);
    }
}

/* The element where the running sum of the powers passes `u`. */
static int pick(const double *sums, int count, double u)
{
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
static bool emit(struct run *run, bool zones, long packets)
{
    const struct bench_mc_scene *s = run->scene;
    int count = (int)(zones ? bench_mc_zones(s) : bench_mc_patches(s));
    double *sums = malloc((size_t)count * sizeof *sums), sum = 0;
    if (!sums)
        return false;
    for (int i = 0; i < count; i++) {
        sum += zones ? 4.0 * s->kappa_t[i] * (1 - s->albedo[i]) * s->emission[i] * run->cell_volume
                     : s->ground_emission[i] * run->patch_area;
        sums[i] = sum;
    }
    spread_begin(run);
    for (long n = 0; sum > 0 && n < packets; n++) {
        struct packet p = {.w = sum / (double)packets};
        const double *spread = run->spread;
        spread_next(run);
        int chosen = pick(sums, count, spread[CHOICE] * sum);
        p.origin = zones ? FROM_ZONE : FROM_OUTSIDE;
        if (zones) {
            place_in_zone(run, chosen, &spread[PLACE], p.at);
            turn_isotropic(spread[ALONG], spread[ALONG + 1], p.along);
        } else {
            place_on_patch(run, chosen, &spread[PLACE], p.at);
            turn_lambertian(spread[ALONG], spread[ALONG + 1], 2, 1, p.along);
        }
        follow(run, &p, false);
    }
    free(sums);
    return true;
}

bool bench_mc_run(const struct bench_mc_scene *scene, bool exact, uint64_t seed, long packets,
                  struct bench_mc_tally *tally)
{
    const struct bench_mc_scene *s = scene;
    struct run run = {
        .scene = s, .tally = tally, .exact = exact, .random = seed * 0xD1342543DE82EF95u};
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
    return emit(&run, true, packets) && (!has_ground(s) || emit(&run, false, packets));
}
