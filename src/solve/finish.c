/* SPDX-License-Identifier: Apache-2.0 */
#include "finish.h"

#include "lines.h"
#include "similarity.h"

#include <math.h>
#include <string.h>

float murk_margin_albedo(const murk_medium *medium, const int32_t voxel[3], double mean)
{
    if (!medium->albedo.field)
        return medium->albedo.constant;
    for (int32_t reach = 1; reach <= 2; reach++) {
        double sum = 0;
        int count = 0;
        for (int32_t n = 0; n < 125; n++) {
            const int32_t d[3] = {n / 25 - 2, n / 5 % 5 - 2, n % 5 - 2};
            if (d[0] * d[0] > reach * reach || d[1] * d[1] > reach * reach ||
                d[2] * d[2] > reach * reach)
                continue;
            int64_t slot =
                murk_grid_slot(medium->grid, voxel[0] + d[0], voxel[1] + d[1], voxel[2] + d[2]);
            if (slot < 0 || !(medium->kappa_t[slot] > 0))
                continue;
            sum += medium->albedo.field[slot];
            count++;
        }
        if (count)
            return (float)(sum / count);
    }
    return (float)mean;
}

double murk_mean_albedo(const murk_medium *medium)
{
    double sum = 0, weight = 0;
    if (!medium->albedo.field)
        return medium->albedo.constant;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++) {
        sum += (double)medium->kappa_t[i] * murk_value(&medium->albedo, i);
        weight += medium->kappa_t[i];
    }
    return weight > 0 ? sum / weight : 0;
}

static void fill_margin(murk_solution *solution, const murk_stage *stage,
                        const murk_arrived *arrived)
{
    const float *net = arrived->net;
    const murk_grid *grid = solution->grid;
    double mean = murk_mean_albedo(solution->medium);
#pragma omp parallel for num_threads(solution->context->threads) schedule(static)
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int s = 0; s < MURK_BRICK_SLOTS; s++) {
            size_t i = b * MURK_BRICK_SLOTS + (size_t)s;
            if (stage->kappa_t[i] > 0 || !murk_grid_active(grid, b, s) ||
                !murk_region_has(&arrived->region, grid->brick[b]))
                continue;
            const int32_t voxel[3] = {grid->brick[b][0] * 8 + (s >> 6),
                                      grid->brick[b][1] * 8 + (s >> 3 & 7),
                                      grid->brick[b][2] * 8 + (s & 7)};
            float albedo = murk_margin_albedo(solution->medium, voxel, mean);
            solution->radiosity[i] =
                fmaxf(0, albedo * (net[i] + solution->radiosity[i] + stage->beam[i] / 4));
        }
}

/* Sums over the zones [W], but for the last two. */
struct sums {
    double emitted, absorbed;
    double change, size; /* sums of kappa_t B^2 */
};

static struct sums fill_zones(murk_solution *solution, const murk_stage *stage,
                              const murk_arrived *arrived, bool keep)
{
    const float *net = arrived->net;
    const murk_medium *medium = solution->medium;
    const murk_grid *from = medium->grid;
    double volume = 4 * from->volume, emitted = 0, absorbed = 0, moved = 0, size = 0;
#pragma omp parallel for num_threads(solution->context->threads) schedule(static)                  \
    reduction(+ : emitted, absorbed, moved, size)
    for (size_t b = 0; b < from->brick_count; b++)
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++) {
            size_t i = b * MURK_BRICK_SLOTS + s, o = murk_stage_slots(stage, b) + s;
            double weight = volume * medium->kappa_t[i];
            if (!(weight > 0) || !murk_region_has(&arrived->region, from->brick[b]))
                continue;
            double albedo = murk_value(&medium->albedo, i), x = solution->radiosity[o];
            double emission = (1 - albedo) * murk_value(&stage->emission, i);
            double incident = (double)net[o] + x + stage->beam[o] / 4; /* G/4 */
            double after = albedo * incident + emission;
            emitted += weight * (1 - albedo) * murk_value(&medium->emission, i);
            absorbed += weight * (1 - albedo) * incident;
            moved += weight * (after - x) * (after - x);
            size += weight * after * after;
            if (!keep)
                solution->radiosity[o] = (float)fmax(0, after);
        }
    return (struct sums){emitted, absorbed, moved, size};
}

