/* SPDX-License-Identifier: Apache-2.0 */
/* What must hold in one solution, and of the operator. */
#include "bench.h"
#include "stress_check.h"

struct stress_outcome stress_all_finite(const struct stress_subject *s)
{
    const murk_report *r = &s->plain.report;
    const double numbers[] = {r->residual,       r->estimate,       r->energy_emitted,
                              r->energy_sun,     r->energy_diffuse, r->energy_absorbed,
                              r->energy_escaped, r->energy_balance};
    double bad = (double)(s->plain.bad + s->fixed.bad + s->fine.bad);
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
        bad += !isfinite(numbers[n]);
    return (struct stress_outcome){bad, 0};
}

/* No value is negative; and since murk ends at 0 what would be, no zone is darker than its own
   emission: G >= 0. The light that comes back to a zone is G/4 - B + B, with B rounded. */
struct stress_outcome stress_non_negative(const struct stress_subject *s)
{
    double most = s->plain.negative + s->fixed.negative + s->fine.negative ? INFINITY : 0;
    for (size_t n = 0; n < s->scene.count; n++) {
        const struct stress_voxel *v = &s->scene.voxel[n];
        double own = (1 - (double)v->albedo) * v->emission;
        if (stress_is_zone(&s->scene, n) && own > 1e-30)
            most = fmax(most, 1 - s->plain.B[n] / own);
    }
    return (struct stress_outcome){most, STRESS_ROUNDING};
}

/* The report's promise. */
struct stress_outcome stress_energy(const struct stress_subject *s)
{
    return (struct stress_outcome){
        fmax(s->plain.report.energy_balance, s->fixed.report.energy_balance), 1e-5};
}

/*
 * The preconditioned eigenvalues lie in 0.25 ... 2 (EQUATIONS.md), so conjugate gradients cut the
 * error by 2 q^k in k steps, q = (sqrt 8 - 1) / (sqrt 8 + 1); the estimate of it that ends them is
 * up to 8 times the error. The first solution is to a tenth of the tolerance, 3 steps being made
 * before the preconditioner is. Each correction is to a twentieth: one after the probe, and with
 * each number of directions, twice the last, one or two.
 */
static double most_iterations(const murk_report *r)
{
    const double q = (sqrt(8) - 1) / (sqrt(8) + 1);
    double first = 3 + ceil(log(0.1 * r->tolerance / 2 / 8) / log(q));
    double correction = ceil(log(0.05 / 2 / 8) / log(q));
    double doublings = ceil(log2(fmax(1, r->directions / 192.0)));
    return first + correction * (1 + 2 * (1 + doublings));
}

/* Either way out says so. */
struct stress_outcome stress_iterations(const struct stress_subject *s)
{
    const murk_report *r = &s->plain.report;
    bool reached = r->estimate <= r->tolerance;
    if (reached != r->reached || s->plain.status != (reached ? MURK_OK : MURK_NOT_REACHED))
        return STRESS_FAILED;
    return (struct stress_outcome){r->iterations, most_iterations(r)};
}

/* The tolerance is the relative error in the norm of sum kappa_t B^2; where it was not reached the
   estimate is what murk says. The fine solution has an error of its own. */
struct stress_outcome stress_error_of_all(const struct stress_subject *s)
{
    const murk_report *r = &s->plain.report;
    double size = stress_norm(&s->scene, s->fine.B, NULL);
    double d = stress_norm(&s->scene, s->plain.B, s->fine.B);
    return (struct stress_outcome){size > 0 ? d / size : d,
                                   fmax(r->tolerance, r->estimate) + s->fine.report.estimate};
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The 95th percentile of a zone's relative error, within 5 times the tolerance. */
struct stress_outcome stress_error_of_zones(const struct stress_subject *s)
{
    const murk_report *r = &s->plain.report;
    double *errors = calloc(s->scene.count + 1, sizeof *errors);
    size_t count = 0;
    for (size_t n = 0; n < s->scene.count; n++)
        if (stress_is_zone(&s->scene, n) && s->fine.B[n] > 0)
            errors[count++] = fabs(s->plain.B[n] / (double)s->fine.B[n] - 1);
    qsort(errors, count, sizeof *errors, ascending);
    double value = count ? errors[count * 95 / 100] : 0;
    free(errors);
    return (struct stress_outcome){value,
                                   5 * (fmax(r->tolerance, r->estimate) + s->fine.report.estimate)};
}

/* test_agreement.c finds the factors of uniform boxes 0.1 % apart, those of patches 0.5 %. */
struct stress_outcome stress_pairwise(const struct stress_subject *s)
{
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.method = MURK_PAIRWISE;
    options.tolerance = 1e-4;
    struct stress_solution paired;
    if (!stress_solve(&s->scene, &options, &paired))
        return STRESS_FAILED;
    double size = stress_norm(&s->scene, paired.B, NULL);
    double d = stress_norm(&s->scene, s->fine.B, paired.B);
    stress_solution_clear(&paired);
    return (struct stress_outcome){d / size,
                                   s->fine.report.estimate + (s->scene.ground ? 0.005 : 0.001)};
}

/* ---- the operator -------------------------------------------------------------------------- */

static bool open_operator(struct bench *b, const struct stress_scene *scene)
{
    b->method = &murk_exchange_lines;
    if (!stress_open(&b->world, scene))
        return false;
    murk_solve_options options = stress_fixed();
    options.rays = 1;
    if (b->method->init(b->world.context, b->world.medium, b->world.ground, &options, &b->operator))
        return world_close(&b->world), false;
    b->slots = b->world.medium->grid->brick_count * MURK_BRICK_SLOTS;
    b->patches = b->world.ground ? b->world.ground->patch_count : 0;
    return true;
}

/* <u, G v> = <G u, v>, to the rounding of floats in G u that test_conformance.c allows. */
struct stress_outcome stress_reciprocity(const struct stress_subject *s)
{
    static struct bench b;
    if (!open_operator(&b, &s->scene))
        return STRESS_FAILED;
    uint64_t random = 13;
    struct element_values u = some_values(&b, &random), v = some_values(&b, &random);
    struct element_values gu = make_values(&b), gv = make_values(&b);
    apply(&b, &u, 0, 0, &gu);
    apply(&b, &v, 0, 0, &gv);
    double d = fabs(product(&b, &u, &gv, false) - product(&b, &gu, &v, false));
    double size = product(&b, &u, &gv, true);
    drop_values(&u);
    drop_values(&v);
    drop_values(&gu);
    drop_values(&gv);
    close_bench(&b);
    return (struct stress_outcome){size > 0 ? d / size : d, 1e-5};
}
