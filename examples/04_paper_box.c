/* SPDX-License-Identifier: Apache-2.0 */
/* The sample case of [BG91], section 5, by the paper's method and by lines: 04_paper_box */
#include <murk/murk.h>

#include <stdio.h>

enum { ZONES = 10 }; /* along each axis */

/* kappa_a = 0.3, kappa_t = 0.8. */
static murk_status make_medium(murk_context *context, murk_medium **out)
{
    const murk_array box = {.size = {ZONES, ZONES, ZONES},
                            .voxel_size = {0.1, 0.1, 0.05},
                            .kappa_t_value = 0.8,
                            .albedo_value = 0.5 / 0.8};
    return murk_medium_from_array(context, &box, out);
}

/* Reflectance 0.3, and 0.6 in the square of the patches 4 ... 7. */
static murk_status make_ground(murk_context *context, murk_ground **out)
{
    float reflectance[ZONES * ZONES];
    for (int row = 0; row < ZONES; row++)
        for (int i = 0; i < ZONES; i++)
            reflectance[row * ZONES + i] = row >= 3 && row <= 6 && i >= 3 && i <= 6 ? 0.6f : 0.3f;
    murk_ground_options options = MURK_GROUND_DEFAULT; /* [0, 1] x [0, 1] at height 0 */
    options.patches[0] = options.patches[1] = ZONES;
    options.reflectance_image = reflectance;
    options.horizon = false;
    return murk_ground_create(context, &options, out);
}

static murk_status solve(murk_context *context, const murk_scene *scene,
                         const murk_solve_options *options, murk_solution **out)
{
    murk_status status = murk_solve(context, scene, options, out);
    if (status)
        return status;
    const murk_report *report = murk_solution_report(*out);
    printf("%8s, %-19s: %2d iterations, %.2f s\n", report->method, report->solver,
           report->iterations, report->seconds_setup + report->seconds_solve);
    if (report->multiplications > 0)
        printf("    %.3g multiplications in each, by eq. (18)\n", report->multiplications);
    return MURK_OK;
}

/* Relative difference of two solutions over all zones, root of the mean square. */
static double differ(const murk_solution *a, const murk_solution *b)
{
    double difference = 0, size = 0;
    for (int32_t n = 0; n < ZONES * ZONES * ZONES; n++) {
        const int32_t index[3] = {n / ZONES / ZONES, n / ZONES % ZONES, n % ZONES};
        double x = murk_solution_radiosity(a, index), y = murk_solution_radiosity(b, index);
        difference += (x - y) * (x - y);
        size += x * x;
    }
    return sqrt(difference / size);
}

static murk_status run(murk_context *context, const murk_medium *medium, const murk_ground *ground)
{
    const murk_scene scene = {.medium = medium, .ground = ground, .sun = {{0, 0, -1}, 1}};
    murk_solve_options paper = MURK_SOLVE_DEFAULT; /* and epsilon = 1e-9 */
    paper.method = MURK_PAIRWISE;
    paper.solver = MURK_GAUSS_SEIDEL;
    murk_solution *pairwise = NULL, *lines = NULL;
    printf("   paper, Gauss-Seidel       : 13 iterations, 73 s\n");
    murk_status status = solve(context, &scene, &paper, &pairwise);
    if (!status)
        status = solve(context, &scene, NULL, &lines);
    if (!status)
        printf("pairwise and lines differ by %.2f %%\n", 100 * differ(pairwise, lines));
    murk_solution_release(lines);
    murk_solution_release(pairwise);
    return status;
}

int main(void)
{
    murk_context *context;
    murk_medium *medium = NULL;
    murk_ground *ground = NULL;
    murk_status status = murk_context_create(NULL, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    status = make_medium(context, &medium);
    if (!status)
        status = make_ground(context, &ground);
    if (!status)
        status = run(context, medium, ground);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_ground_release(ground);
    murk_medium_release(medium);
    murk_context_release(context);
    return status != MURK_OK;
}
