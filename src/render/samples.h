/* SPDX-License-Identifier: Apache-2.0 */
/* The samples of a deep pixel. */
#ifndef MURK_RENDER_SAMPLES_H
#define MURK_RENDER_SAMPLES_H

#include "deep.h"
#include "levels.h"

/* Samples follow opacity and light at the levels to this part of the pixel's. */
#define MURK_SAMPLE_ERROR 0.005

/* What levels from `first` to `last` make as one sample. */
murk_deep_sample murk_sample(const murk_level *first, const murk_level *last, int bands);

/* The last level up to which one sample from `first` on will do; first must not be the last. */
size_t murk_sample_reach(const murk_levels *levels, size_t first, int bands);

#endif
