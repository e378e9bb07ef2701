/* SPDX-License-Identifier: Apache-2.0 */
/* Exchange factors between equal boxes of a lattice in a uniform medium, by offset. */
#ifndef MURK_EXCHANGE_FACTOR_OFFSET_H
#define MURK_EXCHANGE_FACTOR_OFFSET_H

/*
 * [BG91] eq. (5) without kappa^2: the integral of exp(-kappa r) / (pi r^2) over two boxes of edges
 * size[] whose offset is a whole number of boxes on each axis [m^4]. Offset 0 is the box with
 * itself. kappa may be 0. Relative error below 1e-6 where it matters (r up to 40 mean free paths;
 * 0 beyond).
 */
double murk_factor_offset_zone(const double size[3], const int offset[3], double kappa);

/*
 * [BG91] eq. (4) without kappa: the integral of cos(theta) tau / (pi r^2) over a patch of edges
 * size[0], size[1] and a box offset[0], offset[1] boxes beside and offset[2] boxes above it [m^3].
 * The medium begins gap above the patch. The third axis is the vertical.
 */
double murk_factor_offset_patch(const double size[3], const int offset[3], double gap,
                                double kappa);

#endif
