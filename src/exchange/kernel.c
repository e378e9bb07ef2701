/* SPDX-License-Identifier: Apache-2.0 */
/* Compiled once for each instruction set, with vectors as wide as its registers. */
#include "kernel.h"

#include <string.h>

#ifndef MURK_KERNEL_NAME
#error "MURK_KERNEL_NAME names the function to compile"
#endif

murk_kernel_fn MURK_KERNEL_NAME;

#if defined(__AVX512F__)
#define LANES 16
#elif defined(__AVX__)
#define LANES 8
#else
#define LANES 4
#endif
enum { PIECES = MURK_CHUNK / LANES, BAND = MURK_BRICK_SLOTS / LANES };

typedef float lanes __attribute__((vector_size(4 * LANES)));
typedef int32_t whole __attribute__((vector_size(4 * LANES)));

/* 1 - exp(-x) by its series, relative error below 2e-7 up to x = 0.07 and x = 0.3. */
static inline lanes capture_faint(lanes x)
{
    return x * (1 - x * (1 / 2.f - x * (1 / 6.f - x * (1 / 24.f))));
}

static inline lanes capture_thin(lanes x)
{
    return x *
           (1 - x * (1 / 2.f - x * (1 / 6.f - x * (1 / 24.f - x * (1 / 120.f - x * (1 / 720.f))))));
}

/* The same for any x >= 0. With -x = n ln 2 + r, |r| <= ln 2 / 2, the series of exp(r) - 1 gives
   1 - exp(-x) = 1 - 2^n - 2^n (exp(r) - 1) to 2e-7 of itself, however small x is. */
static inline lanes capture_any(lanes x)
{
    const lanes most = x - x + 80;
    whole below = x < most;
    lanes y = (lanes)((below & (whole)x) | (~below & (whole)most));
    whole n = __builtin_convertvector(y * -1.44269504f - 0.5f, whole);
    lanes r = -y - __builtin_convertvector(n, lanes) * 0.693147181f;
    lanes p = r + r * r * (1 / 2.f + r * (1 / 6.f + r * (1 / 24.f + r * (1 / 120.f + r / 720.f))));
    lanes scale = (lanes)((n + 127) << 23);
    return 1 - scale - scale * p;
}

/* Piece j of the two rows of lines of a chunk. */
#if LANES == 16
typedef float row __attribute__((vector_size(32)));

