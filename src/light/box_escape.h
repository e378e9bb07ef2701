/* SPDX-License-Identifier: Apache-2.0 */
/* Light out of a box, or into it, along parallel lines. */
#ifndef MURK_LIGHT_BOX_ESCAPE_H
#define MURK_LIGHT_BOX_ESCAPE_H

/* The mean over a box of edges size[] of exp(-kappa t), t being the way from a point to the rim
   along the unit vector `direction`; kappa may be below 0. */
double murk_box_escape(const double size[3], const double direction[3], double kappa);

/* How much nearer a box is than its middle at the distance r, as far as its light falls off. */
double murk_box_shift(const double size[3], const double direction[3], double kappa, double r);

/* The mean over the box of exp(-kappa s), s being the way along the direction from its middle. */
double murk_box_mean(const double size[3], const double direction[3], double kappa);

#endif
