/* SPDX-License-Identifier: Apache-2.0 */
/* The checks of the stress suite, and what they share. */
#ifndef STRESS_CHECK_H
#define STRESS_CHECK_H

#include "stress.h"

/* What rounding leaves between two runs that are the same but for the order of their sums: the end
   of the iteration, see test_convergence.c. */
#define STRESS_ROUNDING 1e-6

/* What 16 lines of the beam a voxel miss of it, see stage.c. */
#define STRESS_BEAM 1e-3

/* murk failed. */
static const struct stress_outcome STRESS_FAILED = {NAN, 0};

/* The options of runs that are compared with one another. */
static inline murk_solve_options stress_fixed(void)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 96;
    options.tolerance = 1e-5;
    return options;
}

static inline bool stress_is_zone(const struct stress_scene *scene, size_t n)
{
    return scene->voxel[n].kappa_t >= 1e-30f; /* below, murk takes it as empty */
}

/* Each is documented where it is. */
struct stress_outcome stress_all_finite(const struct stress_subject *s);
struct stress_outcome stress_non_negative(const struct stress_subject *s);
struct stress_outcome stress_energy(const struct stress_subject *s);
struct stress_outcome stress_iterations(const struct stress_subject *s);
struct stress_outcome stress_error_of_all(const struct stress_subject *s);
struct stress_outcome stress_error_of_zones(const struct stress_subject *s);
struct stress_outcome stress_pairwise(const struct stress_subject *s);
struct stress_outcome stress_reciprocity(const struct stress_subject *s);
struct stress_outcome stress_furnace(const struct stress_subject *s);
struct stress_outcome stress_in_albedo(const struct stress_subject *s);
struct stress_outcome stress_in_emission(const struct stress_subject *s);
struct stress_outcome stress_shift(const struct stress_subject *s);
struct stress_outcome stress_offset(const struct stress_subject *s);
struct stress_outcome stress_scale(const struct stress_subject *s);
struct stress_outcome stress_light(const struct stress_subject *s);
struct stress_outcome stress_turn(const struct stress_subject *s);
struct stress_outcome stress_mirror(const struct stress_subject *s);
struct stress_outcome stress_nudge(const struct stress_subject *s);

#endif
