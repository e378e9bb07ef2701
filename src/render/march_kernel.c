/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once for each instruction set; the compiler vectorises the loops over lanes. */
#include "march_kernel.h"

#include "blocks.h"

#include <string.h>

#ifndef MURK_MARCH_NAME
#error "MURK_MARCH_NAME names the function to compile"
#endif

murk_march_fn MURK_MARCH_NAME;

#define LANES  for (int l = 0; l < MURK_LANES; l++)
#define INLINE static inline __attribute__((always_inline))

/* The rays within one brick. Positions in voxels from the brick's low corner, t in metres from
   where the ray enters: floats are good to 5e-7 voxels there, wherever the brick is. */
typedef struct local {
    _Alignas(64) float at[3][MURK_LANES]; /* where the ray enters */
    float along[3][MURK_LANES], inverse[3][MURK_LANES];
    float face[3][MURK_LANES]; /* the next voxel face on each axis */
    float t[MURK_LANES], t_end[MURK_LANES];
    int32_t slot[MURK_LANES];
    float depth[MURK_LANES], tau[MURK_LANES], path[MURK_LANES];
    float before[MURK_LANES], depth_before[MURK_LANES];    /* t and depth where the ray enters */
    float tau_before[MURK_LANES], path_before[MURK_LANES]; /* where the path is recorded */
} local;

INLINE double lesser(double x, double y)
{
    return x < y ? x : y;
}

INLINE double greater(double x, double y)
{
    return x > y ? x : y;
}

INLINE float lesser_float(float x, float y)
{
    return x < y ? x : y;
}

INLINE float greater_float(float x, float y)
{
    return x > y ? x : y;
}

/* Where the rays are inside a box: [enter, leave]. False where none is. */
INLINE bool meet(const murk_box *box, const murk_packet *packet, double enter[MURK_LANES],
                 double leave[MURK_LANES])
{
    double low[3], high[3];
    int any = 0;
    for (int a = 0; a < 3; a++) {
        low[a] = box->low[a] + box->from[a];
        high[a] = box->low[a] + box->to[a];
    }
    LANES
    {
        double from = 0, to = packet->t_max[l];
        for (int a = 0; a < 3; a++) {
            double t0 = (low[a] - packet->origin[a][l]) * packet->inverse[a][l];
            double t1 = (high[a] - packet->origin[a][l]) * packet->inverse[a][l];
            from = greater(from, lesser(t0, t1));
            to = lesser(to, greater(t0, t1));
        }
        enter[l] = from;
        leave[l] = to;
        any |= from < to;
    }
    return any;
}

/* What stays the same in all bricks. */
INLINE void aim(const murk_packet *packet, local *rays)
{
    for (int a = 0; a < 3; a++)
        LANES
        {
            rays->along[a][l] = (float)packet->direction[a][l];
            rays->inverse[a][l] = (float)packet->inverse[a][l];
        }
}

INLINE void start(const murk_box *box, const murk_packet *packet, const double enter[MURK_LANES],
                  const double leave[MURK_LANES], local *rays)
{
    _Alignas(64) double x[3][MURK_LANES], inside[MURK_LANES];
    LANES inside[l] = greater(leave[l] - enter[l], 0);
    for (int a = 0; a < 3; a++)
        LANES x[a][l] = packet->origin[a][l] + packet->direction[a][l] * enter[l] - box->low[a];
    LANES
    {
        rays->t_end[l] = (float)inside[l];
        rays->before[l] = (float)enter[l];
        rays->depth_before[l] = (float)packet->depth[l];
        for (int a = 0; a < 3; a++)
            rays->at[a][l] = (float)x[a][l];
    }
    LANES
    {
        rays->t[l] = rays->depth[l] = rays->path[l] = 0;
        rays->tau[l] = 1;
        rays->slot[l] = 0;
    }
    for (int a = 0; a < 3; a++) {
        float from = box->from[a], to = box->to[a];
        int last = box->to[a] - 1, stride = 1 << 3 * (2 - a);
        LANES
        {
            float at = lesser_float(greater_float(rays->at[a][l], from), to);
            float inverse = rays->inverse[a][l];
            int cell = (int)at;
            cell = cell > last ? last : cell;
            rays->at[a][l] = at;
            rays->face[a][l] = (float)(cell + (inverse > 0));
            rays->slot[l] += stride * cell;
            /* The same product as at the last face, so that no lane steps out of the box. */
            rays->t_end[l] =
                lesser_float(rays->t_end[l], ((inverse > 0 ? to : from) - at) * inverse);
        }
    }
}

