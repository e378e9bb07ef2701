/* SPDX-License-Identifier: Apache-2.0 */
/* How murk bake looks at a medium, and the lights that go with it. */
#ifndef CLI_BAKE_VIEW_H
#define CLI_BAKE_VIEW_H

#include "job.h"

/* In the order of the textures' channels: the first three are those of NAME_positive. */
enum { CLI_BAKE_SIDES = 6 };
extern const char *const CLI_BAKE_SIDE[CLI_BAKE_SIDES];

/* A box in the world [m]. */
struct cli_bake_box {
    double low[3], high[3];
};

void cli_bake_box_add(struct cli_bake_box *box, const murk_medium_info *info);

/* The parallel camera that sees all of the box, but for one pixel on each side that textures are
   filtered across: along the line of sight of the job's scene or options, or else from the front.
   Fails for a line of sight that is none. */
murk_status cli_bake_camera(struct cli_job *job, const struct cli_bake_box *box, murk_camera *out);

/* The light from a side, as the camera sees it, of the irradiance pi: a white surface across it has
   the radiance 1. */
murk_sun cli_bake_light(const murk_camera *camera, int side);

#endif
