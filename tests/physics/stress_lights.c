/* SPDX-License-Identifier: Apache-2.0 */
/* What must hold between a scene and the same scene with other lights or albedos. */
#include "stress_check.h"

/* All at one temperature: B = 1 everywhere, to what test_isothermal.c allows. */
struct stress_outcome stress_furnace(const struct stress_subject *s)
{
    struct stress_scene scene = stress_copy(&s->scene);
    struct stress_solution solution;
    scene.sun.irradiance = 0;
    scene.sky = 1 / M_PI;
    scene.ground_emission = 1 - scene.reflectance;
    for (size_t n = 0; n < scene.count; n++)
        scene.voxel[n].emission = 1;
    double most = NAN;
    if (stress_solve(&scene, NULL, &solution)) {
        most = solution.patches_of_one;
        for (size_t n = 0; n < scene.count; n++)
            if (stress_is_zone(&scene, n))
                most = fmax(most, fabs(solution.B[n] - 1.0));
        stress_solution_clear(&solution);
    }
    stress_scene_clear(&scene);
    return (struct stress_outcome){most, 1e-5};
}

/*
 * x = b + K x with K >= 0 is the sum of K^n b: where no entry of b or K becomes less no zone gets
 * darker. The operator of given directions is such a K, so what is darker all the same is the error
 * of the iteration, in the norm that the estimates are about. `more` is solved and cleared.
 */
static struct stress_outcome brighter(const struct stress_subject *s, struct stress_scene *more)
{
    const murk_solve_options options = stress_fixed();
    struct stress_solution solution;
    struct stress_outcome outcome = STRESS_FAILED;
    if (stress_solve(more, &options, &solution)) {
        double before = stress_norm(&s->scene, s->fixed.B, NULL);
        double after = stress_norm(&s->scene, solution.B, NULL);
        outcome.value = stress_norm_below(&s->scene, solution.B, s->fixed.B) / fmax(after, 1e-300);
        outcome.bound = solution.report.estimate_iteration + STRESS_ROUNDING;
        if (after > 0)
            outcome.bound += s->fixed.report.estimate_iteration * before / after;
        stress_solution_clear(&solution);
    }
    stress_scene_clear(more);
    return outcome;
}

/* Monotone is the light that scatters: the power (1 - albedo) E that a zone emits is held. A zone
   whose albedo is 1 emits nothing, so there is none among those that emit. */
struct stress_outcome stress_in_albedo(const struct stress_subject *s)
{
    struct stress_scene more = stress_copy(&s->scene);
    uint64_t random = 41;
    for (size_t n = 0; n < more.count; n++) {
        struct stress_voxel *v = &more.voxel[n];
        if (check_random(&random) < 0.5)
            continue;
        float albedo = v->emission > 0 ? v->albedo + (1 - v->albedo) / 2 : 1;
        if (albedo < 1)
            v->emission = (float)(v->emission * (1.0 - v->albedo) / (1.0 - albedo));
        if (albedo < 1 || !(v->emission > 0))
            v->albedo = albedo;
    }
    more.reflectance = (1 + more.reflectance) / 2;
    return brighter(s, &more);
}

struct stress_outcome stress_in_emission(const struct stress_subject *s)
{
    struct stress_scene more = stress_copy(&s->scene);
    uint64_t random = 42;
    for (size_t n = 0; n < more.count; n++)
        if (check_random(&random) < 0.3)
            more.voxel[n].emission += (float)check_random(&random);
    return brighter(s, &more);
}

/* The sun 1e-9 aside: where its direction lies between two lattices its lines pass elsewhere. */
struct stress_outcome stress_nudge(const struct stress_subject *s)
{
    static const double by[3] = {1e-9, -0.7e-9, -0.3e-9};
    const murk_solve_options options = stress_fixed();
    struct stress_scene scene = stress_copy(&s->scene);
    for (int a = 0; a < 3; a++)
        scene.sun.direction[a] += by[a];
    struct stress_solution nudged;
    bool solved = stress_solve(&scene, &options, &nudged);
    stress_scene_clear(&scene);
    if (!solved)
        return STRESS_FAILED;
    double size = stress_norm(&s->scene, s->fixed.B, NULL);
    double d = stress_norm(&s->scene, s->fixed.B, nudged.B);
    stress_solution_clear(&nudged);
    return (struct stress_outcome){size > 0 ? d / size : d, 2 * STRESS_BEAM};
}