static inline lanes load_lines(const float *plane, ptrdiff_t stride, int j)
{
    (void)j;
    row a, b;
    memcpy(&a, plane, sizeof a);
    memcpy(&b, plane + stride, sizeof b);
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

static inline void store_lines(float *plane, ptrdiff_t stride, int j, lanes value)
{
    (void)j;
    row a = __builtin_shufflevector(value, value, 0, 1, 2, 3, 4, 5, 6, 7);
    row b = __builtin_shufflevector(value, value, 8, 9, 10, 11, 12, 13, 14, 15);
    memcpy(plane, &a, sizeof a);
    memcpy(plane + stride, &b, sizeof b);
}
#else
static inline lanes load_lines(const float *plane, ptrdiff_t stride, int j)
{
    lanes value;
    memcpy(&value, plane + j * LANES / 8 * stride + j * LANES % 8, sizeof value);
    return value;
}

static inline void store_lines(float *plane, ptrdiff_t stride, int j, lanes value)
{
    memcpy(plane + j * LANES / 8 * stride + j * LANES % 8, &value, sizeof value);
}
#endif

static inline __attribute__((always_inline)) lanes capture(murk_depth depth, lanes x)
{
    return depth == MURK_DEPTH_FAINT  ? capture_faint(x)
           : depth == MURK_DEPTH_THIN ? capture_thin(x)
                                      : capture_any(x);
}

/* Chunk c of a layer over one segment; depth and bands are constants where inlined. */
static inline __attribute__((always_inline)) void cross_chunk(const murk_kernel_job *job, int k,
                                                              int c, float length, float *plane,
                                                              murk_depth depth, int bands)
{
    const lanes *kappa_t = (const lanes *)(job->kappa_t + 64 * k);
    const lanes *source = (const lanes *)(job->source + 64 * k);
    lanes *tally = (lanes *)(job->tally + 64 * k);
    for (int j = 0; j < PIECES; j++) {
        int n = c * PIECES + j;
        lanes part = capture(depth, kappa_t[n] * length);
        float *at = plane + 2 * c * job->stride;
        for (int b = 0; b < bands; b++, at += job->band) {
            lanes light = load_lines(at, job->stride, j);
            lanes taken = part * (light - source[n + b * BAND]);
            tally[n + b * BAND] += job->weight * taken;
            store_lines(at, job->stride, j, light - taken);
        }
    }
}

/* The three of a segment with slopes: e, h and q h. Where x is small h = -x^2 p(x) by its series,
   for e q - 1 is a difference of equals. */
struct bend {
    lanes e, h, k;
};

static inline struct bend bend_of(lanes x)
{
    const lanes small = x - x + 0.7f;
    whole below = x < small;
    lanes y = (lanes)((below & (whole)x) | (~below & (whole)small));
    lanes z = (lanes)((below & (whole)small) | (~below & (whole)x));
    lanes p =
        1 / 12.f -
        y * (1 / 24.f -
             y * (1 / 80.f -
                  y * (1 / 360.f - y * (1 / 2016.f - y * (1 / 13440.f - y * (1 / 103680.f))))));
    lanes e = capture_any(x), q = 0.5f + 1 / z, h = e * q - 1;
    lanes h_series = -y * y * p, k_series = -y * (0.5f * y + 1) * p;
    return (struct bend){e, (lanes)((below & (whole)h_series) | (~below & (whole)h)),
                         (lanes)((below & (whole)k_series) | (~below & (whole)(q * h)))};
}

/* The same as cross_chunk() where sources have slopes. */
static inline __attribute__((always_inline)) void bend_chunk(const murk_kernel_job *job, int k,
                                                             int c, const murk_segment *segment,
                                                             float *plane, int bands)
{
    const lanes *kappa_t = (const lanes *)(job->kappa_t + 64 * k);
    const lanes *source = (const lanes *)(job->source + 64 * k);
    const lanes *slope = (const lanes *)(job->slope + 64 * k);
    lanes *tally = (lanes *)(job->tally + 64 * k);
    lanes *slope_tally = (lanes *)(job->slope_tally + 64 * k);
    const float *m = segment->middle, *d = segment->change;
    for (int j = 0; j < PIECES; j++) {
        int n = c * PIECES + j;
        struct bend bend = bend_of(kappa_t[n] * segment->length);
        float *at = plane + 2 * c * job->stride;
        for (int b = 0; b < bands; b++, at += job->band) {
            const lanes *s = slope + n + 3 * b * BAND;
            lanes light = load_lines(at, job->stride, j);
            lanes above =
                light - source[n + b * BAND] - s[0] * m[0] - s[BAND] * m[1] - s[2 * BAND] * m[2];
            lanes gain = s[0] * d[0] + s[BAND] * d[1] + s[2 * BAND] * d[2];
            lanes taken = bend.e * above + bend.h * gain;
            lanes uneven = job->weight * (bend.h * above + bend.k * gain);
            store_lines(at, job->stride, j, light - taken);
            taken *= job->weight;
            tally[n + b * BAND] += taken;
            for (int a = 0; a < 3; a++)
                slope_tally[n + (3 * b + a) * BAND] += m[a] * taken + d[a] * uneven;
        }
    }
}

static inline __attribute__((always_inline)) void cross_layer(const murk_kernel_job *job, int k,
                                                              uint32_t chunks, murk_depth depth,
                                                              int bands, bool bent)
{
    const murk_layer *layer = &job->layer[k];
    for (int s = 0; s < layer->count; s++) {
        const murk_segment *segment = &layer->segment[s];
        float *plane = job->plane - (layer->shift[1] + segment->dv) * job->stride -
                       (layer->shift[0] + segment->du);
        if (bent)
            for (uint32_t left = chunks; left; left &= left - 1)
                bend_chunk(job, k, __builtin_ctz(left), segment, plane, bands);
        else if (chunks == 0xF) /* most are: no search for the next one */
            for (int c = 0; c < MURK_LAYER_CHUNKS; c++)
                cross_chunk(job, k, c, segment->length, plane, depth, bands);
        else
            for (uint32_t left = chunks; left; left &= left - 1)
                cross_chunk(job, k, __builtin_ctz(left), segment->length, plane, depth, bands);
    }
}

static inline __attribute__((always_inline)) void cross(const murk_kernel_job *job,
                                                        murk_depth depth, int bands, bool bent)
{
    for (int k = job->sign > 0 ? 0 : 7; k >= 0 && k < 8; k += job->sign) {
        uint32_t chunks = job->chunks >> (MURK_LAYER_CHUNKS * k) & 0xF;
        if (chunks)
            cross_layer(job, k, chunks, depth, bands, bent);
    }
}

static inline __attribute__((always_inline)) void choose_bands(const murk_kernel_job *job,
                                                               murk_depth depth, bool bent)
{
    if (job->bands == 1)
        cross(job, depth, 1, bent);
    else if (job->bands == 2)
        cross(job, depth, 2, bent);
    else
        cross(job, depth, 3, bent);
}

void MURK_KERNEL_NAME(const murk_kernel_job *job)
{
    if (job->slope)
        choose_bands(job, MURK_DEPTH_ANY, true);
    else if (job->depth == MURK_DEPTH_FAINT)
        choose_bands(job, MURK_DEPTH_FAINT, false);
    else if (job->depth == MURK_DEPTH_THIN)
        choose_bands(job, MURK_DEPTH_THIN, false);
    else
        choose_bands(job, MURK_DEPTH_ANY, false);
}
