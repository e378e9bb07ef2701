/* SPDX-License-Identifier: Apache-2.0 */
/* Solutions to VDB. */
#include "band_set.h"
#include "metadata.h"
#include "murk/bands.h"
#include "volume.h"

#include <stdio.h>
#include <string.h>

enum { QUANTITIES = 4, NAME_LENGTH = 64 };

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

/* What is written of each band; find NULL: the radiosity as it stands in the solution. */
typedef struct quantity {
    const char *name;
    double (*find)(const zone *);
} quantity;

/* One grid to write: a quantity of one band, or of three. */
typedef struct layer {
    char name[NAME_LENGTH];
    murk_bricks bricks;
    float *made[3];
} layer;

typedef struct output {
    murk_band_set set;
    bool coloured; /* bands R, G and B are there: */
    size_t colour[3];
    double matrix[16];
    murk_vdb_grid *grid;
    layer *layer; /* behind each of the grids */
    size_t count;
} output;

static murk_status create_output(const murk_band_set *set, const char *path, output *out)
{
    const murk_solution *first = set->solution[0];
    size_t capacity = QUANTITIES * set->count + 1;
    murk_status status = murk_band_set_check(set, strcmp(path, "-") ? path : "standard output");
    if (status)
        return status;
    output o = {.set = *set,
                .grid = murk_alloc(capacity, sizeof *o.grid),
                .layer = murk_alloc(capacity, sizeof *o.layer)};
    o.coloured = murk_band_set_colours(set, o.colour);
    make_transform(first->grid, o.matrix);
    *out = o;
    if (!o.grid || !o.layer)
        return murk_fail(first->context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    return MURK_OK;
}

static void clear_output(output *o)
{
    for (size_t i = 0; i < o->count; i++)
        for (int c = 0; c < 3; c++)
            murk_free(o->layer[i].made[c]);
    murk_free(o->layer);
    murk_free(o->grid);
}

/* Adds the grid of one band, with its name behind the quantity's unless that is NULL, or of the
   bands of three components. */
static murk_status add_layer(output *o, const quantity *q, const char *name, const size_t *band,
                             int components)
{
    layer *l = &o->layer[o->count];
    murk_vdb_grid *grid = &o->grid[o->count++];
    const murk_solution *solution = o->set.solution[band[0]];
    float *values[3] = {NULL};
    snprintf(l->name, sizeof l->name, "%s%s%s", q->name, name ? "_" : "", name ? name : "");
    for (int c = 0; c < components; c++) {
        solution = o->set.solution[band[c]];
        values[c] = solution->radiosity;
        if (q->find)
            values[c] = l->made[c] = make_values(solution, q->find);
        if (!values[c])
            return murk_fail(o->set.solution[0]->context, MURK_ERROR_MEMORY,
                             "grid %s: out of memory", l->name);
    }
    l->bricks =
        view_bricks(q->find ? solution->medium->input : solution->grid, values[0], o->matrix);
    *grid = (murk_vdb_grid){.name = l->name, .bricks = &l->bricks, .y = values[1], .z = values[2]};
    return MURK_OK;
}

static murk_status add_quantity(output *o, const char *name, double (*find)(const zone *))
{
    const quantity q = {name, find};
    murk_status status = o->coloured ? add_layer(o, &q, NULL, o->colour, 3) : MURK_OK;
    for (size_t i = 0; i < o->set.count && !status; i++) {
        const char *band = o->set.count > 1 ? o->set.name[i] : NULL;
        if (!o->coloured || murk_band_component(band) < 0)
            status = add_layer(o, &q, band, &i, 1);
    }
    return status;
}

static murk_status add_extinction(output *o)
{
    const quantity q = {"extinction", find_extinction};
    const size_t any = 0;
    return murk_band_set_one_extinction(&o->set) ? add_layer(o, &q, NULL, &any, 1)
                                                 : add_quantity(o, q.name, q.find);
}

/* The grid that goes with the solution as it is: that of the extinction, else the density. */
static int64_t find_pass(const murk_volume *source, const murk_medium *medium)
{
    const char *name = medium->extinction_grid;
    for (size_t i = 0; source && name && i < murk_vdb_count(source->vdb); i++)
        if (!strcmp(murk_vdb_info(source->vdb, i)->name, name))
            return (int64_t)i;
    return source ? murk_volume_choose(source) : MURK_NO_GRID;
}

static murk_status add_pass(output *o, const murk_volume *source, int64_t index)
{
    murk_context *context = o->set.solution[0]->context;
    const char *name = murk_vdb_info(source->vdb, (size_t)index)->name;
    murk_status status = murk_volume_check(context, source, (size_t)index);
    if (status)
        return status;
    for (size_t i = 0; i < o->count; i++)
        if (murk_volume_same_name(name, o->grid[i].name))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "%s: grid %s has the name of one that murk writes; rename it",
                             murk_vdb_path(source->vdb), name);
    o->grid[o->count++] = (murk_vdb_grid){.pass = source->vdb, .pass_index = (size_t)index};
    return MURK_OK;
}

static murk_status add_grids(output *o, const murk_write_options *options, int64_t pass)
{
    murk_status status = add_quantity(o, "radiosity", NULL);
    if (!status && options->emission_coefficient)
        status = add_quantity(o, "emission_coefficient", find_emission);
    if (!status && options->extinction)
        status = add_extinction(o);
    if (!status && options->albedo)
        status = add_quantity(o, "albedo", find_albedo);
    if (!status && pass != MURK_NO_GRID)
        status = add_pass(o, options->source, pass);
    return status;
}

murk_status murk_solutions_write(const murk_solution *const *solution, const char *const *name,
                                 size_t count, const char *path, const murk_write_options *options)
{
    static const murk_write_options defaults = MURK_WRITE_DEFAULT;
    if (!count)
        return MURK_ERROR_INPUT; /* without a context for words */
    if (!options)
        options = &defaults;
    const murk_band_set set = {.solution = solution, .name = name, .count = count};
    int64_t pass = find_pass(options->source, solution[0]->medium);
    output o = {.count = 0};
    murk_metadata metadata = {0};
    murk_status status = create_output(&set, path, &o);
    if (!status)
        status = add_grids(&o, options, pass);
    if (!status)
        status = murk_metadata_make(&set, options->command, &metadata);
    if (!status)
        status = murk_vdb_write(solution[0]->context, path, o.grid, o.count, metadata.entry,
                                metadata.count, pass != MURK_NO_GRID ? options->source->vdb : NULL,
                                pass != MURK_NO_GRID ? (size_t)pass : 0, options->half);
    murk_metadata_clear(&metadata);
    clear_output(&o);
    return status;
}

murk_status murk_solution_write(const murk_solution *solution, const char *path,
                                const murk_write_options *options)
{
    return murk_solutions_write(&solution, NULL, 1, path, options);
}
