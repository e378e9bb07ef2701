/* SPDX-License-Identifier: Apache-2.0 */
/* The bands that go to one file, and what their names mean. */
#ifndef MURK_VDB_BAND_SET_H
#define MURK_VDB_BAND_SET_H

#include "murk/band.h"
#include "solution.h"

typedef struct murk_band_set {
    const murk_solution *const *solution;
    const char *const *name; /* NULL: one band without a name */
    size_t count;
} murk_band_set;

/* Fails where the names are no names of bands or the solutions are on different transforms. where:
   for messages. */
murk_status murk_band_set_check(const murk_band_set *set, const char *where);

/* The name of a band, or NULL. */
const char *murk_band_set_name(const murk_band_set *set, size_t band);

/* The bands named R, G and B; false where one of them is not there or they do not have the same
   voxels, so that one grid cannot hold them. */
bool murk_band_set_colours(const murk_band_set *set, size_t band[3]);

/* Whether all bands have the same zones with the same kappa_t. */
bool murk_band_set_one_extinction(const murk_band_set *set);

/* Component of the band in a vec3s grid: 0, 1, 2 for R, G, B, -1 for any other. */
int murk_band_component(const char *name);

#endif