/* (1 - exp(-x)) / x for x >= 0, and the mean distance, as a fraction of a step of optical length x,
   at which the light of a constant source leaves for the viewer: one sample there is exact for a
   source that varies linearly. */
typedef struct terms {
    float phi, centre;
} terms;

/* By their series: good to 2e-7 below MURK_DEPTH_ANY. */
INLINE terms thin_terms(float x)
{
    return (terms){1 - x * (1 / 2.f - x * (1 / 6.f - x * (1 / 24.f - x * (1 / 120.f - x / 720.f)))),
                   0.5f - x * (1 / 12.f - x * x / 720.f)};
}

/* For any x: exp(-x) = 2^n exp(r) as in the kernel of the sweep; 1/x - e^{-x}/(1 - e^{-x}) from its
   series up to 1, where terms would cancel. */
INLINE terms thick_terms(float x)
{
    const float tiny = 1e-30f;
    float y = lesser_float(x, 80), s = lesser_float(x, 1);
    float n = (float)(int32_t)(y * -1.44269504f - 0.5f);
    float r = -y - n * 0.693147181f;
    float p = r + r * r * (1 / 2.f + r * (1 / 6.f + r * (1 / 24.f + r * (1 / 120.f + r / 720.f))));
    int32_t bits = ((int32_t)n + 127) << 23;
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    float phi = (1 - scale - scale * p + tiny) / (x + tiny), q = s * s;
    float near = 0.5f - s * (1 / 12.f - q * (1 / 720.f - q * (1 / 30240.f - q / 1209600.f)));
    float far = 1 - (1 - phi) / (x * phi + tiny);
    return (terms){phi, x < 1 ? near : far};
}

/* Between p[0] and p[1], fetched as one word: of all memory that a step reads, these are most. */
INLINE float between(const float *p, float w)
{
    const int first = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? 0 : 32;
    uint64_t both;
    memcpy(&both, p, sizeof both);
    uint32_t bits0 = (uint32_t)(both >> first), bits1 = (uint32_t)(both >> (32 - first));
    float x, y;
    memcpy(&x, &bits0, sizeof x);
    memcpy(&y, &bits1, sizeof y);
    return x + w * (y - x);
}

/* B at a point of the brick, trilinear between voxel centres, the first of which is outside: with
   every coordinate in [0, 8], give or take a rounding, all eight are in the block. */
INLINE float sample(const float *block, float x, float y, float z)
{
    x += 0.5f;
    y += 0.5f;
    z += 0.5f;
    int i = (int)x, j = (int)y, k = (int)z;
    const int X = MURK_BLOCK_EDGE * MURK_BLOCK_EDGE, Y = MURK_BLOCK_EDGE;
    float u = x - (float)i, v = y - (float)j, w = z - (float)k;
    int n = i * X + j * Y + k;
    float b00 = between(block + n, w), b01 = between(block + n + Y, w);
    float b10 = between(block + n + X, w), b11 = between(block + n + X + Y, w);
    float b0 = b00 + v * (b01 - b00), b1 = b10 + v * (b11 - b10);
    return b0 + u * (b1 - b0);
}

