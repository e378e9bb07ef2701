/* SPDX-License-Identifier: Apache-2.0 */
/* A solution to VDB. */
#include "solution.h"
#include "volume.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { GRIDS_MAX = 5, META_MAX = 40 };

/* The places of a grid as bricks, to be written with other values. */
static murk_bricks view_bricks(const murk_grid *grid, float *values, const double matrix[16])
{
    murk_bricks bricks = {
        .count = grid->brick_count, .brick = grid->brick, .mask = grid->mask, .values = values};
    memcpy(bricks.index_to_world, matrix, sizeof bricks.index_to_world);
    return bricks;
}

/* The transform of a grid frame, with voxel centres at integer indices. */
static void make_transform(const murk_grid *grid, double matrix[16])
{
    memset(matrix, 0, 16 * sizeof *matrix);
    matrix[15] = 1;
    for (int row = 0; row < 3; row++) {
        matrix[4 * row + 3] = grid->corner[row];
        for (int a = 0; a < 3; a++) {
            double step = grid->axis[a][row] * grid->voxel[a];
            matrix[4 * row + a] = step;
            matrix[4 * row + 3] += step * (0.5 - grid->lo[a]);
        }
    }
}

typedef struct zone {
    double kappa_t, albedo, radiosity;
} zone;

static double find_extinction(const zone *z)
{
    return z->kappa_t;
}

static double find_albedo(const zone *z)
{
    return z->albedo;
}

/* kappa_t B / pi: what a zone emits per volume and solid angle, as in [BG91] eq. (11). */
static double find_emission(const zone *z)
{
    return z->kappa_t * z->radiosity / 3.14159265358979323846;
}

/* A value of each zone on the medium's input voxels, 0 where there is no zone. */
static float *make_values(const murk_solution *solution, double (*find)(const zone *))
{
    const murk_medium *medium = solution->medium;
    const murk_grid *input = medium->input, *zones = medium->grid;
    float *values = murk_alloc(input->brick_count * MURK_BRICK_SLOTS, sizeof *values);
    for (size_t b = 0; values && b < input->brick_count; b++) {
        const int32_t *c = input->brick[b];
        int32_t from = murk_grid_find(zones, c[0], c[1], c[2]);
        int32_t lit = murk_grid_find(solution->grid, c[0], c[1], c[2]);
        for (int slot = 0; slot < MURK_BRICK_SLOTS && from != MURK_NO_BRICK; slot++) {
            if (!murk_grid_active(zones, (size_t)from, slot))
                continue;
            size_t k = (size_t)from * MURK_BRICK_SLOTS + (size_t)slot;
            zone z = {.kappa_t = medium->kappa_t[k], .albedo = murk_value(&medium->albedo, k)};
            if (lit != MURK_NO_BRICK)
                z.radiosity = solution->radiosity[(size_t)lit * MURK_BRICK_SLOTS + (size_t)slot];
            values[b * MURK_BRICK_SLOTS + (size_t)slot] = (float)find(&z);
        }
    }
    return values;
}

/* The grids to write and the arrays behind them. */
typedef struct output {
    const murk_solution *solution;
    double matrix[16];
    murk_vdb_grid grid[GRIDS_MAX];
    murk_bricks bricks[GRIDS_MAX];
    float *made[GRIDS_MAX];
    size_t count;
} output;

static murk_status add_grid(output *o, const char *name, double (*find)(const zone *))
{
    size_t i = o->count++;
    const murk_solution *solution = o->solution;
    float *values = solution->radiosity;
    if (find) {
        values = o->made[i] = make_values(solution, find);
        if (!values)
            return murk_fail(solution->context, MURK_ERROR_MEMORY, "grid %s: out of memory", name);
    }
    o->bricks[i] = view_bricks(find ? solution->medium->input : solution->grid, values, o->matrix);
    o->grid[i] = (murk_vdb_grid){.name = name, .bricks = &o->bricks[i]};
    return MURK_OK;
}

