/* SPDX-License-Identifier: Apache-2.0 */
/* The table of the checks of the stress suite, and what they look at. */
#include "stress_check.h"

bool stress_subject_open(struct stress_subject *s, const struct stress_row *row, bool ground)
{
    memset(s, 0, sizeof *s);
    s->row = row;
    s->scene = stress_row_scene(row, ground);
    murk_solve_options fixed = stress_fixed(), fine = MURK_SOLVE_DEFAULT;
    fine.directions = 1536;
    fine.tolerance = 1e-3;
    return stress_solve(&s->scene, NULL, &s->plain) && stress_solve(&s->scene, &fixed, &s->fixed) &&
           stress_solve(&s->scene, &fine, &s->fine);
}

void stress_subject_close(struct stress_subject *s)
{
    stress_solution_clear(&s->plain);
    stress_solution_clear(&s->fixed);
    stress_solution_clear(&s->fine);
    stress_scene_clear(&s->scene);
}

static bool lit(const struct stress_subject *s)
{
    return !(s->row->flags & DENORMAL);
}

static bool is_paired(const struct stress_subject *s)
{
    return s->row->flags & PAIRED;
}

static bool may_emit(const struct stress_subject *s)
{
    return lit(s) && !(s->row->flags & EMISSION_SET);
}

/* The sun sets at once where the ground is infinite. */
static bool has_sun(const struct stress_subject *s)
{
    return s->scene.sun.irradiance > 0 && !(s->scene.ground && s->row->flags & EDGE_ON);
}

const struct stress_check STRESS_CHECKS[] = {
    {"finite", NULL, stress_all_finite},
    {"B >= 0", NULL, stress_non_negative},
    {"energy", NULL, stress_energy},
    {"iterations", NULL, stress_iterations},
    {"error", lit, stress_error_of_all},
    {"error of zones", lit, stress_error_of_zones},
    {"pairwise", is_paired, stress_pairwise},
    {"reciprocity", NULL, stress_reciprocity},
    {"furnace", NULL, stress_furnace},
    {"albedo up", lit, stress_in_albedo},
    {"emission up", may_emit, stress_in_emission},
    {"moved", NULL, stress_shift},
    {"offset", lit, stress_offset},
    {"scaled", NULL, stress_scale},
    {"brighter", lit, stress_light},
    {"turned", lit, stress_turn},
    {"mirrored", lit, stress_mirror},
    {"nudged", has_sun, stress_nudge},
};

const size_t STRESS_CHECK_COUNT = sizeof STRESS_CHECKS / sizeof *STRESS_CHECKS;
