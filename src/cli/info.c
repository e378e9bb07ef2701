/* SPDX-License-Identifier: Apache-2.0 */
#include "info.h"

#include "columns.h"
#include "job.h"
#include "report.h"
#include "sequence.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 8 };

/* What murk makes of the file at the options given. */
struct verdict {
    const char *density; /* grid that the extinction comes from; NULL: none */
    bool medium;         /* there is one, described by info */
    char why_not[SCENE_MESSAGE_SIZE];
    murk_medium_info info;
};

static bool is_empty(const murk_grid_info *grid)
{
    return grid->active_voxels == 0;
}

static bool is_level_set(const murk_grid_info *grid)
{
    return grid->readable && !strcmp(grid->grid_class, "level set");
}

static void add_row(struct cli_columns *rows, const murk_grid_info *grid)
{
    const int32_t *lo = grid->box_min, *hi = grid->box_max;
    const double *size = grid->voxel_size;
    cli_columns_add(rows, "%s", grid->name);
    cli_columns_add(rows, "%s", grid->type);
    cli_columns_add(rows, "%s", grid->grid_class);
    cli_columns_add(rows, "%llu", (unsigned long long)grid->active_voxels);
    if (is_empty(grid))
        cli_columns_add(rows, "empty");
    else
        cli_columns_add(rows, "[%d %d %d]..[%d %d %d]", lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]);
    if (fmax(fabs(size[1] - size[0]), fabs(size[2] - size[0])) <= 1e-6 * size[0])
        cli_columns_add(rows, "%.6g", size[0]);
    else
        cli_columns_add(rows, "%.6g x %.6g x %.6g", size[0], size[1], size[2]);
    if (grid->readable) {
        cli_columns_add(rows, "%.4g..%.4g", grid->value_min, grid->value_max);
        cli_columns_add(rows, "%.4g mean, %.4g max", grid->mean_depth, grid->max_depth);
    } else {
        cli_columns_add(rows, "-");
        cli_columns_add(rows, "-");
    }
}

static void print_remarks(const murk_grid_info *grid)
{
    if (!grid->readable)
        printf("%s: not readable: %s\n", grid->name, grid->unreadable ? grid->unreadable : "");
    if (grid->invalid_voxels)
        printf("%s: %llu voxels are NaN, infinite or negative, and count as empty\n", grid->name,
               (unsigned long long)grid->invalid_voxels);
    if (is_level_set(grid))
        printf("%s: a surface; --grid makes its inside a medium, and values are the part of each "
               "voxel that is inside\n",
               grid->name);
    else if (grid->readable && grid->nonzero_voxels < grid->active_voxels)
        printf("%s: %llu active voxels are zero\n", grid->name,
               (unsigned long long)(grid->active_voxels - grid->nonzero_voxels));
}

static void print_verdict(const struct verdict *verdict)
{
    const murk_medium_info *info = &verdict->info;
    if (!verdict->medium) {
        printf("murk takes no medium from it: %s\n", verdict->why_not);
        return;
    }
    if (info->extinction_scale > 0.0)
        printf("murk takes %g x %s as the extinction", info->extinction_scale, verdict->density);
    else
        printf("murk takes the same extinction wherever %s is positive", verdict->density);
    printf(": %llu zones, at most %.4g per m; optical depth %.4g mean, %.4g max\n",
           (unsigned long long)info->zones, info->kappa_t_max, info->mean_depth, info->max_depth);
}

static murk_status print_table(const struct cli_job *job, const struct verdict *verdict)
{
    static const char *const HEAD[COLUMNS] = {
        "grid", "type",           "class",  "active voxels",
        "box",  "voxel size [m]", "values", "depth at scale 1"};
    const murk_volume *volume = job->scene.volume;
    const char *path = job->options->input;
    size_t count = murk_volume_grid_count(volume);
    struct cli_columns rows = {.columns = COLUMNS, .gap = 2, .left = ~0u};
    murk_grid_info grid;
    for (int c = 0; c < COLUMNS; c++)
        cli_columns_add(&rows, "%s", HEAD[c]);
    for (size_t i = 0; i < count; i++)
        if (murk_volume_grid_info(volume, i, &grid) == MURK_OK)
            add_row(&rows, &grid);
    printf("%s: %zu grid%s\n", path, count, count == 1 ? "" : "s");
    murk_status status = cli_columns_print(&rows);
    if (status == MURK_OK) {
        for (size_t i = 0; i < count; i++)
            if (murk_volume_grid_info(volume, i, &grid) == MURK_OK)
                print_remarks(&grid);
        print_verdict(verdict);
        if (job->frame)
            printf("\n");
    }
    return status;
}

static json_t *box_json(const int32_t corner[3])
{
    return json_pack("[i,i,i]", (int)corner[0], (int)corner[1], (int)corner[2]);
}

