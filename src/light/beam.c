/* SPDX-License-Identifier: Apache-2.0 */
#include "beam.h"

#include "sweep.h"

#include <math.h>
#include <string.h>

bool murk_beam_direction(const murk_ground *ground, const murk_sun *sun, double direction[3])
{
    double length = hypot(hypot(sun->direction[0], sun->direction[1]), sun->direction[2]);
    if (!(sun->irradiance > 0) || !(length > 0))
        return false;
    for (int c = 0; c < 3; c++)
        direction[c] = sun->direction[c] / length;
    return !ground || direction[murk_ground_axis_up(ground)] < 0;
}

double murk_beam_on_ground(const murk_ground *ground, const murk_sun *sun)
{
    double direction[3];
    if (!murk_beam_direction(ground, sun, direction))
        return 0;
    return -direction[murk_ground_axis_up(ground)] * sun->irradiance;
}

murk_status murk_beam(murk_context *context, const murk_grid *grid, const float *kappa_t,
                      const murk_ground *ground, const murk_sun *sun, int rays,
                      const murk_bent *bent, float *incident, float *slope, float *patch,
                      double *extinguished)
{
    double direction[3];
    *extinguished = 0;
    if (!murk_beam_direction(ground, sun, direction)) {
        if (bent && slope)
            memset(slope, 0, bent->count * MURK_BENT_SLOTS * sizeof *slope);
        if (incident)
            memset(incident, 0, grid->brick_count * MURK_BRICK_SLOTS * sizeof *incident);
        if (patch && ground)
            memset(patch, 0, ground->patch_count * sizeof *patch);
        return MURK_OK;
    }
    murk_line *line = murk_alloc((size_t)(rays * rays), sizeof *line);
    double *power = ground ? murk_alloc(ground->patch_count, sizeof *power) : NULL;
    if (!line || (ground && !power)) {
        murk_free(line);
        murk_free(power);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for the sun's beam");
    }
    for (int i = 0; i < rays * rays; i++) {
        murk_grid_direction_from_world(grid, direction, line[i].direction);
        line[i].offset[0] = (i % rays + 0.5) / rays;
        line[i].offset[1] = (i / rays + 0.5) / rays;
        line[i].span = 1.0 / rays;
        line[i].weight = 1.0 / (rays * rays);
    }
    murk_sweep *sweep = NULL;
    murk_cargo cargo = {.incoming = {.sky = sun->irradiance, .uniform = true},
                        .tally = incident,
                        .slope_tally = bent ? slope : NULL,
                        .patch_power = patch ? power : NULL};
    murk_status status =
        murk_sweep_create(context, grid, kappa_t, ground, line, rays * rays, &sweep);
    if (!status && bent)
        murk_sweep_bend(sweep, bent);
    if (!status)
        status = murk_sweep_run(context, sweep, &cargo, 1, 1);
    *extinguished = cargo.net_power;
    if (!status && patch && ground) {
        double undisturbed = murk_beam_on_ground(ground, sun);
        for (size_t i = 0; i < ground->patch_count; i++)
            patch[i] = (float)fmax(0, undisturbed + power[i] / murk_ground_area(ground, i));
    }
    murk_sweep_release(sweep);
    murk_free(line);
    murk_free(power);
    return status;
}
