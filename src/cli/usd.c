/* SPDX-License-Identifier: Apache-2.0 */
#include "usd.h"

#include "usd_light.h"
#include "usd_text.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the stage is of, and where its text goes. */
struct stage {
    const struct cli_job *job;
    const murk_volume *volume; /* the written one */
    const char *asset;         /* its path, from the stage's folder */
    FILE *stream;
};

static void write_head(const struct stage *stage)
{
    const struct cli_job *job = stage->job;
    FILE *s = stage->stream;
    fputs("#usda 1.0\n(\n    customLayerData = {\n        string creator = \"murk " MURK_VERSION
          "\"\n        string command = ",
          s);
    cli_usd_quote(s, job->command_line);
    fputs("\n    }\n    defaultPrim = \"World\"\n", s);
    if (job->frame)
        fprintf(s, "    endTimeCode = %d\n", *job->frame);
    fputs("    metersPerUnit = 1\n", s);
    if (job->frame)
        fprintf(s, "    startTimeCode = %d\n", *job->frame);
    fprintf(s, "    upAxis = \"%c\"\n)\n\ndef Xform \"World\"\n{\n",
            job->description.up == MURK_UP_Y ? 'Y' : 'Z');
}

/* The corners of the box of all grids in world units, where voxels are centered on their index. */
static void bound(const murk_volume *volume, double low[3], double high[3])
{
    for (int i = 0; i < 3; i++) {
        low[i] = INFINITY;
        high[i] = -INFINITY;
    }
    for (size_t g = 0; g < murk_volume_grid_count(volume); g++) {
        murk_grid_info info;
        if (murk_volume_grid_info(volume, g, &info) != MURK_OK || !info.active_voxels)
            continue;
        for (int corner = 0; corner < 8; corner++)
            for (int i = 0; i < 3; i++) {
                const double *row = &info.index_to_world[4 * i];
                double at = row[3];
                for (int a = 0; a < 3; a++)
                    at +=
                        row[a] * (corner >> a & 1 ? info.box_max[a] + 0.5 : info.box_min[a] - 0.5);
                low[i] = fmin(low[i], at);
                high[i] = fmax(high[i], at);
            }
    }
    for (int i = 0; i < 3 && low[0] > high[0]; i++)
        low[i] = high[i] = 0.0;
}

/* Readers of OpenVDB center voxels on their index; where an index is a corner, the volume is moved
   by half a voxel. */
static void write_half_voxel(const struct stage *stage)
{
    murk_grid_info info;
    double shift[3] = {0};
    const struct scene_description *description = &stage->job->description;
    if (description->band_count)
        description = description->band;
    if (!description->medium.corner || murk_volume_grid_info(stage->volume, 0, &info) != MURK_OK)
        return;
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < 3; a++)
            shift[i] += 0.5 * info.index_to_world[4 * i + a];
    fputs("        double3 xformOp:translate = ", stage->stream);
    cli_usd_vector(stage->stream, shift);
    fputs("\n        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n", stage->stream);
}

static void write_extent(const struct stage *stage)
{
    FILE *s = stage->stream;
    double low[3], high[3];
    bound(stage->volume, low, high);
    fputs("        float3[] extent", s);
    if (stage->job->frame)
        fprintf(s, ".timeSamples = {\n            %d: [", *stage->job->frame);
    else
        fputs(" = [", s);
    cli_usd_vector(s, low);
    fputs(", ", s);
    cli_usd_vector(s, high);
    fputs(stage->job->frame ? "],\n        }\n" : "]\n", s);
}

