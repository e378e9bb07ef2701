/* SPDX-License-Identifier: Apache-2.0 */
/* The USD stage beside a radiosity VDB. */
#ifndef CLI_USD_H
#define CLI_USD_H

#include "job.h"

/*
 * Writes a stage in text (.usda): a Volume of the grids of a VDB file that is written, one
 * OpenVDBAsset each; the camera, the sun, the sky. A frame of a sequence has its file as a time
 * sample, so that usdstitch makes one stage of many.
 */
murk_status cli_usd_write(struct cli_job *job, const char *path, const char *vdb_path);

#endif
