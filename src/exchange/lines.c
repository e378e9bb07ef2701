/* SPDX-License-Identifier: Apache-2.0 */
#include "lines.h"

#include "quadrature.h"

#include <math.h>

struct murk_lines {
    murk_sweep *sweep;
    const murk_ground *ground;
    double *patch_power; /* of MURK_MOST_BANDS bands */
    double flux; /* what makes the half-range flux onto the ground exact: 1/4 over its quadrature */
};

/* The lines of one direction, through the points that its shift leads to. The more directions there
   are, the less each has to stand for: their footprints on the ground shrink. */
static void set_lines(const murk_grid *grid, const murk_quadrature *quadrature, int rays,
                      murk_line *line)
{
    double orbits = quadrature->count / MURK_ORBIT, footprint = fmin(1, sqrt(2 / orbits));
    for (int d = 0; d < quadrature->count; d++) {
        const double *direction = quadrature->direction[d], *shift = quadrature->shift[d];
        murk_lattice lattice;
        murk_lattice_lay(&lattice, grid,
                         &(murk_line){.direction = {direction[0], direction[1], direction[2]}});
        const int across[2] = {lattice.u, lattice.v};
        double start[2];
        for (int c = 0; c < 2; c++) {
            start[c] = 0.5 + shift[across[c]] - lattice.slope[c] * shift[lattice.axis];
            start[c] -= floor(start[c]);
        }
        for (int i = 0; i < rays * rays; i++, line++) {
            for (int c = 0; c < 3; c++)
                line->direction[c] = direction[c];
            line->offset[0] = (i % rays + start[0]) / rays;
            line->offset[1] = (i / rays + start[1]) / rays;
            line->span = footprint / rays;
            line->weight = quadrature->weight[d] / (rays * rays);
        }
    }
}

/* Ratio of the exact mean of |cos| over the sphere, 1/2, to the quadrature's: 1 where the ground
   lies along the lattice, close to it where the grid is turned. */
static double flux_ratio(const murk_grid *grid, const murk_ground *ground,
                         const murk_quadrature *quadrature)
{
    double sum = 0;
    for (int d = 0; d < quadrature->count; d++) {
        double world[3];
        murk_grid_direction_to_world(grid, quadrature->direction[d], world);
        sum += quadrature->weight[d] * fabs(world[murk_ground_axis_up(ground)]);
    }
    return 0.5 / sum;
}

murk_status murk_lines_create(murk_context *context, const murk_grid *grid, const float *kappa_t,
                              const murk_ground *ground, int directions, int rays, int set,
                              murk_lines **out)
{
    murk_quadrature quadrature;
    int orbits = (directions + MURK_ORBIT - 1) / MURK_ORBIT;
    murk_status status = murk_quadrature_create(context, orbits, set, &quadrature);
    if (status)
        return status;
    murk_lines *lines = murk_alloc(1, sizeof *lines);
    murk_line *line = murk_alloc((size_t)quadrature.count * (size_t)(rays * rays), sizeof *line);
    if (lines && ground)
        lines->patch_power = murk_alloc(MURK_MOST_BANDS * ground->patch_count, sizeof(double));
    if (!lines || !line || (ground && !lines->patch_power)) {
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d directions",
                           quadrature.count);
    } else {
        set_lines(grid, &quadrature, rays, line);
        lines->ground = ground;
        lines->flux = ground ? flux_ratio(grid, ground, &quadrature) : 1;
        status = murk_sweep_create(context, grid, kappa_t, ground, line,
                                   quadrature.count * rays * rays, &lines->sweep);
    }
    murk_free(line);
    murk_quadrature_clear(&quadrature);
    if (status)
        murk_lines_release(lines);
    else
        *out = lines;
    return status;
}

void murk_lines_release(murk_lines *lines)
{
    if (!lines)
        return;
    murk_sweep_release(lines->sweep);
    murk_free(lines->patch_power);
    murk_free(lines);
}

const char *murk_lines_kernel(const murk_lines *lines)
{
    return murk_sweep_kernel(lines->sweep);
}

void murk_lines_limit(murk_lines *lines, const murk_region *region)
{
    murk_sweep_limit(lines->sweep, region);
}

void murk_lines_bend(murk_lines *lines, const murk_bent *bent)
{
    murk_sweep_bend(lines->sweep, bent);
}

const murk_traced *murk_lines_traced(const murk_lines *lines)
{
    return murk_sweep_traced(lines->sweep);
}

murk_status murk_lines_apply(murk_context *context, murk_lines *lines, const murk_radiosity *in,
                             murk_incident *out, int bands)
{
    murk_cargo cargo[MURK_MOST_BANDS];
    size_t patches = lines->ground && out->patch ? lines->ground->patch_count : 0;
    for (int b = 0; b < bands; b++)
        cargo[b] = (murk_cargo){
            .source = in[b].zone,
            .slope = in[b].slope,
            .incoming = {.patch = in[b].patch, .sky = in[b].sky, .horizon = in[b].horizon},
            .tally = out[b].zone,
            .slope_tally = out[b].slope,
            .patch_power = patches ? lines->patch_power + b * patches : NULL};
    murk_status status = murk_sweep_run(context, lines->sweep, cargo, bands, 4);
    for (int b = 0; !status && b < bands; b++) {
        out[b].net_power = cargo[b].net_power;
        for (size_t i = 0; i < patches; i++)
            out[b].patch[i] = (float)(in[b].sky + lines->flux * cargo[b].patch_power[i] /
                                                      murk_ground_area(lines->ground, i));
    }
    return status;
}

static murk_status lines_init(murk_context *context, const murk_medium *medium,
                              const murk_ground *ground, const murk_solve_options *options,
                              void **state)
{
    murk_lines *lines;
    murk_status status =
        murk_lines_create(context, medium->grid, medium->kappa_t, ground,
                          options->directions > 0 ? options->directions : MURK_ORBIT,
                          options->rays > 0 ? options->rays : 1, 0, &lines);
    if (!status)
        *state = lines;
    return status;
}

static murk_status lines_apply(murk_context *context, void *state, const murk_radiosity *in,
                               murk_incident *out, int bands)
{
    return murk_lines_apply(context, state, in, out, bands);
}

static void lines_release(void *state)
{
    murk_lines_release(state);
}

const murk_exchange_method murk_exchange_lines = {.name = "lines",
                                                  .init = lines_init,
                                                  .apply = lines_apply,
                                                  .row = NULL,
                                                  .release = lines_release};
