/* SPDX-License-Identifier: Apache-2.0 */
#include "thick.h"

const char *const THICK_SHAPE_NAMES[THICK_SHAPES] = {"block", "random", "cloud"};
const char *const THICK_LIGHT_NAMES[THICK_LIGHTS] = {"sun", "thermal"};

enum { EDGE = 10 };

/* Extinction, 1 at most, at the middle of a voxel in units of the box's half edge. */
static double shape(enum thick_shape shape, const double at[3], uint64_t *random)
{
    double r = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    switch (shape) {
    case THICK_RANDOM: /* a contrast of 3 from voxel to voxel */
        return pow(3, -check_random(random));
    case THICK_CLOUD: /* round, and from half its radius on ever thinner */
        return fmax(0, fmin(1, 2 * (1 - r)));
    default: /* edges as sharp as can be */
        return 1;
    }
}

void thick_make(const struct thick_case *c, struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, EDGE, EDGE, EDGE);
    uint64_t random = 77;
    for (int n = 0; n < zone_count(mc); n++) {
        const int index[3] = {n / EDGE / EDGE, n / EDGE % EDGE, n % EDGE};
        double at[3], core = 0;
        for (int a = 0; a < 3; a++) {
            at[a] = (index[a] + 0.5) * 2 / EDGE - 1;
            core = fmax(core, fabs(at[a]));
        }
        s->kappa_t[n] = (float)(c->depth / mc->voxel[0] * shape(c->shape, at, &random));
        s->albedo[n] = (float)c->albedo;
        s->emission[n] = c->light == THICK_SUN ? 0 : core < 1.0 / 3 ? 5 : 1;
    }
    setting_lay_ground(mc, 2, 0.1);
    for (int n = 0; n < patch_count(mc); n++)
        s->rho[n] = 0.3f;
    if (c->light == THICK_SUN)
        setting_sun(mc, 0.48, -0.36, -0.8);
}

/* A tolerance that is not reached is no failure here: the error is what is looked at. */
static void thick_solve(struct world *w, const murk_solve_options *options)
{
    murk_status status = murk_solve(w->context, &w->scene, options, &w->solution);
    if (status && status != MURK_NOT_REACHED)
        fail_msg("%s", murk_context_message(w->context));
}

void thick_run(const struct thick_case *c, const murk_solve_options *options, long packets,
               int threads, struct thick_result *out)
{
    static struct setting s;
    static struct batches mc;
    static double b[MOST], weight[MOST];
    struct world w;
    thick_make(c, &s);
    int zones = zone_count(&s.mc), patches = patch_count(&s.mc);
    for (int n = 0; n < zones; n++)
        weight[n] = optical_volume(&s.mc, n);
    for (int n = 0; n < patches; n++)
        weight[zones + n] = 1;
    batches_run(&s.mc, true, packets, NULL, &mc);
    setting_open(&s.mc, threads, &w);
    thick_solve(&w, options);
    setting_solution(&s.mc, &w, b);
    out->zones = batches_distance(&mc, 0, zones, weight, b);
    out->ground = batches_distance(&mc, zones, patches, weight, b);
    out->estimate = murk_solution_report(w.solution)->estimate;
    world_close(&w);
}
