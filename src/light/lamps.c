/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Of N directions, n = N a / (4 pi r^2) have a line through an emitter of cross-section a that goes
 * on to a zone at the distance r: that light is found with an error of about n^-1/2 of itself. With
 * w the share of all the light that an emitter sends, the light of all of them is found with
 *
 *     e = (4 pi r^2 / N)^1/2 (sum w^2 / a)^1/2,
 *
 * where it comes straight; what is scattered is spread over the medium by then. Lamps are the
 * smallest set of emitters without which e is small against the tolerance. Only what an emitter
 * sends above one of mean temperature counts: in an isothermal medium nothing is missed, however
 * compact. Where many of the zones are emitters most light comes from near, where lines are many.
 */
#include "lamps.h"

#include "sight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DIRECTIONS = 192, MOST_LAMPS = 1024, MOST_PATCHES = 16 };

/* Uncollided light goes so many mean free paths. */
static const double FREE_PATHS = 1.5;
/* e that is left to the lines, over the tolerance; and, where lamps cannot bring it down to that,
   over e without lamps: else they are not worth it. */
static const double GOAL = 2, WORTH = 1. / 3;
/* The largest part of the zones that are lamps. */
static const double FEW = 0.01;
/* Emitters of less than this part of an equal share among the most lamps are none. */
static const double FAINT = 1. / 16;

typedef struct measure {
    const murk_lit *lit;
    double cross;            /* mean cross-section of a zone [m^2] */
    double chord;            /* its mean chord [m] */
    double box;              /* cross-section of the box of the zones */
    double middle[3];        /* of that box, in the ground's (a, b, height above the ground) */
    double mean, patch_mean; /* E that would send out as much, everywhere alike */
    double power;            /* of all light [W] */
} measure;

typedef struct candidate {
    double size; /* w^2 / a */
    murk_lamp lamp;
} candidate;

/* Power that a zone of radiosity 1 lets out. */
static double zone_weight(const measure *m, size_t slot)
{
    const murk_medium *medium = m->lit->medium;
    double kappa = medium->kappa_t[slot];
    return 4 * kappa * medium->grid->volume * murk_chord_escape(kappa * m->chord);
}

static float zone_radiosity(const murk_medium *medium, size_t slot)
{
    return (1 - murk_value(&medium->albedo, slot)) * murk_value(&medium->emission, slot);
}

/* Power that goes from a patch of radiosity 1 towards the zones. */
static double patch_weight(const measure *m, size_t patch)
{
    const murk_ground *ground = m->lit->ground;
    const size_t at[2] = {patch % (size_t)ground->count[0], patch / (size_t)ground->count[0]};
    double up = m->middle[2], r2 = up * up;
    for (int c = 0; c < 2; c++) {
        double x = (ground->edge[c][at[c]] + ground->edge[c][at[c] + 1]) / 2 - m->middle[c];
        r2 += x * x;
    }
    double area = murk_ground_area(ground, patch), share = m->box * up / (M_PI * r2 * sqrt(r2));
    return area * fmin(0.5, share);
}

static void measure_box(measure *m)
{
    const murk_lit *lit = m->lit;
    const murk_grid *grid = lit->medium->grid;
    double volume = 1, surface = 0;
    for (int a = 0; a < 3; a++) {
        volume *= ((double)grid->hi[a] - grid->lo[a]) * grid->voxel[a];
        surface += 2 * grid->volume / grid->voxel[a];
    }
    m->cross = surface / 4;
    m->chord = 4 * grid->volume / surface;
    m->box = cbrt(volume * volume);
    if (!lit->ground)
        return;
    murk_sight sight;
    double middle[3];
    murk_sight_init(&sight, lit->medium, lit->ground);
    for (int a = 0; a < 3; a++)
        middle[a] = sight.box[a] / 2;
    murk_sight_project(&sight, middle, m->middle);
}

/* The light of all sources and the levels that are everywhere. */
static void measure_light(measure *m)
{
    const murk_lit *lit = m->lit;
    const murk_medium *medium = lit->medium;
    double emitted = 0, emitters = 0, ground = 0, black = 0;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++)
        if (medium->kappa_t[i] > 0) {
            double weight = zone_weight(m, i);
            emitters += weight * (1 - murk_value(&medium->albedo, i));
            emitted += weight * zone_radiosity(medium, i);
        }
    for (size_t i = 0; lit->ground && i < lit->ground->patch_count; i++) {
        double weight = patch_weight(m, i);
        black += weight * (1 - lit->ground->reflectance[i]);
        ground += weight * lit->patch[i];
    }
    m->mean = emitters > 0 ? emitted / emitters : 0;
    m->patch_mean = black > 0 ? ground / black : 0;
    m->power = emitted + ground + lit->sun + 4 * m->box * lit->sky;
}

static candidate zone_candidate(const measure *m, size_t slot)
{
    const murk_medium *medium = m->lit->medium;
    double above = murk_value(&medium->emission, slot) - m->mean;
    double w =
        zone_weight(m, slot) * (1 - murk_value(&medium->albedo, slot)) * fmax(0, above) / m->power;
    return (candidate){w * w / m->cross, {slot, zone_radiosity(medium, slot), false}};
}