/* To the next voxel of each ray, or its end; returns whether any goes on. */
INLINE bool step(const float *restrict kappa_t, const float *restrict block, local *restrict rays,
                 murk_passed *restrict passed, float *restrict path, bool keep, bool record,
                 bool light, bool thin)
{
    int any = 0;
#pragma omp simd reduction(| : any)
    LANES
    {
        float n0 = (rays->face[0][l] - rays->at[0][l]) * rays->inverse[0][l];
        float n1 = (rays->face[1][l] - rays->at[1][l]) * rays->inverse[1][l];
        float n2 = (rays->face[2][l] - rays->at[2][l]) * rays->inverse[2][l];
        float t = rays->t[l], t_end = rays->t_end[l];
        float next = lesser_float(lesser_float(n0, n1), n2);
        float t1 = greater_float(lesser_float(next, t_end), t);
        float kappa = kappa_t[rays->slot[l]], length = t1 - t, x = kappa * length;
        rays->depth[l] += x;
        rays->t[l] = t1;
        if (light) {
            terms of = thin ? thin_terms(x) : thick_terms(x);
            float at = t + length * of.centre, taken = rays->tau[l] * (x * of.phi);
            float b = sample(block, rays->at[0][l] + rays->along[0][l] * at,
                             rays->at[1][l] + rays->along[1][l] * at,
                             rays->at[2][l] + rays->along[2][l] * at);
            rays->path[l] += taken * b;
            rays->tau[l] -= taken;
        }
        if (record)
            path[l] = rays->path_before[l] + rays->tau_before[l] * rays->path[l];
        if (keep) {
            passed->t[l] = rays->before[l] + t1;
            passed->depth[l] = rays->depth_before[l] + rays->depth[l];
            passed->kappa_t[l] = kappa;
        }
        int on = t1 < t_end;
        int s0 = rays->inverse[0][l] > 0 ? 1 : -1, s1 = rays->inverse[1][l] > 0 ? 1 : -1,
            s2 = rays->inverse[2][l] > 0 ? 1 : -1;
        s0 = (on & (n0 <= next)) ? s0 : 0;
        s1 = (on & (n1 <= next)) ? s1 : 0;
        s2 = (on & (n2 <= next)) ? s2 : 0;
        rays->face[0][l] += (float)s0;
        rays->face[1][l] += (float)s1;
        rays->face[2][l] += (float)s2;
        rays->slot[l] += 64 * s0 + 8 * s1 + s2;
        any |= on;
    }
    return any;
}

INLINE void run(const float *kappa_t, const float *block, local *rays, murk_trace *trace, bool keep,
                bool light, bool thin)
{
    bool on = true;
    while (on)
        on = step(kappa_t, block, rays, keep ? &trace->passed[trace->count++] : NULL, NULL, keep,
                  false, light, thin);
}

/* The same, with the path of the packet. */
INLINE void run_recorded(const float *kappa_t, const float *block, const murk_packet *packet,
                         local *rays, murk_trace *trace, bool light, bool thin)
{
    LANES
    {
        rays->tau_before[l] = (float)packet->tau[l];
        rays->path_before[l] = (float)packet->path[l];
    }
    bool on = true;
    for (; on; trace->count++)
        on = step(kappa_t, block, rays, &trace->passed[trace->count], trace->path[trace->count],
                  true, true, light, thin);
}

size_t MURK_MARCH_NAME(const murk_marched *medium, const int32_t *brick, size_t count,
                       murk_packet *packet, murk_trace *trace)
{
    _Alignas(64) double enter[MURK_LANES], leave[MURK_LANES];
    local rays;
    aim(packet, &rays);
    int seen = 1;
    for (size_t i = 0; i < count; i++) {
        if (trace && trace->capacity - trace->count < MURK_BRICK_STEPS)
            return i;
        const murk_box *box = &medium->box[brick[i]];
        if (!meet(box, packet, enter, leave))
            continue;
        const float *kappa_t = medium->kappa_t + (size_t)brick[i] * MURK_BRICK_SLOTS;
        const float *block = medium->blocks + (size_t)brick[i] * MURK_BLOCK_SLOTS;
        start(box, packet, enter, leave, &rays);
        if (!trace)
            run(kappa_t, block, &rays, NULL, false, false, false);
        else if (trace->records && !seen)
            run_recorded(kappa_t, block, packet, &rays, trace, false, false);
        else if (trace->records && box->thin)
            run_recorded(kappa_t, block, packet, &rays, trace, true, true);
        else if (trace->records)
            run_recorded(kappa_t, block, packet, &rays, trace, true, false);
        else if (!seen)
            run(kappa_t, block, &rays, trace, true, false, false);
        else if (box->thin)
            run(kappa_t, block, &rays, trace, true, true, true);
        else
            run(kappa_t, block, &rays, trace, true, true, false);
        seen = 0;
        LANES
        {
            packet->depth[l] += rays.depth[l];
            packet->path[l] += packet->tau[l] * rays.path[l];
            packet->tau[l] *= rays.tau[l];
            seen |= packet->tau[l] >= MURK_OPAQUE;
        }
    }
    return count;
}