static json_t *grid_json(const murk_grid_info *grid)
{
    json_t *object = json_object();
    bool empty = is_empty(grid);
    json_object_set_new(object, "name", cli_json_text(grid->name));
    json_object_set_new(object, "type", cli_json_text(grid->type));
    json_object_set_new(object, "class", cli_json_text(grid->grid_class));
    json_object_set_new(object, "readable", json_boolean(grid->readable));
    json_object_set_new(object, "unreadable", cli_json_text(grid->unreadable));
    json_object_set_new(object, "active_voxels", json_integer((json_int_t)grid->active_voxels));
    json_object_set_new(object, "active_tiles", json_integer((json_int_t)grid->active_tiles));
    json_object_set_new(object, "nonzero_voxels", json_integer((json_int_t)grid->nonzero_voxels));
    json_object_set_new(object, "invalid_voxels", json_integer((json_int_t)grid->invalid_voxels));
    json_object_set_new(object, "box_min", empty ? json_null() : box_json(grid->box_min));
    json_object_set_new(object, "box_max", empty ? json_null() : box_json(grid->box_max));
    json_object_set_new(object, "voxel_size", cli_json_numbers(grid->voxel_size, 3));
    json_object_set_new(object, "index_to_world", cli_json_numbers(grid->index_to_world, 16));
    json_object_set_new(object, "value_min", cli_json_number(grid->value_min));
    json_object_set_new(object, "value_max", cli_json_number(grid->value_max));
    json_object_set_new(object, "mean_depth", cli_json_number(grid->mean_depth));
    json_object_set_new(object, "max_depth", cli_json_number(grid->max_depth));
    return object;
}

static json_t *medium_json(const struct verdict *verdict)
{
    const murk_medium_info *info = &verdict->info;
    json_t *object = json_object();
    if (!verdict->medium) {
        json_object_set_new(object, "error", cli_json_text(verdict->why_not));
        return object;
    }
    json_object_set_new(object, "extinction", cli_json_text(verdict->density));
    json_object_set_new(object, "extinction_scale", cli_json_number(info->extinction_scale));
    json_object_set_new(object, "zones", json_integer((json_int_t)info->zones));
    json_object_set_new(object, "bricks", json_integer((json_int_t)info->bricks));
    json_object_set_new(object, "input_voxels", json_integer((json_int_t)info->input_voxels));
    json_object_set_new(object, "invalid_voxels", json_integer((json_int_t)info->invalid_voxels));
    json_object_set_new(object, "voxel_size", cli_json_numbers(info->voxel_size, 3));
    json_object_set_new(object, "box_min", cli_json_numbers(info->box_min, 3));
    json_object_set_new(object, "box_max", cli_json_numbers(info->box_max, 3));
    json_object_set_new(object, "kappa_t_max", cli_json_number(info->kappa_t_max));
    json_object_set_new(object, "mean_depth", cli_json_number(info->mean_depth));
    json_object_set_new(object, "max_depth", cli_json_number(info->max_depth));
    return object;
}

static murk_status print_object(const struct cli_job *job, const struct verdict *verdict)
{
    const murk_volume *volume = job->scene.volume;
    json_t *grids = json_array();
    murk_grid_info grid;
    for (size_t i = 0; i < murk_volume_grid_count(volume); i++) {
        murk_status status = murk_volume_grid_info(volume, i, &grid);
        if (status != MURK_OK) {
            json_decref(grids);
            return status;
        }
        json_array_append_new(grids, grid_json(&grid));
    }
    json_t *object = json_object();
    json_object_set_new(object, "murk", json_string(MURK_VERSION));
    if (job->frame) {
        json_object_set_new(object, "frame", json_integer(*job->frame));
        json_object_set_new(object, "status", json_string("done"));
    }
    json_object_set_new(object, "file", cli_json_text(job->options->input));
    json_object_set_new(object, "grids", grids);
    json_object_set_new(object, "medium", medium_json(verdict));
    cli_print_json(object);
    return MURK_OK;
}

/* A file that holds no medium is no error here: info says why. */
static void judge(struct cli_job *job, struct verdict *verdict)
{
    const murk_medium_options *options = &job->description.medium;
    *verdict = (struct verdict){.density = options->extinction.grid};
    if (!verdict->density)
        verdict->density = murk_volume_density(job->scene.volume);
    murk_medium *medium = NULL;
    murk_status status = murk_medium_from_volume(job->context, job->scene.volume, options, &medium);
    if (status == MURK_OK)
        status = murk_medium_info_get(medium, &verdict->info);
    verdict->medium = status == MURK_OK;
    if (status != MURK_OK)
        snprintf(verdict->why_not, sizeof verdict->why_not, "%s",
                 murk_context_message(job->context));
    murk_medium_release(medium);
}

/* There are no outputs to check, and nothing is left to do after the last frame. */
static murk_status nothing(struct cli_job *job)
{
    (void)job;
    return MURK_OK;
}

static murk_status tell(struct cli_job *job)
{
    struct verdict verdict;
    murk_status status = cli_job_read(job);
    if (status != MURK_OK)
        return status;
    judge(job, &verdict);
    status = job->options->json ? print_object(job, &verdict) : print_table(job, &verdict);
    if (status != MURK_OK)
        cli_error(&job->terminal, "%s: %s", job->options->input, murk_status_text(status));
    return status;
}

int cli_info(const struct cli_options *options, const char *command_line)
{
    static const struct cli_steps STEPS = {.check = nothing, .work = tell, .finish = nothing};
    return cli_run(options, "info", command_line, &STEPS);
}