static void fill_patches(murk_solution *solution, const murk_stage *stage, const float *incident)
{
    const murk_ground *ground = solution->ground;
    for (size_t i = 0; ground && i < ground->patch_count; i++) {
        solution->patch_diffuse[i] = fmaxf(0, incident[i]);
        solution->patch[i] = stage->patch[i] + ground->reflectance[i] * solution->patch_diffuse[i];
    }
}

/* emitted + sun + diffuse = absorbed + escaped. net is what the lines bring in minus carry out,
   diffuse what the medium takes of the light from outside; they know nothing of lamps. */
static void fill_balance(murk_report *report, const struct sums *sums, const murk_stage *stage,
                         const murk_arrived *arrived)
{
    report->energy_emitted = sums->emitted;
    report->energy_absorbed = sums->absorbed;
    report->energy_sun = stage->extinguished;
    report->energy_diffuse = arrived->diffuse + stage->lamps_ground;
    report->energy_escaped =
        arrived->diffuse - arrived->net_power + stage->lamps_sent - stage->lamps_kept;
    double sources = report->energy_emitted + report->energy_sun + report->energy_diffuse;
    double lost = report->energy_absorbed + report->energy_escaped;
    report->energy_balance = sources > 0 ? fabs(sources - lost) / sources : 0;
    if (arrived->region.limited)
        report->energy_emitted = report->energy_absorbed = report->energy_escaped =
            report->energy_balance = NAN;
}

double murk_finish(murk_solution *solution, const murk_stage *stage, const murk_arrived *arrived,
                   bool keep)
{
    fill_margin(solution, stage, arrived);
    fill_patches(solution, stage, arrived->incident);
    struct sums sums = fill_zones(solution, stage, arrived, keep);
    fill_balance(&solution->report, &sums, stage, arrived);
    return sums.size > 0 ? sqrt(sums.change / sums.size) : 0;
}

static murk_status light_ground(murk_context *context, murk_solution *solution)
{
    enum { DIRECTIONS = 384 };
    murk_stage stage;
    murk_status status = murk_stage_create(context, &solution, 1, INFINITY, &stage);
    if (status)
        return status;
    status = murk_stage_light_lamps(context, solution, &stage);
    size_t slots = solution->grid->brick_count * MURK_BRICK_SLOTS;
    murk_lines *lines = NULL;
    float *incident = murk_alloc(solution->ground->patch_count, sizeof *incident);
    float *scattered = murk_alloc(slots, sizeof *scattered);
    if (!status && (!incident || !scattered))
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the ground");
    if (!status)
        status = murk_lines_create(context, solution->grid, stage.kappa_t, solution->ground,
                                   DIRECTIONS, 1, 0, &lines);
    if (!status) {
        /* What the patches send up is in the zones' radiosity already; margin voxels have no
           extinction and so send nothing. */
        memcpy(scattered, solution->radiosity, slots * sizeof *scattered);
        murk_stage_add_lamps(&stage, -1, scattered);
        const murk_radiosity in = {.zone = scattered, .sky = M_PI * solution->sky_radiance};
        murk_incident out = {.patch = incident};
        status = murk_lines_apply(context, lines, &in, &out, 1);
    }
    if (!status) {
        fill_patches(solution, &stage, incident);
        murk_stage_add_patch_lamps(&stage, solution);
    }
    murk_lines_release(lines);
    murk_free(incident);
    murk_free(scattered);
    murk_stage_clear(&stage);
    return status;
}

murk_status murk_solution_light_ground(murk_context *context, murk_solution *solution)
{
    if (!solution->ground)
        return MURK_OK;
    if (solution->medium->asymmetry == 0)
        return light_ground(context, solution);
    murk_solution reduced;
    murk_status status = murk_similarity_reduce(context, solution, &reduced);
    if (status)
        return status;
    status = light_ground(context, &reduced);
    murk_similarity_clear(&reduced);
    return status;
}
