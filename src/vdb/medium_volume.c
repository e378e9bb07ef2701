/* SPDX-License-Identifier: Apache-2.0 */
/* A medium from the grids of a volume. */
#include "medium.h"
#include "resample.h"
#include "volume.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What is being put together. */
typedef struct assembly {
    murk_context *context;
    const murk_volume *volume;
    const murk_medium_options *options;
    const char *path;
    size_t extinction; /* number of the grid */
    murk_medium_parts parts;
} assembly;

static murk_status check_number(const assembly *a, const char *key, double number)
{
    if (number >= 0 && isfinite(number))
        return MURK_OK;
    return murk_fail(a->context, MURK_ERROR_INPUT, "%s: %s %g; give a number of at least 0",
                     a->path, key, number);
}

/* Whether the extinction is one value wherever the grid is positive. */
static bool is_uniform(const murk_quantity *extinction)
{
    return !extinction->grid && extinction->value != MURK_FROM_GRID;
}

static murk_status check_options(const assembly *a)
{
    const murk_medium_options *options = a->options;
    const struct {
        const char *key;
        double number;
    } numbers[] = {
        {"extinction", is_uniform(&options->extinction) ? options->extinction.value : 0},
        {"extinction scale", options->extinction.scale},
        {"albedo", options->albedo.grid ? 0 : options->albedo.value},
        {"albedo scale", options->albedo.grid ? options->albedo.scale : 0},
        {"emission", options->emission.grid ? 0 : options->emission.value},
        {"emission scale", options->emission.grid ? options->emission.scale : 0},
        {"temperature", options->temperature.grid ? 0 : options->temperature.value},
        {"temperature scale", options->temperature.grid ? options->temperature.scale : 0},
        {"voxel size", options->voxel_size},
    };
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers && !status; i++)
        status = check_number(a, numbers[i].key, numbers[i].number);
    return status;
}

static murk_status find_extinction(assembly *a)
{
    if (a->options->extinction.grid)
        return murk_volume_find(a->context, a->volume, a->options->extinction.grid, &a->extinction);
    int64_t chosen = murk_volume_choose(a->volume);
    if (chosen != MURK_NO_GRID) {
        a->extinction = (size_t)chosen;
        return murk_volume_check(a->context, a->volume, a->extinction);
    }
    if (!murk_vdb_count(a->volume->vdb))
        return murk_fail(a->context, MURK_ERROR_INPUT, "%s: no grids; give a file with a density",
                         a->path);
    char names[600];
    murk_volume_list(a->volume, NULL, names, sizeof names);
    return murk_fail(a->context, MURK_ERROR_INPUT,
                     "%s: no grid looks like a density; name the one to use, with --grid or as "
                     "\"extinction\": {\"grid\": NAME}, of %s",
                     a->path, names);
}

/* Two grids on the same transform: within a thousandth of a voxel near the origin. */
static bool is_same_transform(const murk_grid_info *one, const murk_grid_info *two)
{
    double voxel = fmin(fmin(one->voxel_size[0], one->voxel_size[1]), one->voxel_size[2]);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++) {
            double tolerance = (column < 3 ? 1e-6 : 1e-3) * voxel;
            int i = 4 * row + column;
            if (!(fabs(one->index_to_world[i] - two->index_to_world[i]) <= tolerance))
                return false;
        }
    return true;
}

/* Puts a quantity that lies on another transform onto the voxels of the extinction. */
static murk_status resample(const assembly *a, size_t index, const char *quantity,
                            murk_absence absence, murk_bricks *bricks)
{
    const murk_grid_info *one = murk_vdb_info(a->volume->vdb, a->extinction);
    const murk_grid_info *two = murk_vdb_info(a->volume->vdb, index);
    const murk_resample_options options = {.absence = absence, .corner = a->options->corner};
    murk_bricks target = a->parts.kappa_t, resampled;
    murk_resample_report report;
    if (!bricks->count || !target.count || is_same_transform(one, two))
        return MURK_OK;
    memcpy(target.index_to_world, one->index_to_world, sizeof target.index_to_world);
    murk_status status = murk_resample(a->context, bricks, &target, &options, &resampled, &report);
    if (status)
        return status;
    murk_bricks_clear(bricks);
    *bricks = resampled;
    if (report.invalid && a->options->strict)
        return murk_fail(a->context, MURK_ERROR_INPUT,
                         "%s: the %s grid %s has %llu voxels that are NaN or infinite; mend the "
                         "grid or leave out --strict to pass over them",
                         a->path, quantity, two->name, (unsigned long long)report.invalid);
    if (report.invalid)
        murk_warn(a->context,
                  "%s: the %s grid %s has %llu voxels that are NaN or infinite: passed over",
                  a->path, quantity, two->name, (unsigned long long)report.invalid);
    if (!report.covered)
        murk_warn(a->context,
                  "%s: the %s grid %s lies beside %s on its transform: its background holds",
                  a->path, quantity, two->name, one->name);
    else
        murk_note(a->context,
                  "%s: the %s grid %s is on another transform than %s: resampled onto its voxels",
                  a->path, quantity, two->name, one->name);
    return MURK_OK;
}

