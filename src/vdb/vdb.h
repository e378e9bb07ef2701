/* SPDX-License-Identifier: Apache-2.0 */
/* The thin C face of OpenVDB: the only header through which the library sees VDB files. No entry
   lets an exception out; each returns a status with its message in the context. */
#ifndef MURK_VDB_VDB_H
#define MURK_VDB_VDB_H

#include "bricks.h"
#include "murk/murk.h"

#ifdef __cplusplus
#define MURK_NOEXCEPT noexcept
extern "C" {
#else
#define MURK_NOEXCEPT
#endif

/* The module is compiled with default visibility for the sake of OpenVDB's templates; these names
   are the library's own all the same. */
#pragma GCC visibility push(hidden)

/* The grids of one file or stream. */
typedef struct murk_vdb murk_vdb;

murk_status murk_vdb_read(murk_context *context, const char *path, murk_vdb **out) MURK_NOEXCEPT;
void murk_vdb_release(murk_vdb *vdb) MURK_NOEXCEPT;
size_t murk_vdb_count(const murk_vdb *vdb) MURK_NOEXCEPT;
/* Filled at reading time; strings belong to vdb. */
const murk_grid_info *murk_vdb_info(const murk_vdb *vdb, size_t index) MURK_NOEXCEPT;
/* The path it came from, "standard input" for "-". */
const char *murk_vdb_path(const murk_vdb *vdb) MURK_NOEXCEPT;
/* The file metadata "band", or "". */
const char *murk_vdb_band(const murk_vdb *vdb) MURK_NOEXCEPT;

/* A number of the file metadata whose key starts with "asymmetry", or NaN. */
double murk_vdb_asymmetry_of(const murk_vdb *vdb, const char *key) MURK_NOEXCEPT;

/* Components that murk_vdb_bricks() can take of a grid: 1 where its info says readable, 3 of a
   vec3s "radiosity", 0 of any other. */
int murk_vdb_components(const murk_vdb *vdb, size_t index) MURK_NOEXCEPT;

/* Copies a component of a grid into bricks sorted by (x, y, z), active tiles expanded; values are
   passed on as they are (NaN and negative included). Of a level set, the part of each voxel that is
   inside, where there is any. */
murk_status murk_vdb_bricks(murk_context *context, const murk_vdb *vdb, size_t index, int component,
                            murk_bricks *out) MURK_NOEXCEPT;

/* One grid to write: the active voxels of bricks, whose values are x of a vec3s grid where y and z
   are set; or, where pass is set, grid pass_index of pass as it was read. */
typedef struct murk_vdb_grid {
    const char *name;
    const murk_bricks *bricks;
    const float *y, *z;
    const murk_vdb *pass;
    size_t pass_index;
} murk_vdb_grid;

/* One metadata entry of the file: text, or a number where text is NULL. */
typedef struct murk_vdb_meta {
    const char *name;
    const char *text;
    double number;
} murk_vdb_meta;

/* Writes fog-volume grids with background 0, real leaf voxels (no tiles, no pruning), and the
   file metadata; half stores 16-bit floats. Where transform_of is set, the grids of bricks get the
   transform of its grid transform_index exactly, else bricks->index_to_world. path "-" streams to
   standard output; any other path is written beside the target and renamed. */
murk_status murk_vdb_write(murk_context *context, const char *path, const murk_vdb_grid *grids,
                           size_t grid_count, const murk_vdb_meta *meta, size_t meta_count,
                           const murk_vdb *transform_of, size_t transform_index,
                           bool half) MURK_NOEXCEPT;

#pragma GCC visibility pop

#ifdef __cplusplus
}
#endif
#endif
