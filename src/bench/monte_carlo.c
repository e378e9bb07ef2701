/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo_packet.h"

#include <math.h>
#include <stdlib.h>

static bool has_ground(const struct bench_mc_scene *s)
{
    return s->patches[0] > 0;
}

/* A point of the box's surface, faces chosen by the given areas; the axis is returned. */
static int place_on_box(struct bench_mc_walk *walk, const double area[3], const double side[3],
                        double at[3])
{
    const struct bench_mc_scene *s = walk->scene;
    double u = walk->spread[CHOICE] * (area[0] + area[1] + area[2]);
    int axis = u < area[0] ? 0 : u < area[0] + area[1] ? 1 : 2;
    for (int a = 0; a < 3; a++)
        at[a] = s->low[a] + (walk->box_high[a] - s->low[a]) * walk->spread[PLACE + a];
    at[axis] = side[axis] > 0 ? s->low[axis] : walk->box_high[axis];
    return axis;
}

/* What falls on the box itself. */
static void shine_on_box(struct bench_mc_walk *walk, bool sun, long packets)
{
    const struct bench_mc_scene *s = walk->scene;
    double face[3], area[3], edge[3], side[3];
    for (int a = 0; a < 3; a++)
        edge[a] = walk->box_high[a] - s->low[a];
    for (int a = 0; a < 3; a++) {
        face[a] = edge[(a + 1) % 3] * edge[(a + 2) % 3];
        area[a] = sun ? face[a] * fabs(s->sun[a]) : 2 * face[a];
    }
    double power = (area[0] + area[1] + area[2]) * (sun ? s->irradiance : M_PI * s->sky_radiance);
    bench_mc_spread_begin(walk);
    for (long n = 0; n < packets; n++) {
        struct bench_mc_packet p = {.w = power / (double)packets,
                                    .origin = sun ? FROM_SUN : FROM_OUTSIDE};
        bench_mc_spread_next(walk);
        for (int a = 0; a < 3; a++)
            side[a] = sun ? s->sun[a] : bench_mc_draw(walk) - 0.5;
        int axis = place_on_box(walk, area, side, p.at);
        if (sun)
            for (int a = 0; a < 3; a++)
                p.along[a] = s->sun[a];
        else
            bench_mc_turn_lambertian(walk->spread[ALONG], walk->spread[ALONG + 1], axis,
                                     side[axis] > 0 ? 1 : -1, p.along);
        if (sun || !has_ground(s) || p.along[2] < 0) /* from below comes only the ground's light */
            bench_mc_follow(walk, &p, true);
    }
}

/* What falls through the box on the ground, found by looking back from there. */
static void shine_on_ground(struct bench_mc_walk *walk, bool sun, long packets)
{
    const struct bench_mc_scene *s = walk->scene;
    int count = s->patches[0] * s->patches[1];
    double irradiance = sun ? -s->irradiance * s->sun[2] : M_PI * s->sky_radiance;
    bench_mc_spread_begin(walk);
    for (long n = 0; n < packets; n++) {
        bench_mc_spread_next(walk);
        int patch = (int)(walk->spread[CHOICE] * count);
        struct bench_mc_packet p;
        double back[3] = {-s->sun[0], -s->sun[1], -s->sun[2]};
        bench_mc_place_on_patch(walk, patch, &walk->spread[PLACE], p.at);
        if (!sun)
            bench_mc_turn_lambertian(walk->spread[ALONG], walk->spread[ALONG + 1], 2, 1, back);
        p.w = irradiance * walk->patch_area * count / (double)packets *
              bench_mc_transmittance(walk, p.at, back);
        walk->tally->patch[patch] += p.w;
        p.w *= s->ground_reflectance[patch];
        bench_mc_leave_patch(walk, patch, &p);
        if (p.w > 0)
            bench_mc_follow(walk, &p, false);
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
static bool emit(struct bench_mc_walk *walk, bool zones, long packets)
{
    const struct bench_mc_scene *s = walk->scene;
    int count = (int)(zones ? bench_mc_zones(s) : bench_mc_patches(s));
    double *sums = malloc((size_t)count * sizeof *sums), sum = 0;
    if (!sums)
        return false;
    for (int i = 0; i < count; i++) {
        sum += zones ? 4.0 * s->kappa_t[i] * (1 - s->albedo[i]) * s->emission[i] * walk->cell_volume
                     : s->ground_emission[i] * walk->patch_area;
        sums[i] = sum;
    }
    bench_mc_spread_begin(walk);
    for (long n = 0; sum > 0 && n < packets; n++) {
        struct bench_mc_packet p = {.w = sum / (double)packets};
        const double *spread = walk->spread;
        bench_mc_spread_next(walk);
        int chosen = pick(sums, count, spread[CHOICE] * sum);
        p.origin = zones ? FROM_ZONE : FROM_OUTSIDE;
        if (zones) {
            bench_mc_place_in_zone(walk, chosen, &spread[PLACE], p.at);
            bench_mc_turn_isotropic(spread[ALONG], spread[ALONG + 1], p.along);
        } else {
            bench_mc_place_on_patch(walk, chosen, &spread[PLACE], p.at);
            bench_mc_turn_lambertian(spread[ALONG], spread[ALONG + 1], 2, 1, p.along);
        }
        bench_mc_follow(walk, &p, false);
    }
    free(sums);
    return true;
}

bool bench_mc_run(const struct bench_mc_scene *scene, bool exact, uint64_t seed, long packets,
                  struct bench_mc_tally *tally)
{
    const struct bench_mc_scene *s = scene;
    struct bench_mc_walk walk;
    bench_mc_walk_begin(&walk, s, seed);
    walk.tally = tally;
    walk.exact = exact;
    for (int sun = 0; sun < 2; sun++) {
        if (!((sun ? s->irradiance : s->sky_radiance) > 0))
            continue;
        shine_on_box(&walk, sun, packets);
        if (has_ground(s))
            shine_on_ground(&walk, sun, packets);
    }
    return emit(&walk, true, packets) && (!has_ground(s) || emit(&walk, false, packets));
}
