/* SPDX-License-Identifier: Apache-2.0 */
#include "levels.h"

#include <math.h>

murk_status murk_source_build(const murk_system *system, const murk_solution *solution,
                              const murk_stage *stage, murk_vector *b, murk_outside *outside)
{
    const murk_medium *medium = system->medium;
    const murk_ground *ground = system->ground;
    const murk_radiosity in = {.sky = M_PI * solution->sky_radiance, .horizon = solution->horizon};
    murk_outside sums = {0};
    murk_incident out = {.zone = b->zone, .patch = ground ? b->patch : NULL};
    if (in.sky > 0 || (ground && in.horizon > 0)) {
        murk_status status = system->method->apply(system->context, system->state, &in, &out);
        if (status)
            return status;
    } else {
        for (size_t i = 0; i < system->slots; i++)
            b->zone[i] = 0;
        for (size_t i = 0; i < system->patches; i++)
            b->patch[i] = 0;
    }
    sums.diffuse = out.net_power;
    for (size_t brick = 0; brick < medium->grid->brick_count; brick++) {
        const float *beam = stage->beam + (size_t)stage->map[brick] * MURK_BRICK_SLOTS;
        for (size_t s = 0; s < MURK_BRICK_SLOTS; s++) {
            size_t i = brick * MURK_BRICK_SLOTS + s;
            double weight = 4 * medium->grid->volume * medium->kappa_t[i];
            float albedo = murk_value(&medium->albedo, i), incident = b->zone[i] + beam[s] / 4;
            b->zone[i] = weight > 0
                             ? albedo * incident + (1 - albedo) * murk_value(&medium->emission, i)
                             : 0;
            sums.absorbed += weight * (1 - albedo) * incident;
        }
    }
    for (size_t i = 0; i < system->patches; i++)
        b->patch[i] =
            ground->emission[i] + ground->reflectance[i] * (stage->patch_sun[i] + b->patch[i]);
    *outside = sums;
    return MURK_OK;
}
