/* SPDX-License-Identifier: Apache-2.0 */
/* Levels inside: what each band has of its own, and what all share. */
#ifndef MURK_SOLVE_LEVELS_STATE_H
#define MURK_SOLVE_LEVELS_STATE_H

#include "coarse_bands.h"
#include "levels.h"

struct murk_level_band {
    murk_solution *solution;
    const murk_stage *stage;
    murk_coarse *coarse;
    float *net;           /* on the solution's grid */
    float *net_slope;     /* of its bent bricks */
    float *incident;      /* of the patches */
    double scale;         /* the angular error of N directions is scale / sqrt(N) */
    double diffuse;       /* light of sky and ground that the medium takes, by the last probe [W] */
    double change;        /* by the first pass with these directions */
    double last_change;   /* by the last */
    double lattice_48;    /* relative residual of 48 directions with other lines */
    double amplification; /* of residuals of the angular error in the solution */
    double angular, lattice, iteration; /* estimated relative errors */
    double spatial;                     /* the same, given */
    int directions;                     /* that they are for */
    bool done;                          /* needs no more passes with these directions */
    bool settled;                       /* needs no more directions */
};

struct murk_levels {
    murk_context *context;
    const murk_solve_options *options;
    murk_coarse_bands coarse;
    int count;
    struct murk_level_band band[MURK_MOST_BANDS];
    murk_lines *lines;    /* on the solutions' grid */
    murk_region region;   /* what is asked for */
    int directions, last; /* of the passes on the zones, and of the last probe or 0 */
    double before;        /* seconds spent until the coarse solutions were there */
};

/* The error that directions may leave a band. */
double murk_levels_goal(const murk_levels *levels, const struct murk_level_band *band);

/* How many directions the band that asks for most needs, of those that are not settled, by what
   `now` of them told. */
int murk_levels_needed(const murk_levels *levels, int now);

/* Sets the estimates of bands that are not settled for levels->directions, from each one's scale.
 */
void murk_levels_estimate(murk_levels *levels);

/* From the coarse solutions to those of the zones themselves, with levels->directions or as many
   more as it turns out to take. */
murk_status murk_levels_pass(murk_levels *levels);

#endif
