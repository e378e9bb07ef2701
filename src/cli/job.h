/* SPDX-License-Identifier: Apache-2.0 */
/* One run of a command, or of one frame: its input, its objects, its times. */
#ifndef CLI_JOB_H
#define CLI_JOB_H

#include "options.h"
#include "scene.h"
#include "terminal.h"

#include "murk/deep.h"

struct cli_job {
    const struct cli_options *options;
    const char *command, *command_line;
    const int *frame; /* NULL: not one of a sequence */
    struct cli_terminal terminal;
    murk_context *context;
    void *state; /* of the command, from frame to frame */
    struct scene_description description;
    char *files[SCENE_FILE_MAX]; /* of the frame, where the description has patterns */
    char *obscurant;             /* of --obscurant, from the root */
    struct scene scene;
    murk_solution *solution[SCENE_BANDS_MAX]; /* of the scene's bands, or of the lights of bake */
    murk_image *picture;
    murk_deep *deep; /* where it is asked for */
    double started;
    double seconds_read, seconds_render, seconds_write;
};

/* Creates the context. All functions here give a murk_status and have told the user about a
   failure; MURK_NOT_REACHED comes from cli_job_solve() alone. */
murk_status cli_job_start(struct cli_job *job, const struct cli_options *options,
                          const char *command, const char *command_line);

/* Describes INPUT for the frame, if there is one; options go before what a scene file says. The
   picture of murk contrast has no description. */
murk_status cli_job_describe(struct cli_job *job);

/* Reads the volume, after cli_job_describe(). */
murk_status cli_job_read(struct cli_job *job);

/* Builds the scene, after cli_job_read(). */
murk_status cli_job_build(struct cli_job *job);

/* The bands to take a picture of, for what is there of solutions; gives their number, 0 for a scene
   without bands. */
size_t cli_job_views(const struct cli_job *job, murk_band_view view[SCENE_BANDS_MAX]);

/* Whether what comes after solving fits into memory, before anything is solved: `solutions` of the
   scene, and bytes beside them, which `what` ("the picture") takes. Solving is refused by itself.
 */
murk_status cli_job_afford(struct cli_job *job, size_t solutions, const char *what, double bytes);

murk_status cli_job_solve(struct cli_job *job);
murk_status cli_job_render(struct cli_job *job);

/* Releases what a run came to, so that the next can begin. */
void cli_job_next(struct cli_job *job);

/* Releases everything; gives the exit status for what the job came to. */
int cli_job_end(struct cli_job *job, murk_status status);

/* Whether murk chose the extinction per unit of the grid by itself; *info is of the first band. */
bool cli_job_chose_scale(const struct cli_job *job, murk_medium_info *info);

/* The report of the band or light that is furthest from its tolerance. */
const murk_report *cli_job_report(const struct cli_job *job);

/* Whether nothing came of it: MURK_NOT_REACHED delivers its result. */
bool cli_job_failed(murk_status status);
int cli_exit_status(murk_status status);

/* Whether path ends in extension (".vdb"), in any case. */
bool cli_has_extension(const char *path, const char *extension);

/* Tells the context's message for a failure; passes status on. */
murk_status cli_job_fail(struct cli_job *job, murk_status status);

#endif
