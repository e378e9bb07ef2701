/* SPDX-License-Identifier: Apache-2.0 */
/* The light of a lamp, or of a cell of lamps, on a voxel at a distance. */
#ifndef MURK_LIGHT_LAMP_FAR_H
#define MURK_LIGHT_LAMP_FAR_H

#include "lamp_tree.h"
#include "sight.h"

/* G/4 [W/m^2] in the mean over a voxel with kappa_t, by one line from centre to centre: offset is
   the way from one to the other and r2 its square. All in the frame of sight's grid. */
double murk_lamp_far(const murk_sight *sight, const murk_lamp_node *node, const double offset[3],
                     double r2, double kappa_t);

#endif
