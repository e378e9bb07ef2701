/* SPDX-License-Identifier: Apache-2.0 */
/* What the colours of a picture of several bands are. */
#ifndef MURK_RENDER_BAND_COLORS_H
#define MURK_RENDER_BAND_COLORS_H

#include "murk/bands.h"

/* The bands shown as R, G and B: those of these names where there are all three, which is what it
   tells, else the first. */
bool murk_band_colors(const murk_band_view *views, size_t count, const murk_band_view *color[3]);

#endif
