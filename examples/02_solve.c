/* SPDX-License-Identifier: Apache-2.0 */
/* Lights smoke by the sun and keeps its radiosity: 02_solve SMOKE.vdb RADIOSITY.vdb */
#include <murk/murk.h>

#include <stdio.h>

static murk_status make_medium(murk_context *context, const murk_volume *volume, murk_medium **out)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction = (murk_quantity){.grid = murk_volume_density(volume), .scale = 20.0};
    options.albedo.value = 0.9;
    options.corner = true; /* Mantaflow's voxels cover [i, i + 1] */
    return murk_medium_from_volume(context, volume, &options, out);
}

static void print_report(const murk_report *report)
{
    printf("%llu zones solved in %d iterations over %d directions\n",
           (unsigned long long)report->zones, report->iterations, report->directions);
    printf("estimated error %.2g %%, of %.2g %% asked for\n", 100 * report->estimate,
           100 * report->tolerance);
    printf("of %.3g W of sunlight %.3g W were absorbed and %.3g W escaped\n", report->energy_sun,
           report->energy_absorbed, report->energy_escaped);
}

/* MURK_NOT_REACHED delivers a solution too: written, and then told of. */
static murk_status solve(murk_context *context, const murk_volume *volume,
                         const murk_medium *medium, const char *path)
{
    const murk_scene scene = {
        .medium = medium,
        .sun = {.direction = {0.82, 0.30, -0.48}, .irradiance = 1.0},
        .sky_radiance = 0.0,
    };
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.02;
    murk_solution *solution;
    murk_status status = murk_solve(context, &scene, &options, &solution);
    if (status && status != MURK_NOT_REACHED)
        return status;
    print_report(murk_solution_report(solution));
    murk_write_options grids = MURK_WRITE_DEFAULT;
    grids.source = volume; /* passes the density through */
    grids.command = "02_solve";
    murk_status written = murk_solution_write(solution, path, &grids);
    murk_solution_release(solution);
    return written ? written : status;
}

static murk_status run(murk_context *context, const char *input, const char *output)
{
    murk_volume *volume = NULL;
    murk_medium *medium = NULL;
    murk_status status = murk_volume_read(context, input, &volume);
    if (!status)
        status = make_medium(context, volume, &medium);
    if (!status)
        status = solve(context, volume, medium, output);
    murk_medium_release(medium);
    murk_volume_release(volume);
    return status;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: %s SMOKE.vdb RADIOSITY.vdb\n", argv[0]);
        return 1;
    }
    murk_context *context;
    murk_status status = murk_context_create(NULL, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    status = run(context, argv[1], argv[2]);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_context_release(context);
    return status != MURK_OK;
}
