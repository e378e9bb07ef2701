/* SPDX-License-Identifier: Apache-2.0 */
/* From incident light to the solution: radiosities of zones, margin and patches, and energies. */
#ifndef MURK_SOLVE_FINISH_H
#define MURK_SOLVE_FINISH_H

#include "region.h"
#include "stage.h"

/* What the exchange operator has brought about. */
typedef struct murk_arrived {
    const float *net;      /* on the solution's grid: G/4 - x without the beam; G/4 in the margin */
    const float *incident; /* H of the patches without the beam; NULL without ground */
    double net_power;      /* W, as in murk_incident */
    double diffuse;        /* of it, what the medium takes of the light of sky and ground [W] */
    murk_region region;    /* where net holds */
} murk_arrived;

/*
 * Takes solution->radiosity as the x that was applied. Sets the zones to albedo G/4 + (1 - albedo)
 * E, or leaves them where keep is set or nothing is asked for; the margin, the patches and the
 * energies of the report. Returns the relative change of the zones, in the norm of the tolerance.
 */
double murk_finish(murk_solution *solution, const murk_stage *stage, const murk_arrived *arrived,
                   bool keep);

/* Albedo at a voxel that is no zone: the mean over the nearest zones, `mean` where none is near. */
float murk_margin_albedo(const murk_medium *medium, const int32_t voxel[3], double mean);

/* The mean albedo of the zones, weighted by kappa_t. */
double murk_mean_albedo(const murk_medium *medium);

#endif
