/* SPDX-License-Identifier: Apache-2.0 */
/* Where light matters to a picture. */
#ifndef MURK_SOLVE_AUDIENCE_H
#define MURK_SOLVE_AUDIENCE_H

#include "region.h"
#include "stage.h"

/*
 * The box of the bricks that the camera can see: in its field of view, and not so deep in the
 * medium that their light, by the radiosities that the solution holds so far, is below a thousandth
 * of the tolerance of the brightest that is seen. Neighbours of such bricks count as seen. Not
 * limited where the box leaves out too little to pay.
 */
murk_status murk_audience(murk_context *context, const murk_solution *solution,
                          const murk_camera *camera, double tolerance, murk_region *out);

#endif
