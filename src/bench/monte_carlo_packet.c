/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo_packet.h"

#include "monte_carlo_line.h"

#include <math.h>

/* Below this part of its power at the start a packet lives on with the probability SURVIVAL: of
   0.02 to 0.5, what gives the least noise in the same time. */
static const double FAINT = 0.5, SURVIVAL = 0.5;

void bench_mc_walk_begin(struct bench_mc_walk *walk, const struct bench_mc_scene *scene,
                         uint64_t seed)
{
    const struct bench_mc_scene *s = scene;
    *walk = (struct bench_mc_walk){.scene = s, .random = seed * 0xD1342543DE82EF95u};
    walk->cell_volume = s->voxel[0] * s->voxel[1] * s->voxel[2];
    for (int a = 0; a < 3; a++)
        walk->box_high[a] = s->low[a] + s->size[a] * s->voxel[a];
    for (int c = 0; c < 2 && s->patches[c] > 0; c++)
        walk->patch_size[c] = (s->ground_high[c] - s->ground_low[c]) / s->patches[c];
    walk->patch_area = walk->patch_size[0] * walk->patch_size[1];
}

/* SplitMix64 (Steele, Lea, Flood 2014). */
double bench_mc_draw(struct bench_mc_walk *walk)
{
    uint64_t z = walk->random += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return ((double)(z >> 12) + 0.5) * 0x1p-52;
}

void bench_mc_spread_begin(struct bench_mc_walk *walk)
{
    for (int d = 0; d < SPREAD; d++)
        walk->spread[d] = bench_mc_draw(walk);
}

/* An additive recurrence (Weyl 1916): multiples of the powers of 1/g, g the positive root of
   x^7 = x + 1. */
void bench_mc_spread_next(struct bench_mc_walk *walk)
{
    double power = 1;
    for (int d = 0; d < SPREAD; d++) {
        power /= 1.1127756842787055;
        walk->spread[d] = fmod(walk->spread[d] + power, 1);
    }
}

void bench_mc_turn_isotropic(double u, double v, double out[3])
{
    double z = 2 * u - 1, turn = 2 * M_PI * v, r = sqrt(1 - z * z);
    out[0] = r * cos(turn);
    out[1] = r * sin(turn);
    out[2] = z;
}

/* The cosine by inversion of the distribution (Witt 1977). */
void bench_mc_turn_scattered(double g, double u, double v, double along[3])
{
    if (g == 0) {
        bench_mc_turn_isotropic(u, v, along);
        return;
    }
    double s = (1 - g * g) / (1 - g + 2 * g * u), z = (1 + g * g - s * s) / (2 * g);
    z = fmax(-1, fmin(z, 1));
    double turn = 2 * M_PI * v, r = sqrt(1 - z * z), x[3] = {0}, y[3], old[3];
    int least = fabs(along[0]) < fabs(along[1]) ? 0 : 1;
    least = fabs(along[2]) < fabs(along[least]) ? 2 : least;
    double length = sqrt(1 - along[least] * along[least]);
    int b = (least + 1) % 3, c = (least + 2) % 3;
    x[b] = -along[c] / length;
    x[c] = along[b] / length;
    for (int a = 0; a < 3; a++)
        old[a] = along[a];
    for (int a = 0; a < 3; a++)
        y[a] = old[(a + 1) % 3] * x[(a + 2) % 3] - old[(a + 2) % 3] * x[(a + 1) % 3];
    for (int a = 0; a < 3; a++)
        along[a] = z * old[a] + r * (cos(turn) * x[a] + sin(turn) * y[a]);
    length = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    for (int a = 0; a < 3; a++)
        along[a] /= length;
}

void bench_mc_turn_lambertian(double u, double v, int axis, double sign, double out[3])
{
    double turn = 2 * M_PI * v;
    out[axis] = sign * sqrt(1 - u);
    out[(axis + 1) % 3] = sqrt(u) * cos(turn);
    out[(axis + 2) % 3] = sqrt(u) * sin(turn);
}

double bench_mc_transmittance(const struct bench_mc_walk *walk, const double at[3],
                              const double along[3])
{
    struct bench_mc_line line;
    double depth = 0, length;
    int zone;
    if (bench_mc_line_begin(&line, walk->scene, at, along))
        while (depth < BENCH_MC_DEEPEST && bench_mc_line_next(&line, &zone, &length))
            depth += walk->scene->kappa_t[zone] * length;
    return exp(-depth);
}

int bench_mc_find_patch(const struct bench_mc_walk *walk, const double at[3], const double along[3],
                        double meets[3])
{
    const struct bench_mc_scene *s = walk->scene;
    int index[2];
    if (!(s->patches[0] > 0) || !(along[2] < 0))
        return BENCH_MC_NOWHERE;
    double t = (s->height - at[2]) / along[2];
    for (int c = 0; c < 2; c++)
        meets[c] = at[c] + t * along[c];
    meets[2] = s->height;
    for (int c = 0; c < 2; c++) {
        double x = floor((meets[c] - s->ground_low[c]) / walk->patch_size[c]);
        if (!(x >= 0 && x < s->patches[c]))
            return BENCH_MC_BEYOND;
        index[c] = (int)x;
    }
    return index[1] * s->patches[0] + index[0];
}

