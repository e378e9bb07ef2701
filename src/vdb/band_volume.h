/* SPDX-License-Identifier: Apache-2.0 */
/* Where a volume holds the radiosity of a band. */
#ifndef MURK_VDB_BAND_VOLUME_H
#define MURK_VDB_BAND_VOLUME_H

#include "volume.h"

/* Number and component of the grid that murk_vdb_bricks() shall take. name NULL: of the one band
   without a name. Fails, naming the radiosities there are, for a band that is not there. */
murk_status murk_volume_find_band(murk_context *context, const murk_volume *volume,
                                  const char *name, size_t *index, int *component);

#endif
