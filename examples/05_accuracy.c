/* SPDX-License-Identifier: Apache-2.0 */
/* The error that is reported and the error there is: 05_accuracy VOLUME [SCALE [ALBEDO]] */
#include <murk/murk.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Radiosities of all voxels of a solution, to be freed; NULL when memory runs out. */
static float *take(const murk_solution *solution, size_t *count)
{
    murk_solution_voxels(solution, 0, NULL, NULL, count);
    float *radiosity = malloc(*count * sizeof *radiosity);
    if (radiosity)
        murk_solution_voxels(solution, *count, NULL, radiosity, count);
    return radiosity;
}

/* Relative difference over all voxels, root of the mean square. */
static double differ(const float *b, const float *reference, size_t count)
{
    double difference = 0, size = 0;
    for (size_t i = 0; i < count; i++) {
        difference += pow(b[i] - reference[i], 2);
        size += pow(reference[i], 2);
    }
    return sqrt(difference / size);
}

static murk_status compare(murk_context *context, const murk_scene *scene)
{
    static const struct {
        double tolerance;
        int directions, rays;
    } runs[] = {{0.003, 3072, 2}, {0.05, 0, 0}, {0.01, 0, 0}, {0.003, 0, 0}};
    float *reference = NULL;
    murk_status status = MURK_OK;
    printf("tolerance  directions  estimate  true error  seconds\n");
    for (size_t i = 0; !status && i < sizeof runs / sizeof *runs; i++) {
        murk_solve_options options = MURK_SOLVE_DEFAULT;
        options.tolerance = runs[i].tolerance;
        options.directions = runs[i].directions;
        options.rays = runs[i].rays;
        murk_solution *solution = NULL;
        status = murk_solve(context, scene, &options, &solution);
        if (status && status != MURK_NOT_REACHED)
            break;
        status = MURK_OK;
        const murk_report *report = murk_solution_report(solution);
        size_t count;
        float *radiosity = take(solution, &count);
        double seconds = report->seconds_setup + report->seconds_light + report->seconds_solve +
                         report->seconds_finish;
        if (!reference)
            printf("reference %6d x %d  %8.3f %%              %.2f\n", report->directions,
                   options.rays * options.rays, 100 * report->estimate, seconds);
        else if (radiosity)
            printf("%7.1f %%  %10d  %6.3f %%    %6.3f %%  %7.2f\n", 100 * options.tolerance,
                   report->directions, 100 * report->estimate,
                   100 * differ(radiosity, reference, count), seconds);
        if (reference)
            free(radiosity);
        else
            reference = radiosity;
        murk_solution_release(solution);
    }
    free(reference);
    return status;
}

int main(int argc, char **argv)
{
    murk_context *context;
    murk_volume *volume = NULL;
    murk_medium *medium = NULL;
    murk_ground *ground = NULL;
    murk_scene scene;
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    if (argc < 2 || murk_context_create(NULL, &context)) {
        fprintf(stderr, "usage: 05_accuracy VOLUME [SCALE [ALBEDO]]\n");
        return 1;
    }
    if (argc > 2)
        options.extinction.scale = atof(argv[2]);
    if (argc > 3)
        options.albedo.value = atof(argv[3]);
    murk_status status = murk_volume_read(context, argv[1], &volume);
    if (!status)
        status = murk_medium_from_volume(context, volume, &options, &medium);
    if (!status)
        status = murk_scene_default(context, medium, MURK_UP_Z, &scene, &ground);
    if (!status)
        status = compare(context, &scene);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    murk_ground_release(ground);
    murk_medium_release(medium);
    murk_volume_release(volume);
    murk_context_release(context);
    return status != MURK_OK;
}
