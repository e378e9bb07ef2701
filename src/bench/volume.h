/* SPDX-License-Identifier: Apache-2.0 */
/* The medium of a VDB file, to be measured like those that are made. */
#ifndef BENCH_VOLUME_H
#define BENCH_VOLUME_H

#include "voxels.h"

/* Reads the density of a file, with the scale that murk chooses and BENCH_ALBEDO. Fails as
   murk_volume_read() and murk_medium_from_volume() do, and where there are no zones; *out is to be
   released all the same. */
murk_status bench_volume_read(murk_context *context, const char *path, struct bench_voxels *out);

#endif
