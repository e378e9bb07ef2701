/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The equations on few directions, and on larger zones where the medium is thin: where the orders
 * of scattering are iterated. What that leaves out is put right by residuals that are computed
 * finely: x += L_coarse^-1 (b - L_fine x), each of which cuts the difference between the two by the
 * ratio of their angular and spatial errors to the solution.
 */
#ifndef MURK_SOLVE_COARSE_H
#define MURK_SOLVE_COARSE_H

#include "lines.h"
#include "stage.h"
#include "system.h"

typedef struct murk_coarse murk_coarse;
struct murk_coarse {
    murk_context *context;
    const murk_solution *solution;
    const murk_stage *stage;
    int max_iterations;
    int shift;           /* zones cover 2^shift voxels each way */
    murk_medium *medium; /* of these zones; the medium itself where shift is 0 */
    murk_lines *lines;   /* MURK_ORBIT directions */
    int set;             /* of lines: 1 where slopes need to feel them */
    murk_system system;
    murk_around around;
    murk_vector direct;  /* radiosities by beam and emission alone */
    murk_vector x, r, d; /* solution, residual, correction */
    int iterations;
    murk_traced traced; /* of lines that are gone */
};

murk_status murk_coarse_create(murk_context *context, const murk_solution *solution,
                               const murk_stage *stage, const murk_solve_options *options,
                               murk_coarse *out);
void murk_coarse_clear(murk_coarse *coarse);

/* Solves L d = r: until the error is a twentieth of d, or `absolute`, in the norm of the
   tolerance. */
murk_status murk_coarse_correct(murk_coarse *coarse, double absolute);

/* Sets x to the solution on these zones and directions, from `start` if that is not NULL, with
   an error of about `goal`. */
murk_status murk_coarse_solve(murk_coarse *coarse, const murk_solution *start, double goal);

/* What a probe tells, errors relative to x: those of the zones in the norm of the tolerance, or of
   the user's patches if theirs are larger. */
typedef struct murk_probe {
    double residual, change; /* of x, and by its correction */
    double diffuse;          /* power of sky and ground that the medium takes [W] */
} murk_probe;

/* Corrects x once by the residual on more directions. */
murk_status murk_coarse_probe(murk_coarse *coarse, int directions, int rays, double goal,
                              murk_probe *out);

/* The relative residual of x on the directions of the solution, with lines elsewhere. */
murk_status murk_coarse_lattice(murk_coarse *coarse, double *out);

/* Sets the solution's zones by the light that x means for them, linear within a coarse zone; r is
   overwritten. */
void murk_coarse_prolong(murk_coarse *coarse, murk_solution *solution);

/* Sets r to the residual of the solution's zones, net being G/4 - B of them without the beam, of
   x's slopes and of its patches, which `incident` arrives at; 0 for zones that nothing is asked
   for. */
void murk_coarse_restrict(murk_coarse *coarse, const float *net, const float *net_slope,
                          const float *incident, const murk_region *region);

/* Adds what a traced set of lines did to the sums. */
void murk_coarse_count(murk_coarse *coarse, const murk_lines *lines);

#endif
