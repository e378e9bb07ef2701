/* SPDX-License-Identifier: Apache-2.0 */
#include "coarse_bands.h"

#include "conjugate_gradients.h"
#include "quadrature.h"
#include "zonewise.h"

#include <math.h>
#include <string.h>

/* Larger zones pay where there are enough of them to cost something, and correct well where they
   are optically thin; both measured on smoke (see murk bench). */
static const size_t WORTH = 20000;
static const double THIN = 0.5;

/* Optical depth of a typical zone: the mean of kappa_t weighted by itself, across its longest
   edge. */
static double zone_depth(const murk_medium *medium)
{
    double sum = 0, square = 0;
    const murk_grid *grid = medium->grid;
    for (size_t i = 0; i < grid->brick_count * MURK_BRICK_SLOTS; i++) {
        sum += medium->kappa_t[i];
        square += (double)medium->kappa_t[i] * medium->kappa_t[i];
    }
    double edge = fmax(grid->voxel[0], fmax(grid->voxel[1], grid->voxel[2]));
    return sum > 0 ? edge * square / sum : 0;
}

int murk_coarse_choose_shift(const murk_medium *medium)
{
    double depth = zone_depth(medium);
    int shift = 0;
    while (shift < 2 && 2 * depth * (1 << shift) <= THIN &&
           medium->grid->zone_count >> 3 * shift > WORTH)
        shift++;
    return shift;
}

/* Lines that cross the coarse zones. */
static murk_status make_lines(const murk_coarse_bands *bands, int directions, int rays, int set,
                              murk_lines **out)
{
    const murk_coarse *any = bands->band;
    murk_status status = murk_lines_create(bands->context, any->medium->grid, any->medium->kappa_t,
                                           any->solution->ground, directions, rays, set, out);
    if (!status)
        murk_lines_bend(*out, &any->stage->bend.zones);
    return status;
}

murk_status murk_coarse_bands_create(murk_context *context, murk_solution *const solution[],
                                     const murk_stage stage[], int count,
                                     const murk_solve_options *options, murk_coarse_bands *out)
{
    bool bent = stage->bend.zones.count;
    int shift = stage->halved || bent ? 0 : murk_coarse_choose_shift(solution[0]->medium);
    *out = (murk_coarse_bands){
        .context = context, .set = bent, .max_iterations = options->max_iterations};
    murk_status status = MURK_OK;
    while (!status && out->count < count) {
        int b = out->count++;
        status = murk_coarse_create(context, solution[b], &stage[b], shift, &out->band[b]);
    }
    if (!status)
        status = make_lines(out, MURK_ORBIT, 1, out->set, &out->lines);
    for (int b = 0; b < out->count; b++)
        out->band[b].system.state = out->lines;
    if (status)
        murk_coarse_bands_clear(out);
    return status;
}

void murk_coarse_bands_clear(murk_coarse_bands *bands)
{
    for (int b = 0; b < bands->count; b++)
        murk_coarse_clear(&bands->band[b]);
    murk_lines_release(bands->lines);
    memset(bands, 0, sizeof *bands);
}

/* Solves L d = r to goals of each band; where r is 0, so is d. */
static murk_status solve(murk_coarse *const band[], const double relative[],
                         const double absolute[], int count, int max_iterations)
{
    murk_cg cg[MURK_MOST_BANDS];
    murk_coarse *solved[MURK_MOST_BANDS];
    int n = 0;
    for (int b = 0; b < count; b++) {
        murk_coarse *coarse = band[b];
        if (murk_vector_zero(&coarse->system, &coarse->r)) {
            murk_vector_copy(&coarse->system, &coarse->r, &coarse->d);
            continue;
        }
        cg[n] = (murk_cg){.system = &coarse->system,
                          .b = &coarse->r,
                          .x = &coarse->d,
                          .relative = relative[b],
                          .absolute = absolute[b]};
        solved[n++] = coarse;
    }
    murk_status status = n ? murk_conjugate_gradients(cg, n, max_iterations) : MURK_OK;
    for (int i = 0; !status && i < n; i++)
        solved[i]->iterations += cg[i].result.iterations;
    return status;
}

murk_status murk_coarse_correct(murk_coarse *const band[], const double absolute[], int count,
                                int max_iterations)
{
    double relative[MURK_MOST_BANDS];
    for (int b = 0; b < count; b++)
        relative[b] = 0.05;
    return solve(band, relative, absolute, count, max_iterations);
}