/* All three axes by the ratio of the size asked for to that of the first axis; the place of voxel
   (0, 0, 0) stays. */
static void override_voxel_size(const assembly *a, murk_bricks *bricks)
{
    if (!(a->options->voxel_size > 0))
        return;
    double ratio =
        a->options->voxel_size / murk_vdb_info(a->volume->vdb, a->extinction)->voxel_size[0];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            bricks->index_to_world[4 * row + column] *= ratio;
}

/* The scale out of 1, 2, 5, 10, ... that brings the deepest column nearest to 5 optical depths:
   coarse steps, so that the frames of a sequence mostly agree. */
static double choose_scale(const assembly *a)
{
    const murk_grid_info *info = murk_vdb_info(a->volume->vdb, a->extinction);
    double depth = info->max_depth;
    if (a->options->voxel_size > 0)
        depth *= a->options->voxel_size / info->voxel_size[0];
    if (!(depth > 0) || !isfinite(5 / depth))
        return 1;
    double decade = pow(10, floor(log10(5 / depth))), best = decade;
    const double steps[] = {2, 5, 10};
    for (int i = 0; i < 3; i++)
        if (fabs(log(steps[i] * decade * depth / 5)) < fabs(log(best * depth / 5)))
            best = steps[i] * decade;
    return best;
}

static murk_status take_extinction(assembly *a)
{
    murk_bricks *bricks = &a->parts.kappa_t;
    const murk_quantity *quantity = &a->options->extinction;
    murk_status status = murk_vdb_bricks(a->context, a->volume->vdb, a->extinction, 0, bricks);
    if (status)
        return status;
    override_voxel_size(a, bricks);
    bool uniform = is_uniform(quantity);
    double scale = quantity->scale > 0 ? quantity->scale : choose_scale(a);
    a->parts.extinction_scale = uniform ? 0 : scale;
    for (size_t i = 0; i < bricks->count * MURK_BRICK_SLOTS; i++) {
        float *value = &bricks->values[i];
        if (!uniform)
            *value *= (float)scale;
        else if (*value > 0 && isfinite(*value))
            *value = (float)quantity->value;
    }
    return MURK_OK;
}

static murk_status take_quantity(assembly *a, const murk_quantity *quantity, const char *name,
                                 murk_absence absence, murk_bricks *bricks, double *scale,
                                 double *value)
{
    *value = quantity->value;
    *scale = quantity->scale;
    if (!quantity->grid)
        return MURK_OK;
    size_t index;
    murk_status status = murk_volume_find(a->context, a->volume, quantity->grid, &index);
    if (!status)
        status = murk_vdb_bricks(a->context, a->volume->vdb, index, 0, bricks);
    if (!status)
        status = resample(a, index, name, absence, bricks);
    if (status)
        return status;
    override_voxel_size(a, bricks);
    if (!bricks->count) /* its background holds everywhere */
        *value = bricks->background * quantity->scale;
    return MURK_OK;
}

murk_status murk_medium_from_volume(murk_context *context, const murk_volume *volume,
                                    const murk_medium_options *options, murk_medium **out)
{
    static const murk_medium_options defaults = MURK_MEDIUM_DEFAULT;
    assembly a = {.context = context,
                  .volume = volume,
                  .options = options ? options : &defaults,
                  .path = murk_vdb_path(volume->vdb)};
    murk_medium_parts *parts = &a.parts;
    char where[800];
    parts->corner = a.options->corner;
    parts->band = a.options->band;
    parts->asymmetry = a.options->asymmetry;
    parts->strict = a.options->strict;
    parts->where = where;
    murk_status status = check_options(&a);
    if (!status)
        status = find_extinction(&a);
    if (!status) {
        parts->extinction_grid = murk_vdb_info(volume->vdb, a.extinction)->name;
        snprintf(where, sizeof where, "%.500s, grid %.250s", a.path, parts->extinction_grid);
        status = take_extinction(&a);
    }
    if (!status)
        status = take_quantity(&a, &a.options->albedo, "albedo", MURK_ABSENT_IS_UNKNOWN,
                               &parts->albedo, &parts->albedo_scale, &parts->albedo_value);
    if (!status)
        status = take_quantity(&a, &a.options->emission, "emission", MURK_ABSENT_IS_BACKGROUND,
                               &parts->emission, &parts->emission_scale, &parts->emission_value);
    if (!status)
        status = take_quantity(&a, &a.options->temperature, "temperature", MURK_ABSENT_IS_UNKNOWN,
                               &parts->temperature, &parts->temperature_scale,
                               &parts->temperature_value);
    if (!status && a.options->temperature.grid) {
        parts->temperature_offset = a.options->temperature_offset;
        parts->temperature_value += a.options->temperature_offset;
    }
    if (!status)
        return murk_medium_build(context, parts, out);
    murk_bricks_clear(&parts->kappa_t);
    murk_bricks_clear(&parts->albedo);
    murk_bricks_clear(&parts->emission);
    murk_bricks_clear(&parts->temperature);
    return status;
}
