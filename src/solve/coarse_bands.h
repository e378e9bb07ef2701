/* SPDX-License-Identifier: Apache-2.0 */
/* The coarse equations of bands that share kappa_t, solved and probed together. */
#ifndef MURK_SOLVE_COARSE_BANDS_H
#define MURK_SOLVE_COARSE_BANDS_H

#include "coarse.h"

typedef struct murk_coarse_bands {
    murk_context *context;
    int count;
    murk_coarse band[MURK_MOST_BANDS];
    murk_lines *lines; /* MURK_ORBIT directions */
    int set;           /* of lines: 1 where slopes need to feel them */
    int max_iterations;
    murk_traced traced; /* of lines that are gone */
} murk_coarse_bands;

/* Solutions and stages, `count` of each, are kept by the caller. */
murk_status murk_coarse_bands_create(murk_context *context, murk_solution *const solution[],
                                     const murk_stage stage[], int count,
                                     const murk_solve_options *options, murk_coarse_bands *out);
void murk_coarse_bands_clear(murk_coarse_bands *bands);

/* Sets x to the solution on these zones and directions, from `start` where that is not NULL, with
   an error of about `goal`. */
murk_status murk_coarse_solve(murk_coarse_bands *bands, const murk_solution *const start[],
                              double goal);

/* Solves L d = r for some of the bands: until the error is a twentieth of d, or `absolute`, in the
   norm of the tolerance. */
murk_status murk_coarse_correct(murk_coarse *const band[], const double absolute[], int count,
                                int max_iterations);

/* What a probe tells, errors relative to x: those of the zones in the norm of the tolerance, or of
   the user's patches if theirs are larger. */
typedef struct murk_probe {
    double residual, change; /* of x, and by its correction */
    double diffuse;          /* power of sky and ground that the medium takes [W] */
} murk_probe;

/* Corrects x of each band once by the residual on more directions. */
murk_status murk_coarse_probe(murk_coarse_bands *bands, int directions, int rays, double goal,
                              murk_probe out[]);

/* The relative residuals of x on the directions of the solution, with lines elsewhere. */
murk_status murk_coarse_lattice(murk_coarse_bands *bands, double out[]);

/* Edges of coarse zones are 2^this voxels where no source varies within zones. */
int murk_coarse_choose_shift(const murk_medium *medium);

/* Adds what a traced set of lines did to the sums. */
void murk_coarse_count(murk_coarse_bands *bands, const murk_lines *lines);

#endif