murk_status murk_coarse_solve(murk_coarse_bands *bands, const murk_solution *const start[],
                              double goal)
{
    murk_residual residual[MURK_MOST_BANDS];
    murk_coarse *band[MURK_MOST_BANDS];
    double relative[MURK_MOST_BANDS], absolute[MURK_MOST_BANDS];
    for (int b = 0; b < bands->count; b++) {
        murk_coarse *coarse = band[b] = &bands->band[b];
        const murk_solution *from = start ? start[b] : NULL;
        if (from)
            murk_coarse_begin(coarse, from);
        relative[b] = from ? 0 : goal;
        absolute[b] = from ? goal * sqrt(murk_vector_norm2(&coarse->system, &coarse->x)) : 0;
        residual[b] = (murk_residual){.system = &coarse->system,
                                      .direct = &coarse->direct,
                                      .around = &coarse->around,
                                      .x = from ? &coarse->x : NULL,
                                      .r = &coarse->r};
    }
    murk_status status = murk_system_residual(residual, bands->count);
    if (!status)
        status = solve(band, relative, absolute, bands->count, bands->max_iterations);
    for (int b = 0; !status && b < bands->count; b++)
        murk_vector_add(&band[b]->system, 1, &band[b]->d, &band[b]->x);
    return status;
}

/* Sets r to the residuals of x on other lines. */
static murk_status find_residuals(murk_coarse_bands *bands, int directions, int rays, int set,
                                  murk_probe *probe)
{
    murk_lines *lines = NULL;
    murk_status status = make_lines(bands, directions, rays, set, &lines);
    if (status)
        return status;
    murk_system system[MURK_MOST_BANDS];
    murk_residual residual[MURK_MOST_BANDS];
    for (int b = 0; b < bands->count; b++) {
        murk_coarse *coarse = &bands->band[b];
        system[b] = murk_coarse_system(coarse, lines);
        residual[b] = (murk_residual){.system = &system[b],
                                      .direct = &coarse->direct,
                                      .around = &coarse->around,
                                      .x = &coarse->x,
                                      .r = &coarse->r,
                                      .scratch = probe ? &coarse->d : NULL};
    }
    status = murk_system_residual(residual, bands->count);
    for (int b = 0; probe && b < bands->count; b++)
        probe[b].diffuse = residual[b].diffuse;
    murk_coarse_count(bands, lines);
    murk_lines_release(lines);
    return status;
}

/* Relative to x, zones in the norm of the tolerance, or patches likewise where that is more. */
static double relative_to_x(const murk_coarse *coarse, const murk_vector *d)
{
    double size = murk_vector_norm2(&coarse->system, &coarse->x);
    double zones = size > 0 ? sqrt(murk_vector_norm2(&coarse->system, d) / size) : 0;
    return fmax(zones, murk_ground_difference(coarse->system.ground, coarse->x.patch, d->patch));
}

murk_status murk_coarse_lattice(murk_coarse_bands *bands, double out[])
{
    murk_status status = find_residuals(bands, MURK_ORBIT, 1, !bands->set, NULL);
    for (int b = 0; !status && b < bands->count; b++)
        out[b] = relative_to_x(&bands->band[b], &bands->band[b].r);
    return status;
}

/* Adds the correction that a probe has led to. */
static double change_of(murk_coarse *coarse)
{
    murk_vector_add(&coarse->system, 1, &coarse->d, &coarse->x);
    double change = relative_to_x(coarse, &coarse->d);
    if (coarse->stage->lamps.count) /* bright zones make up the norm: it tells little of others */
        change =
            fmax(change, murk_zonewise_change(coarse->medium, coarse->d.zone, coarse->x.zone) / 5);
    return change;
}

murk_status murk_coarse_probe(murk_coarse_bands *bands, int directions, int rays, double goal,
                              murk_probe out[])
{
    murk_coarse *band[MURK_MOST_BANDS];
    double absolute[MURK_MOST_BANDS];
    murk_status status =
        find_residuals(bands, directions, rays, directions == MURK_ORBIT ? bands->set : 0, out);
    for (int b = 0; !status && b < bands->count; b++) {
        band[b] = &bands->band[b];
        out[b].residual = relative_to_x(band[b], &band[b]->r);
        absolute[b] = goal * sqrt(murk_vector_norm2(&band[b]->system, &band[b]->x));
    }
    if (!status)
        status = murk_coarse_correct(band, absolute, bands->count, bands->max_iterations);
    for (int b = 0; !status && b < bands->count; b++)
        out[b].change = change_of(band[b]);
    return status;
}

void murk_coarse_count(murk_coarse_bands *bands, const murk_lines *lines)
{
    const murk_traced *traced = murk_lines_traced(lines);
    bands->traced.crossings += traced->crossings;
    bands->traced.dark += traced->dark;
    bands->traced.beyond += traced->beyond;
    bands->traced.seconds += traced->seconds;
}
