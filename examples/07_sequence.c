/* SPDX-License-Identifier: Apache-2.0 */
/* Smoke of one's own, frame by frame: a puff that rises, in bricks of memory; each frame is solved
 * from the one before, with a log and the progress: 07_sequence [FRAMES] */
#include <murk/murk.h>

#include <stdio.h>
#include <stdlib.h>

enum { BRICKS = 64, VOXELS = 512 }; /* 4 x 4 x 4 bricks of 8 x 8 x 8 voxels */

static void tell(void *user, murk_log_level level, const char *text)
{
    (void)user;
    if (level == MURK_LOG_WARNING)
        fprintf(stderr, "warning: %s\n", text);
}

static void count_calls(void *user, const char *stage, double done)
{
    (void)stage;
    (void)done;
    ++*(int *)user;
}

/* Extinction of a puff of 1.2 m around its centre; voxels of 0.1 m. */
static void fill_brick(const int32_t brick[3], double height, float *kappa_t)
{
    for (int v = 0; v < VOXELS; v++) {
        const int at[3] = {v / 64, v / 8 % 8, v % 8};
        const double centre[3] = {1.6, 1.6, height};
        double square = 0;
        for (int c = 0; c < 3; c++) {
            double x = 0.1 * (8 * brick[c] + at[c] + 0.5) - centre[c];
            square += x * x;
        }
        kappa_t[v] = (float)fmax(0.0, 3 * (1 - square / (1.2 * 1.2)));
    }
}

static murk_status make_medium(murk_context *context, double height, murk_medium **out)
{
    static float kappa_t[BRICKS * VOXELS];
    static int32_t brick[3 * BRICKS];
    for (int b = 0; b < BRICKS; b++) {
        brick[3 * b] = b / 16;
        brick[3 * b + 1] = b / 4 % 4;
        brick[3 * b + 2] = b % 4;
        fill_brick(&brick[3 * b], height, &kappa_t[VOXELS * b]);
    }
    const murk_brick_array bricks = {.count = BRICKS,
                                     .brick = brick,
                                     .voxel_size = {0.1, 0.1, 0.1},
                                     .kappa_t = kappa_t,
                                     .albedo_value = 0.95};
    return murk_medium_from_bricks(context, &bricks, out);
}

/* Solves a frame; *solution is that of the frame before, or NULL, and becomes that of this one. */
static murk_status solve_frame(murk_context *context, int frame, murk_solution **solution)
{
    murk_medium *medium;
    double height = 1.3 + 0.05 * frame;
    murk_status status = make_medium(context, height, &medium);
    if (status)
        return status;
    murk_scene scene = {.medium = medium, .sun = {{0.5, 0.0, -0.8}, 1.0}, .sky_radiance = 0.1};
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.start = *solution;
    murk_solution *next = NULL;
    status = murk_solve(context, &scene, &options, &next);
    murk_medium_release(medium); /* the solution keeps what it needs */
    if (status && status != MURK_NOT_REACHED)
        return status;
    const murk_report *report = murk_solution_report(next);
    const int32_t top[3] = {16, 16, (int32_t)(10 * height + 8)};
    printf("frame %d: %d iterations, estimated error %.2f %%%s; B = %.3f W/m^2 above the centre\n",
           frame, report->iterations, 100 * report->estimate,
           status ? " (more than asked for)" : "", murk_solution_radiosity(next, top));
    murk_solution_release(*solution);
    *solution = next;
    return MURK_OK;
}

int main(int argc, char **argv)
{
    int frames = argc > 1 ? atoi(argv[1]) : 3, calls = 0;
    murk_context *context;
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    options.log = tell;
    options.progress = count_calls;
    options.user = &calls;
    murk_status status = murk_context_create(&options, &context);
    if (status) {
        fprintf(stderr, "murk: %s\n", murk_status_text(status));
        return 1;
    }
    murk_solution *solution = NULL;
    for (int frame = 1; frame <= frames && !status; frame++)
        status = solve_frame(context, frame, &solution);
    if (status)
        fprintf(stderr, "%s\n", murk_context_message(context));
    else
        printf("%d frames, %s\n", frames, calls > 0 ? "progress was told" : "no progress");
    murk_solution_release(solution);
    murk_context_release(context);
    return status != MURK_OK;
}
