/* SPDX-License-Identifier: Apache-2.0 */
/* What a picture takes: its channels dominate. */
#include "context.h"
#include "murk/memory.h"

uint64_t murk_render_memory(const murk_scene *scene, const murk_camera *camera, size_t bands)
{
    (void)scene;
    const double pixels = (double)camera->size[0] * camera->size[1];
    return (uint64_t)(pixels * sizeof(float) * (double)(12 + 10 * bands));
}
