/* SPDX-License-Identifier: Apache-2.0 */
/* The light of a lamp, or of a cell of lamps, on a voxel at a distance. */
#ifndef MURK_LIGHT_LAMP_FAR_H
#define MURK_LIGHT_LAMP_FAR_H

#include "lamp_tree.h"
#include "sight.h"

/* G/4 [W/m^2] in the mean over a voxel with kappa_t, at an offset from the node's centre [m], all
   in the frame of sight's grid. By one line of sight, or in a rough medium by MURK_ROUGH_LINES. */
enum { MURK_ROUGH_LINES = 8 };
double murk_lamp_far(const murk_sight *sight, const murk_lamp_node *node, const double offset[3],
                     double kappa_t, bool rough);

#endif
