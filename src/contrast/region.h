/* SPDX-License-Identifier: Apache-2.0 */
/* Which pixels are in a region. */
#ifndef MURK_CONTRAST_REGION_H
#define MURK_CONTRAST_REGION_H

#include "murk/contrast.h"

/* Fails where a region does not fit the picture; name is "target" or "background". */
murk_status murk_region_check(murk_context *context, const murk_region *region,
                              const murk_image *picture, const char *name);

/* Whether a region that fits holds a pixel. */
bool murk_region_holds(const murk_region *region, int x, int y);

#endif