static candidate patch_candidate(const measure *m, size_t patch)
{
    float radiosity = m->lit->patch[patch];
    double above = radiosity - (1 - m->lit->ground->reflectance[patch]) * m->patch_mean;
    double w = patch_weight(m, patch) * fmax(0, above) / m->power;
    return (candidate){w * w / murk_ground_area(m->lit->ground, patch), {patch, radiosity, true}};
}

/* Sums the sizes of all emitters, or collects those above `least`, of which there are at most
   capacity; gives the sum or the number. */
static double survey(const measure *m, double least, candidate *out, size_t capacity)
{
    const murk_medium *medium = m->lit->medium;
    const murk_ground *ground = m->lit->ground;
    size_t slots = medium->emission.field ? medium->grid->brick_count * MURK_BRICK_SLOTS : 0;
    size_t patches = ground ? ground->patch_count : 0, count = 0;
    double sum = 0;
    for (size_t i = 0; i < slots + patches; i++) {
        if (i < slots && !(medium->kappa_t[i] > 0 && medium->emission.field[i] > m->mean))
            continue;
        candidate found = i < slots ? zone_candidate(m, i) : patch_candidate(m, i - slots);
        sum += found.size;
        if (out && found.size > least && count < capacity)
            out[count++] = found;
    }
    return out ? (double)count : sum;
}

/* Descending by size; equal ones in order, so that the choice is always the same. */
static int compare_size(const void *a, const void *b)
{
    const candidate *x = a, *y = b;
    if (x->size != y->size)
        return x->size < y->size ? 1 : -1;
    return x->lamp.index < y->lamp.index ? -1 : x->lamp.index > y->lamp.index;
}

static int compare_place(const void *a, const void *b)
{
    const murk_lamp *x = a, *y = b;
    if (x->ground != y->ground)
        return x->ground ? 1 : -1;
    return x->index < y->index ? -1 : x->index > y->index;
}

/* e^2 over sum w^2 / a, in the mean over the zones: light that was never scattered goes some free
   paths, and is the less of all light the more is scattered again before it escapes. */
static double ray_effect(const murk_medium *medium, double box)
{
    double depth = 0, scattering = 0;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++) {
        depth += medium->kappa_t[i];
        scattering += (double)medium->kappa_t[i] * murk_value(&medium->albedo, i);
    }
    double path = FREE_PATHS * (double)medium->grid->zone_count / depth, edge = sqrt(box);
    double reach = fmin(edge / 2, path), zones = fmin(1, 4 * M_PI / 3 * pow(reach / edge, 3));
    double again = scattering / depth * (1 - murk_chord_escape(FREE_PATHS * edge / path));
    return 4 * M_PI * reach * reach / DIRECTIONS * zones * pow(1 - again, 2);
}

/* Leaves as many of the candidates, which descend, as are worth it. */
static size_t enough(const candidate *found, size_t count, double sum, double goal, size_t zones)
{
    size_t lamps = 0, patches = 0;
    double rest = sum;
    for (; lamps < count && lamps < MOST_LAMPS; lamps++) {
        if (rest <= goal && found[lamps].size < 0.1 * found[0].size)
            break; /* what is alike goes together */
        patches += found[lamps].lamp.ground;
        rest -= found[lamps].size;
    }
    bool worth = rest <= fmax(goal, WORTH * WORTH * sum) && patches <= MOST_PATCHES &&
                 (double)(lamps - patches) <= FEW * (double)zones;
    return worth ? lamps : 0;
}

murk_status murk_lamps_choose(murk_context *context, const murk_lit *lit, double tolerance,
                              murk_lamps *out)
{
    measure m = {.lit = lit};
    *out = (murk_lamps){0};
    if (!lit->medium->grid->zone_count || (!lit->medium->emission.field && !lit->ground))
        return MURK_OK;
    measure_box(&m);
    measure_light(&m);
    double goal = pow(GOAL * tolerance, 2) / ray_effect(lit->medium, m.box);
    double sum = m.power > 0 ? survey(&m, 0, NULL, 0) : 0;
    if (!(sum > goal))
        return MURK_OK;
    size_t capacity = (size_t)(MOST_LAMPS / FAINT) + 1;
    candidate *found = murk_alloc(capacity, sizeof *found);
    murk_lamp *lamp = murk_alloc(MOST_LAMPS, sizeof *lamp);
    if (!found || !lamp) {
        murk_free(found);
        murk_free(lamp);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for lamps");
    }
    size_t count = (size_t)survey(&m, FAINT * sum / MOST_LAMPS, found, capacity);
    qsort(found, count, sizeof *found, compare_size);
    out->lamp = lamp;
    out->count = enough(found, count, sum, goal, lit->medium->grid->zone_count);
    for (size_t i = 0; i < out->count; i++) {
        lamp[i] = found[i].lamp;
        out->zones += !lamp[i].ground;
    }
    qsort(lamp, out->count, sizeof *lamp, compare_place);
    murk_free(found);
    return MURK_OK;
}

void murk_lamps_clear(murk_lamps *lamps)
{
    murk_free(lamps->lamp);
    *lamps = (murk_lamps){0};
}
