/* SPDX-License-Identifier: Apache-2.0 */
/* What a picture takes: its channels dominate, and of large media the blocks that rays cross. */
#include "blocks.h"
#include "forward.h"
#include "memory.h"
#include "murk/deep.h"
#include "murk/memory.h"

/* Floats of a voxel that a march holds: its block, and while it is made the field that it is of. */
static double march_floats(const murk_medium *medium)
{
    const double block = (double)MURK_BLOCK_SLOTS / MURK_BRICK_SLOTS;
    double floats = block;
    if (medium->emission.field || medium->emission.constant > 0)
        floats += block + 1;
    if (medium->asymmetry != 0) /* a reduced medium each, with its beam while it is made */
        floats += MURK_FORWARD_TERMS * (block + 2) + 4;
    return floats;
}

static double medium_bytes(const murk_scene *scene)
{
    /* Places of the bricks in the picture, and their boxes. */
    const double brick = 256;
    if (!scene->medium)
        return 0;
    return (double)scene->medium->grid->brick_count *
           (march_floats(scene->medium) * MURK_BRICK_SLOTS * sizeof(float) + brick);
}

static double pixels_of(const murk_camera *camera)
{
    return (double)camera->size[0] * camera->size[1];
}

uint64_t murk_render_memory(const murk_scene *scene, const murk_camera *camera, size_t bands)
{
    /* Channels of a picture; with the parts that those of bands are put together from; and of the
       picture of bands: its own, and layers of each. */
    enum { CHANNELS = 12, WITH_PARTS = 18, OWN = 13, LAYERS = 7 };
    /* A copy in 8 bits or of the colours, and what encodes it. */
    const double encoded = 4;
    const double channels = bands ? WITH_PARTS + OWN + LAYERS * (double)bands : CHANNELS;
    return (uint64_t)(1e5 + medium_bytes(scene) +
                      pixels_of(camera) * sizeof(float) * (channels + encoded));
}

uint64_t murk_render_deep_memory(const murk_scene *scene, const murk_camera *camera, size_t bands)
{
    /* Measured on smoke that the default camera frames: 3 to 6 over all pixels, in arrays that
       double as they grow. Inside of smoke there may be 30. */
    const double samples = 10, each = sizeof(murk_deep_sample);
    const double pixel = sizeof(size_t) + sizeof(uint32_t);
    const double shots = bands > 1 ? 3 : 1;
    return (uint64_t)(1e5 + shots * medium_bytes(scene) +
                      pixels_of(camera) * (samples * each + pixel));
}
