/* SPDX-License-Identifier: Apache-2.0 */
/* The cases of [BG91], section 5, by the paper's method and by lines: 04_paper_box [large] */
#include <murk/murk.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* kappa_a = 0.3, kappa_t = 0.8. */
static murk_status make_medium(murk_context *context, const int zones[3], double dz,
                               murk_medium **out)
{
    const murk_array box = {.size = {zones[0], zones[1], zones[2]},
                            .voxel_size = {0.1, 0.1, dz},
                            .kappa_t_value = 0.8,
                            .albedo_value = 0.5 / 0.8};
    return murk_medium_from_array(context, &box, out);
}

/* One patch under each column; reflectance 0.3, and 0.6 in a square in the middle. */
static murk_status make_ground(murk_context *context, const int zones[3], murk_ground **out)
{
    float *reflectance = malloc((size_t)zones[0] * (size_t)zones[1] * sizeof *reflectance);
    if (!reflectance)
        return MURK_ERROR_MEMORY;
    for (int row = 0; row < zones[1]; row++)
        for (int i = 0; i < zones[0]; i++) {
            int x = 10 * i / zones[0], y = 10 * row / zones[1];
            reflectance[row * zones[0] + i] = y >= 3 && y <= 6 && x >= 3 && x <= 6 ? 0.6f : 0.3f;
        }
    murk_ground_options options = MURK_GROUND_DEFAULT;
    for (int c = 0; c < 2; c++) {
        options.extent_max[c] = 0.1 * zones[c];
        options.patches[c] = zones[c];
    }
    options.reflectance_image = reflectance;
    options.horizon = false;
    murk_status status = murk_ground_create(context, &options, out);
    free(reflectance);
    return status;
}

static murk_status solve(murk_context *context, const murk_scene *scene,
                         const murk_solve_options *options, murk_solution **out)
{
    murk_status status = murk_solve(context, scene, options, out);
    if (status && status != MURK_NOT_REACHED)
        return status;
    const murk_report *report = murk_solution_report(*out);
    double window = report->multiplications_window;
    printf("%8s, %-19s: %2d iterations, set-up %.3f s, solution %.3f s; eq. (%d): %.3g "
           "multiplications\n",
           report->method, report->solver, report->iterations, report->seconds_setup,
           report->seconds_solve, window > 0 ? 19 : 18,
           window > 0 ? window : report->multiplications);
    return MURK_OK;
}

/* Relative difference of two solutions over all voxels, root of the mean square. */
static double differ(const murk_solution *a, const murk_solution *b)
{
    size_t count = 0;
    murk_solution_voxels(a, 0, NULL, NULL, &count);
    float *x = malloc(2 * count * sizeof *x), *y = x + count;
    double difference = 0, size = 0;
    if (!x)
        return NAN;
    murk_solution_voxels(a, count, NULL, x, &count);
    murk_solution_voxels(b, count, NULL, y, &count);
    for (size_t n = 0; n < count; n++) {
        difference += pow(x[n] - y[n], 2);
        size += pow(x[n], 2);
    }
    free(x);
    return sqrt(difference / size);
}

static murk_status run(murk_context *context, const murk_scene *scene, bool large)
{
    murk_solve_options paper = MURK_SOLVE_DEFAULT; /* and epsilon = 1e-9 */
    paper.method = MURK_PAIRWISE;
    paper.solver = MURK_GAUSS_SEIDEL;
    murk_solution *window = NULL, *pairwise = NULL, *lines = NULL;
    printf(large ? "   paper, windowed 10x10x4   : 22 min 45 s an iteration\n"
                 : "   paper, Gauss-Seidel       : 13 iterations, 73 s\n");
    murk_status status = MURK_OK;
    if (large) {
        const int size[3] = {10, 10, 4};
        memcpy(paper.window, size, sizeof size);
        status = solve(context, scene, &paper, &window);
        memset(paper.window, 0, sizeof paper.window);
        paper.max_iterations = 1; /* in full an iteration is enough to see what it costs */
    }
    if (!status)
        status = solve(context, scene, &paper, &pairwise);
    if (!status)
        status = solve(context, scene, NULL, &lines);
    if (!status)
        printf("%s and lines differ by %.2f %%\n", large ? "the window" : "pairwise",
               100 * differ(large ? window : pairwise, lines));
    murk_solution_release(lines);
    murk_solution_release(pairwise);
    murk_solution_release(window);
    return status;
}

int main(int argc, char **argv)
{
    bool large = argc > 1 && !strcmp(argv[1], "large");
    const int zones[3] = {large ? 100 : 10, large ? 100 : 10, 10};
    murk_context *context;
    murk_medium *medium = NULL;
    murk_ground *ground = NULL;
    murk_status status = murk_context_create(NULL, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    status = make_medium(context, zones, large ? 0.1 : 0.05, &medium);
    if (!status)
        status = make_ground(context, zones, &ground);
    if (!status) {
        const murk_scene scene = {.medium = medium, .ground = ground, .sun = {{0, 0, -1}, 1}};
        status = run(context, &scene, large);
    }
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_ground_release(ground);
    murk_medium_release(medium);
    murk_context_release(context);
    return status != MURK_OK;
}
