/* SPDX-License-Identifier: Apache-2.0 */
/* Where an axis has its ticks, and what they are called. */
#ifndef MURK_PLOT_TICKS_H
#define MURK_PLOT_TICKS_H

#include "murk/plot.h"

enum { MURK_TICKS_MOST = 128, MURK_LABEL_SIZE = 32 };

typedef struct murk_tick {
    double value;
    char label[MURK_LABEL_SIZE]; /* "": a small tick between two others */
} murk_tick;

/* The ends of an axis that shows all of [low, high], at least one decade or a number's
   neighbourhood wide; those of the axis itself where it has them. False where a logarithmic axis
   does not begin above 0. */
bool murk_axis_range(const murk_axis *axis, double low, double high, double range[2]);

/* Ticks in range, in ascending order: at 1, 2 or 5 times a power of ten, at most about `most` of
   them labelled. */
int murk_axis_ticks(bool log, const double range[2], int most, murk_tick ticks[MURK_TICKS_MOST]);

/* Where a value stands on the axis: 0 at range[0], 1 at range[1]; NaN where it has no place. */
double murk_axis_place(bool log, const double range[2], double value);

#endif