/* One field: its prim, and before that, where the volume names it. */
static void write_field(const struct stage *stage, const murk_grid_info *info)
{
    FILE *s = stage->stream;
    const bool vector = !strncmp(info->type, "vec3", 4);
    const char *marks = strchr(stage->asset, '@') ? "@@@" : "@";
    fputs("\n        def OpenVDBAsset \"", s);
    cli_usd_identifier(s, info->name);
    fputs("\"\n        {\n", s);
    if (!strcmp(info->grid_class, "fog volume"))
        fputs("            token fieldClass = \"fogVolume\"\n", s);
    fprintf(s, "            token fieldDataType = \"%s\"\n            token fieldName = ",
            vector ? "float3" : "float");
    cli_usd_quote(s, info->name);
    fputs("\n            asset filePath", s);
    if (stage->job->frame)
        fprintf(s, ".timeSamples = {\n                %d: %s%s%s,\n            }\n",
                *stage->job->frame, marks, stage->asset, marks);
    else
        fprintf(s, " = %s%s%s\n", marks, stage->asset, marks);
    if (vector)
        fputs("            token vectorDataRoleHint = \"Color\"\n", s);
    fputs("        }\n", s);
}

/* The extinction per unit of the density [1/m], where all bands have the same, else 0. */
static double extinction_scale(const struct scene *scene)
{
    murk_medium_info first = {0}, other;
    murk_medium_info_get(scene->band[0].medium, &first);
    for (size_t n = 1; n < scene->band_count; n++)
        if (murk_medium_info_get(scene->band[n].medium, &other) != MURK_OK ||
            other.extinction_scale != first.extinction_scale)
            return 0.0;
    return first.extinction_scale;
}

static void write_volume(const struct stage *stage)
{
    FILE *s = stage->stream;
    const double kappa = extinction_scale(&stage->job->scene);
    murk_grid_info info;
    fputs("    def Volume \"Medium\"", s);
    if (kappa > 0)
        fprintf(s,
                " (\n        customData = {\n            dictionary murk = {\n"
                "                double extinction_scale = %.9g\n"
                "                string material = \"absorbs extinction_scale x density [1/m], "
                "emits extinction_scale x density x radiosity / pi [W/m^3/sr], does not scatter\"\n"
                "            }\n        }\n    )",
                kappa);
    fputs("\n    {\n", s);
    write_extent(stage);
    for (size_t g = 0; g < murk_volume_grid_count(stage->volume); g++)
        if (murk_volume_grid_info(stage->volume, g, &info) == MURK_OK) {
            fputs("        rel field:", s);
            cli_usd_identifier(s, info.name);
            fputs(" = </World/Medium/", s);
            cli_usd_identifier(s, info.name);
            fputs(">\n", s);
        }
    write_half_voxel(stage);
    for (size_t g = 0; g < murk_volume_grid_count(stage->volume); g++)
        if (murk_volume_grid_info(stage->volume, g, &info) == MURK_OK)
            write_field(stage, &info);
    fputs("    }\n", s);
}

static murk_status fail(struct cli_job *job, const char *path, const char *reason)
{
    cli_error(&job->terminal, "%s: cannot be written: %s", path, reason);
    return MURK_ERROR_IO;
}

murk_status cli_usd_write(struct cli_job *job, const char *path, const char *vdb_path)
{
    murk_volume *volume = NULL;
    char *text = NULL;
    size_t size = 0;
    murk_status status = cli_job_fail(job, murk_volume_read(job->context, vdb_path, &volume));
    if (status != MURK_OK)
        return status;
    char *asset = cli_usd_relative(vdb_path, path);
    FILE *stream = asset ? open_memstream(&text, &size) : NULL;
    if (stream) {
        const struct stage stage = {job, volume, asset, stream};
        write_head(&stage);
        write_volume(&stage);
        cli_usd_camera(stream, &job->scene.camera);
        cli_usd_lights(stream, &job->scene);
        fputs("}\n", stream);
    }
    if (!stream || fclose(stream))
        status = fail(job, path, strerror(errno));
    else
        status = cli_job_fail(job, murk_file_write(job->context, path, text, size));
    free(text);
    free(asset);
    murk_volume_release(volume);
    return status;
}
