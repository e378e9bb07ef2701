/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The equations on few directions, and on larger zones where the medium is thin: where the orders
 * of scattering are iterated. What that leaves out is put right by residuals that are computed
 * finely: x += L_coarse^-1 (b - L_fine x), each of which cuts the difference between the two by the
 * ratio of their angular and spatial errors to the solution. Here those of one band, and its fields
 * to and from the zones.
 */
#ifndef MURK_SOLVE_COARSE_H
#define MURK_SOLVE_COARSE_H

#include "lines.h"
#include "residual.h"
#include "stage.h"

typedef struct murk_coarse {
    murk_context *context;
    const murk_solution *solution;
    const murk_stage *stage;
    int shift;           /* zones cover 2^shift voxels each way */
    murk_medium *medium; /* of these zones; the medium itself where shift is 0 */
    murk_system system;
    murk_around around;
    murk_vector direct;  /* radiosities by beam and emission alone */
    murk_vector x, r, d; /* solution, residual, correction */
    int iterations;
} murk_coarse;

/* All but lines for the system. */
murk_status murk_coarse_create(murk_context *context, const murk_solution *solution,
                               const murk_stage *stage, int shift, murk_coarse *out);
void murk_coarse_clear(murk_coarse *coarse);

/* The equations over the lines of any number of directions. */
murk_system murk_coarse_system(const murk_coarse *coarse, murk_lines *lines);

/* Sets x to another solution. */
void murk_coarse_begin(murk_coarse *coarse, const murk_solution *start);

/* Sets the solution's zones by the light that x means for them, linear within a coarse zone; r is
   overwritten. */
void murk_coarse_prolong(murk_coarse *coarse, murk_solution *solution);

/* Sets r to the residual of the solution's zones, net being G/4 - B of them without the beam, of
   x's slopes and of its patches, which `incident` arrives at; 0 for zones that nothing is asked
   for. */
void murk_coarse_restrict(murk_coarse *coarse, const float *net, const float *net_slope,
                          const float *incident, const murk_region *region);

#endif