void bench_mc_place_in_zone(const struct bench_mc_walk *walk, int zone, const double part[3],
                            double at[3])
{
    const struct bench_mc_scene *s = walk->scene;
    const int index[3] = {zone / s->size[2] / s->size[1], zone / s->size[2] % s->size[1],
                          zone % s->size[2]};
    for (int a = 0; a < 3; a++)
        at[a] = s->low[a] + s->voxel[a] * (index[a] + part[a]);
}

void bench_mc_place_on_patch(const struct bench_mc_walk *walk, int patch, const double part[2],
                             double at[3])
{
    const struct bench_mc_scene *s = walk->scene;
    const int index[2] = {patch % s->patches[0], patch / s->patches[0]};
    for (int c = 0; c < 2; c++)
        at[c] = s->ground_low[c] + walk->patch_size[c] * (index[c] + part[c]);
    at[2] = s->height;
}

/* From where the packet is (exact), or from anywhere in the element. */
static void leave_zone(struct bench_mc_walk *walk, int zone, struct bench_mc_packet *p)
{
    if (!walk->exact)
        bench_mc_place_in_zone(
            walk, zone, (double[3]){bench_mc_draw(walk), bench_mc_draw(walk), bench_mc_draw(walk)},
            p->at);
    bench_mc_turn_scattered(walk->scene->asymmetry, bench_mc_draw(walk), bench_mc_draw(walk),
                            p->along);
    p->origin = FROM_ZONE;
}

void bench_mc_leave_patch(struct bench_mc_walk *walk, int patch, struct bench_mc_packet *p)
{
    if (!walk->exact)
        bench_mc_place_on_patch(walk, patch, (double[2]){bench_mc_draw(walk), bench_mc_draw(walk)},
                                p->at);
    bench_mc_turn_lambertian(bench_mc_draw(walk), bench_mc_draw(walk), 2, 1, p->along);
    p->origin = FROM_OUTSIDE;
}

/* Whether a packet lives on that keeps this part of itself. */
static bool survive(struct bench_mc_walk *walk, struct bench_mc_packet *p, double part)
{
    p->w *= part;
    if (p->w >= FAINT * p->start)
        return true;
    p->w /= SURVIVAL;
    return p->w > 0 && bench_mc_draw(walk) < SURVIVAL;
}

/* One flight. Every zone on the line gets its expected share of the packet; where the packet
   itself ends is drawn. False when it is lost. */
static bool fly(struct bench_mc_walk *walk, struct bench_mc_packet *p, bool direct)
{
    const struct bench_mc_scene *s = walk->scene;
    struct bench_mc_tally *tally = walk->tally;
    double target = -log(bench_mc_draw(walk)), depth = 0, tau = 1, length, meets[3], stop = 0;
    int zone, stopped = BENCH_MC_NOWHERE;
    struct bench_mc_line line;
    if (bench_mc_line_begin(&line, s, p->at, p->along))
        while (depth < BENCH_MC_DEEPEST && bench_mc_line_next(&line, &zone, &length)) {
            if (!(s->kappa_t[zone] > 0))
                continue;
            depth += s->kappa_t[zone] * length;
            double after = exp(-depth);
            tally->zone[zone] += p->w * (tau - after);
            tau = after;
            if (stopped == BENCH_MC_NOWHERE && depth > target) {
                stopped = zone;
                stop = line.t - (depth - target) / s->kappa_t[zone];
            }
        }
    if (p->origin == FROM_ZONE)
        tally->escaped += p->w * tau;
    else
        *(p->origin == FROM_SUN ? &tally->sun : &tally->diffuse) += p->w * (1 - tau);
    int patch = direct ? BENCH_MC_NOWHERE : bench_mc_find_patch(walk, p->at, p->along, meets);
    if (patch >= 0)
        tally->patch[patch] += p->w * tau;
    if (stopped == BENCH_MC_NOWHERE && patch < 0)
        return false;
    for (int a = 0; a < 3; a++)
        p->at[a] = stopped == BENCH_MC_NOWHERE ? meets[a] : p->at[a] + stop * p->along[a];
    if (!survive(walk, p,
                 stopped == BENCH_MC_NOWHERE ? s->ground_reflectance[patch] : s->albedo[stopped]))
        return false;
    if (stopped == BENCH_MC_NOWHERE)
        bench_mc_leave_patch(walk, patch, p);
    else
        leave_zone(walk, stopped, p);
    return true;
}

void bench_mc_follow(struct bench_mc_walk *walk, struct bench_mc_packet *p, bool direct)
{
    for (p->start = p->w; fly(walk, p, direct); direct = false)
        continue;
}