static murk_status add_pass(output *o, const murk_volume *source, int64_t index)
{
    const char *name = murk_vdb_info(source->vdb, (size_t)index)->name;
    murk_status status = murk_volume_check(o->solution->context, source, (size_t)index);
    if (status)
        return status;
    for (size_t i = 0; i < o->count; i++)
        if (murk_volume_same_name(name, o->grid[i].name))
            return murk_fail(o->solution->context, MURK_ERROR_INPUT,
                             "%s: grid %s has the name of one that murk writes; rename it",
                             murk_vdb_path(source->vdb), name);
    o->grid[o->count++] = (murk_vdb_grid){.pass = source->vdb, .pass_index = (size_t)index};
    return MURK_OK;
}

static size_t fill_metadata(const murk_solution *solution, const char *command, char sun[128],
                            murk_vdb_meta meta[META_MAX])
{
    const murk_report *r = &solution->report;
    const double *d = solution->sun.direction;
    snprintf(sun, 128, "%.9g %.9g %.9g", d[0], d[1], d[2]);
    const murk_vdb_meta all[] = {
        {"murk_version", MURK_VERSION, 0},
        {"command", command, 0},
        {"units", "W/m^2", 0},
        {"convention",
         "radiosity is pi times the isotropic source function; a voxel emits radiosity/pi per unit "
         "optical depth",
         0},
        {"band", "single", 0},
        {"method", r->method, 0},
        {"sun_direction", sun, 0},
        {"sun_irradiance", NULL, solution->sun.irradiance},
        {"sky_radiance", NULL, solution->sky_radiance},
        {"zones", NULL, (double)r->zones},
        {"patches", NULL, (double)r->patches},
        {"tolerance", NULL, r->tolerance},
        {"error_estimate", NULL, r->estimate},
        {"tolerance_reached", r->reached ? "yes" : "no", 0},
        {"energy_emitted", NULL, r->energy_emitted},
        {"energy_sun", NULL, r->energy_sun},
        {"energy_diffuse", NULL, r->energy_diffuse},
        {"energy_absorbed", NULL, r->energy_absorbed},
        {"energy_escaped", NULL, r->energy_escaped},
        {"energy_balance", NULL, r->energy_balance},
    };
    size_t count = 0;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        bool absent = (!strcmp(all[i].name, "command") && !command) ||
                      (!strcmp(all[i].name, "method") && !r->method);
        if (!absent)
            meta[count++] = all[i];
    }
    return count;
}

murk_status murk_solution_write(const murk_solution *solution, const char *path,
                                const murk_write_options *options)
{
    static const murk_write_options defaults = MURK_WRITE_DEFAULT;
    if (!options)
        options = &defaults;
    output o = {.solution = solution};
    make_transform(solution->grid, o.matrix);
    int64_t pass = options->source ? murk_volume_choose(options->source) : MURK_NO_GRID;
    murk_status status = add_grid(&o, "radiosity", NULL);
    if (!status && options->emission_coefficient)
        status = add_grid(&o, "emission_coefficient", find_emission);
    if (!status && options->extinction)
        status = add_grid(&o, "extinction", find_extinction);
    if (!status && options->albedo)
        status = add_grid(&o, "albedo", find_albedo);
    if (!status && pass != MURK_NO_GRID)
        status = add_pass(&o, options->source, pass);
    if (!status) {
        murk_vdb_meta meta[META_MAX];
        char sun[128];
        size_t meta_count = fill_metadata(solution, options->command, sun, meta);
        status = murk_vdb_write(solution->context, path, o.grid, o.count, meta, meta_count,
                                pass != MURK_NO_GRID ? options->source->vdb : NULL,
                                pass != MURK_NO_GRID ? (size_t)pass : 0, options->half);
    }
    for (size_t i = 0; i < o.count; i++)
        murk_free(o.made[i]);
    return status;
}
