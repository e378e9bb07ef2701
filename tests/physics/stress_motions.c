/* SPDX-License-Identifier: Apache-2.0 */
/* What must hold between a scene and the same scene elsewhere, turned, mirrored and scaled. */
#include "stress_check.h"

/* Solves the moved scene with the options of `fixed` or, for NULL, by default. */
static bool solve_moved(const struct stress_subject *s, const struct stress_motion *m, bool fixed,
                        struct stress_solution *out)
{
    struct stress_scene moved = stress_move(&s->scene, m);
    const murk_solve_options options = stress_fixed();
    bool solved = stress_solve(&moved, fixed ? &options : NULL, out);
    stress_scene_clear(&moved);
    return solved;
}

/* The largest relative difference of a zone between the fixed solution and that of the moved scene:
   nothing, since the sums are the same and in the same order. */
static struct stress_outcome exactly(const struct stress_subject *s, const struct stress_motion *m)
{
    struct stress_solution moved;
    if (!solve_moved(s, m, true, &moved))
        return STRESS_FAILED;
    double most = 0;
    for (size_t n = 0; n < s->scene.count; n++) {
        double a = moved.B[n] / m->light, b = s->fixed.B[n];
        if (stress_is_zone(&s->scene, n) && a != b)
            most = fmax(most, fabs(a - b) / fmax(a, b));
    }
    stress_solution_clear(&moved);
    return (struct stress_outcome){most, 0};
}

/* Their difference in the norm where sums are in another order: both iterations end where they say.
   The lines of a beam that lies between two lattices pass elsewhere, with twice the 0.1 % that
   stage.c states for them. */
static struct stress_outcome closely(const struct stress_subject *s, const struct stress_motion *m)
{
    struct stress_solution moved;
    if (!solve_moved(s, m, true, &moved))
        return STRESS_FAILED;
    double size = stress_norm(&s->scene, s->fixed.B, NULL);
    double d = stress_norm(&s->scene, s->fixed.B, moved.B);
    double left = s->row->flags & MERGED ? 2.5 : 1;
    double bound = left * (s->fixed.report.estimate_iteration + moved.report.estimate_iteration) +
                   STRESS_ROUNDING;
    stress_solution_clear(&moved);
    return (struct stress_outcome){size > 0 ? d / size : d,
                                   bound + (s->row->flags & BETWEEN ? 2 * STRESS_BEAM : 0)};
}

static struct stress_outcome worse(struct stress_outcome a, struct stress_outcome b)
{
    return a.value * b.bound >= b.value * a.bound || isnan(a.value) ? a : b;
}

/* By 10^7 voxels: whole bricks. Over a ground footprints are laid out in the world, where doubles
   then have steps of 1e-9 voxels: sums of floats may round otherwise. */
struct stress_outcome stress_shift(const struct stress_subject *s)
{
    struct stress_motion m = STRESS_STILL;
    m.shift[0] = 10000000;
    m.shift[1] = -8000000;
    m.shift[2] = 8;
    return s->scene.ground ? closely(s, &m) : exactly(s, &m);
}

/* Among the bricks otherwise. */
struct stress_outcome stress_offset(const struct stress_subject *s)
{
    struct stress_motion m = STRESS_STILL;
    m.shift[0] = 3;
    m.shift[1] = -1;
    m.shift[2] = 6;
    return closely(s, &m);
}

/* Lengths, with kappa_t over them, and lights by a power of two. */
struct stress_outcome stress_scale(const struct stress_subject *s)
{
    struct stress_motion m = STRESS_STILL;
    m.scale = 1024;
    return exactly(s, &m);
}

struct stress_outcome stress_light(const struct stress_subject *s)
{
    struct stress_motion m = STRESS_STILL;
    m.light = 1024;
    return exactly(s, &m);
}

/* The directions turn with the lattice. */
struct stress_outcome stress_turn(const struct stress_subject *s)
{
    static const struct stress_motion space[] = {
        {.from = {1, 2, 0}, .scale = 1, .light = 1},
        {.from = {2, 1, 0}, .flip = {false, false, true}, .scale = 1, .light = 1}};
    static const struct stress_motion ground[] = {
        {.from = {1, 0, 2}, .flip = {true, false, false}, .scale = 1, .light = 1},
        {.from = {0, 2, 1}, .flip = {false, false, true}, .scale = 1, .light = 1}};
    const struct stress_motion *motions = s->scene.ground ? ground : space;
    return worse(closely(s, &motions[0]), closely(s, &motions[1]));
}

/* The lines pass elsewhere: two solutions, each with the error that it states. */
struct stress_outcome stress_mirror(const struct stress_subject *s)
{
    static const struct stress_motion motions[] = {
        {.from = {0, 1, 2}, .flip = {true, false, false}, .scale = 1, .light = 1},
        {.from = {1, 0, 2}, .scale = 1, .light = 1}};
    struct stress_outcome worst = {0, 1};
    for (int n = 0; n < 2; n++) {
        struct stress_solution moved;
        if (!solve_moved(s, &motions[n], false, &moved))
            return STRESS_FAILED;
        double size = stress_norm(&s->scene, s->plain.B, NULL);
        double d = stress_norm(&s->scene, s->plain.B, moved.B);
        double bound = s->plain.report.estimate + moved.report.estimate + STRESS_ROUNDING;
        stress_solution_clear(&moved);
        worst = worse((struct stress_outcome){size > 0 ? d / size : d, bound}, worst);
    }
    return worst;
}
