/* SPDX-License-Identifier: Apache-2.0 */
/* Which bricks may be met through which part of the picture. */
#ifndef MURK_RENDER_SEEN_H
#define MURK_RENDER_SEEN_H

#include "bins.h"
#include "boxes.h"
#include "view.h"

/* Pixels along the edge of a bin of the picture. */
enum { MURK_BIN_PIXELS = 8 };

/* Fills bins with the bricks that rays of the view may meet, each list in the order in which they
   meet them. */
murk_status murk_seen(murk_context *context, const murk_grid *grid, const murk_box *box,
                      const murk_view *view, murk_bins *bins);

#endif
