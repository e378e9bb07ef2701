/* SPDX-License-Identifier: Apache-2.0 */
#include "accuracy.h"

#include "thick.h"
#include "varied.h"

/* A distance and its standard error; where it does not rise above the noise, how far it could. */
static void print_distance(const struct distance *d)
{
    double a = sqrt(fmax(0, d->squared)), error = distance_error(d, a);
    if (d->squared > error)
        printf(" %.2f ± %.2f |", 100 * a, 100 * error / (2 * a));
    else
        printf(" < %.2f |", 100 * sqrt(fmax(0, d->squared) + error));
}

static void print_solution(const struct bench_mc_scene *s, const struct batches *mc,
                           struct world *w, const murk_solve_options *options)
{
    static double b[MOST], weight[MOST];
    int zones = zone_count(s), patches = patch_count(s);
    /* Where the tolerance is missed the estimate tells. */
    murk_solution_release(w->solution);
    if (murk_solve(w->context, &w->scene, options, &w->solution) && !w->solution)
        fail_msg("%s", murk_context_message(w->context));
    setting_solution(s, w, b);
    for (int n = 0; n < zones + patches; n++)
        weight[n] = n < zones ? optical_volume(s, n) : 1;
    const murk_report *report = murk_solution_report(w->solution);
    struct distance d = batches_distance(mc, 0, zones, weight, b);
    printf(" %.2f |", 100 * report->estimate);
    print_distance(&d);
    if (!patches) {
        printf(" – |");
        return;
    }
    d = batches_distance(mc, zones, patches, weight, b);
    print_distance(&d);
}

void accuracy_zonal(void)
{
    static struct setting s;
    static struct batches mc;
    printf(
        "| scene | method | estimate [%%] | zones [%%] | ground [%%] |\n|---|---|---|---|---|\n");
    for (int n = 0; n < VARIED_SCENES; n++) {
        struct world w;
        murk_solve_options options[3] = {MURK_SOLVE_DEFAULT, MURK_SOLVE_DEFAULT,
                                         MURK_SOLVE_DEFAULT};
        static const char *const names[3] = {"lines, 1 %", "lines, 3072 × 4", "pairwise"};
        options[1].directions = 3072;
        options[1].rays = 2;
        options[1].tolerance = options[2].tolerance = 1e-4;
        options[2].method = MURK_PAIRWISE;
        VARIED[n].make(&s);
        batches_run(&s.mc, false, 2 * VARIED[n].packets, NULL, &mc);
        setting_open(&s.mc, 1, &w);
        for (int method = 0; method < 3; method++) {
            printf("| %s | %s |", method ? "" : VARIED[n].name, names[method]);
            print_solution(&s.mc, &mc, &w, &options[method]);
            printf("\n");
        }
        fflush(stdout);
        world_close(&w);
    }
    printf("\n");
}

void accuracy_thick(void)
{
    static const double depths[] = {0.3, 1, 3, 20}, albedos[] = {0.9, 0.99};
    printf(
        "| medium, light, α: zones; ground [%%] | 0.3 a voxel | 1 | 3 | 20 | ground: 0.3 | 1 | 3 "
        "| 20 |\n|---|---|---|---|---|---|---|---|---|\n");
    for (int row = 0; row < THICK_SHAPES * THICK_LIGHTS * 2; row++) {
        struct thick_case c = {row / 4, row / 2 % 2, 0, albedos[row % 2]};
        struct thick_result r[4];
        printf("| %s, %s, %g |", THICK_SHAPE_NAMES[c.shape], THICK_LIGHT_NAMES[c.light], c.albedo);
        for (int n = 0; n < 4; n++) {
            c.depth = depths[n];
            thick_run(&c, NULL, 400000, 1, &r[n]);
            print_distance(&r[n].zones);
        }
        for (int n = 0; n < 4; n++)
            print_distance(&r[n].ground);
        printf("\n");
        fflush(stdout);
    }
    printf("\n");
}

/* Relative distances of zones and ground to `best`. */
static void print_differences(const struct bench_mc_scene *s, const double *b, const double *best)
{
    int zones = zone_count(s), all = zones + patch_count(s);
    double difference[2] = {0}, size[2] = {0};
    for (int n = 0; n < all; n++) {
        double weight = n < zones ? optical_volume(s, n) : 1;
        difference[n >= zones] += weight * pow(b[n] - best[n], 2);
        size[n >= zones] += weight * best[n] * best[n];
    }
    printf(" %.2f | %.2f |\n", 100 * sqrt(difference[0] / size[0]),
           100 * sqrt(difference[1] / size[1]));
}

void accuracy_ground(void)
{
    static const int directions[] = {96, 192, 384, 768, 1536, 3072};
    static struct setting s;
    static double b[MOST], best[MOST];
    struct world w;
    thick_make(&(struct thick_case){THICK_CLOUD, THICK_THERMAL, 0.3, 0.9}, &s);
    setting_open(&s.mc, 1, &w);
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 1e-4;
    options.method = MURK_PAIRWISE;
    world_solve(&w, &options);
    setting_solution(&s.mc, &w, best);
    printf("| directions | estimate [%%] | zones [%%] | ground [%%] |\n|---|---|---|---|\n");
    options = (murk_solve_options)MURK_SOLVE_DEFAULT;
    for (size_t n = 0; n < sizeof directions / sizeof *directions; n++) {
        options.directions = directions[n];
        world_solve(&w, &options);
        setting_solution(&s.mc, &w, b);
        printf("| %d | %.2f |", directions[n], 100 * murk_solution_report(w.solution)->estimate);
        print_differences(&s.mc, b, best);
    }
    printf("\n");
    world_close(&w);
}
