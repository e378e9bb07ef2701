/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once for each instruction set; the compiler vectorises the loops over 64 voxels. */
#include "kernel.h"

#include <string.h>

#ifndef MURK_KERNEL_NAME
#error "MURK_KERNEL_NAME names the function to compile"
#endif

murk_kernel_fn MURK_KERNEL_NAME;

/* (1 - exp(-x)) / x for 0 <= x <= MURK_THIN: its series to x^5, relative error below 2e-7. */
static inline float phi_thin(float x)
{
    return 1 - x * (1 / 2.f - x * (1 / 6.f - x * (1 / 24.f - x * (1 / 120.f - x / 720.f))));
}

/* The same for any x >= 0, without a branch. With -x = n ln 2 + r, |r| <= ln 2 / 2, the series of
   exp(r) - 1 gives 1 - exp(-x) = 1 - 2^n - 2^n (exp(r) - 1) to 2e-7 of itself, however small x is;
   the tiny addend makes phi(0) = 1. */
static inline float phi_thick(float x)
{
    float y = x < 80 ? x : 80;
    float n = (float)(int32_t)(y * -1.44269504f - 0.5f);
    float r = -y - n * 0.693147181f;
    float p = r + r * r * (1 / 2.f + r * (1 / 6.f + r * (1 / 24.f + r * (1 / 120.f + r / 720.f))));
    int32_t bits = ((int32_t)n + 127) << 23;
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    const float tiny = 1e-30f;
    return (1 - scale - scale * p + tiny) / (x + tiny);
}

static inline void load(float *line, const float *plane, ptrdiff_t stride)
{
    for (int v = 0; v < 8; v++)
        memcpy(line + 8 * v, plane + v * stride, 8 * sizeof *line);
}

static inline void store(float *plane, const float *line, ptrdiff_t stride)
{
    for (int v = 0; v < 8; v++)
        memcpy(plane + v * stride, line + 8 * v, 8 * sizeof *line);
}

#define SEGMENT(PHI)                                                                               \
    for (int i = 0; i < 64; i++) {                                                                 \
        float x = kappa_t[i] * length;                                                             \
        float t = PHI(x) * (line[i] - source[i]);                                                  \
        tally[i] += weight * t;                                                                    \
        line[i] -= x * t;                                                                          \
    }

void MURK_KERNEL_NAME(const murk_kernel_job *job)
{
    _Alignas(64) float line[64];
    for (int k = job->sign > 0 ? 0 : 7; k >= 0 && k < 8; k += job->sign) {
        const murk_layer *layer = &job->layer[k];
        const float *restrict kappa_t = __builtin_assume_aligned(job->kappa_t + 64 * k, 64);
        const float *restrict source = __builtin_assume_aligned(job->source + 64 * k, 64);
        float *restrict tally = __builtin_assume_aligned(job->tally + 64 * k, 64);
        for (int s = 0; s < layer->count; s++) {
            const murk_segment *segment = &layer->segment[s];
            float length = segment->length, weight = job->weight * segment->fraction;
            float *plane = job->plane - (layer->shift[1] + segment->dv) * job->stride -
                           (layer->shift[0] + segment->du);
            load(line, plane, job->stride);
            if (job->thin) {
                SEGMENT(phi_thin)
            } else {
                SEGMENT(phi_thick)
            }
            store(plane, line, job->stride);
        }
    }
}
