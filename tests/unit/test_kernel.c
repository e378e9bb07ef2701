/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels for each instruction set against one another and against plain double precision. */
#include "check.h"
#include "context.h"
#include "kernel.h"

enum { STRIDE = 40, PLANE = STRIDE * STRIDE, AT = 16 * STRIDE + 16, BANDS = MURK_MOST_BANDS };

/* A random brick and random lines through it. */
typedef struct brick {
    _Alignas(64) float kappa_t[512], source[BANDS * 512], tally[BANDS * 512];
    _Alignas(64) float slope[3 * BANDS * 512], slope_tally[3 * BANDS * 512];
    float plane[BANDS * PLANE];
    murk_layer layer[8];
    uint32_t chunks;
} brick;

/* Optical depths of a segment up to about `most`. */
static void fill(brick *b, double most, uint64_t *random)
{
    for (int i = 0; i < 512; i++) {
        double x = check_random(random);
        b->kappa_t[i] = x < 0.2 ? 1e-12f : (float)(most * x * x); /* some are no zones */
    }
    for (int i = 0; i < BANDS * 512; i++) {
        b->source[i] = (float)check_random(random);
        b->tally[i] = 0;
    }
    for (int i = 0; i < 3 * BANDS * 512; i++) {
        b->slope[i] = (float)(check_random(random) - 0.5);
        b->slope_tally[i] = 0;
    }
    for (int i = 0; i < BANDS * PLANE; i++)
        b->plane[i] = (float)(2 * check_random(random));
    b->chunks = check_random(random) < 0.5 ? ~0u : (uint32_t)(check_random(random) * 4294967295.0);
    for (int k = 0; k < 8; k++) {
        murk_layer *layer = &b->layer[k];
        layer->count = 1 + (int)(3 * check_random(random));
        for (int c = 0; c < 2; c++)
            layer->shift[c] = (int32_t)(8 * check_random(random)) - 4;
        for (int s = 0; s < layer->count; s++) {
            murk_segment *segment = &layer->segment[s];
            *segment = (murk_segment){
                .du = s > 0, .dv = s > 1 ? -1 : 0, .length = 1.2f / (float)layer->count};
            for (int c = 0; c < 3; c++) {
                segment->middle[c] = (float)(check_random(random) - 0.5);
                segment->change[c] = (float)(check_random(random) - 0.5);
            }
        }
    }
}

static murk_kernel_job job_of(brick *b, int sign, murk_depth depth, int bands, bool bent)
{
    return (murk_kernel_job){.kappa_t = b->kappa_t,
                             .source = b->source,
                             .tally = b->tally,
                             .slope = bent ? b->slope : NULL,
                             .slope_tally = bent ? b->slope_tally : NULL,
                             .chunks = b->chunks,
                             .bands = bands,
                             .depth = depth,
                             .plane = b->plane + AT,
                             .stride = STRIDE,
                             .band = PLANE,
                             .layer = b->layer,
                             .sign = sign,
                             .weight = 0.25f};
}

/* The integrals over a segment of dI/du = -x (I - source), source = middle + g (u - 1/2): of
   x (I - source), and of that times u - 1/2, which is the first moment of I' = -x (I - source). */
static void segment_integrals(double x, double above, double g, double t[2])
{
    double e = -expm1(-x), away = above + g / 2 + g / x; /* I - source + g/x at the start */
    t[0] = away * e - g;
    t[1] = away * ((e - x * exp(-x)) / x - e / 2);
}

/* What kernel.h says of one band, line by line. */
static void reference(const brick *b, int sign, int band, bool bent, double *tally,
                      double *slope_tally, double *plane)
{
    for (int n = 0; n < 8; n++) {
        int k = sign > 0 ? n : 7 - n;
        const murk_layer *layer = &b->layer[k];
        for (int s = 0; s < layer->count; s++) {
            const murk_segment *segment = &layer->segment[s];
            for (int in = 0; in < 64; in++) {
                int u = in % 8, v = in / 8, voxel = 64 * k + in;
                int at = AT + (v - layer->shift[1] - segment->dv) * STRIDE + u - layer->shift[0] -
                         segment->du;
                if (!(b->chunks >> (4 * k + v / 2) & 1))
                    continue;
                double x = (double)b->kappa_t[voxel] * segment->length;
                double above = plane[at] - b->source[band * 512 + voxel], gain = 0;
                double t[2] = {-expm1(-x) * above, 0};
                for (int a = 0; bent && a < 3; a++) {
                    double slope = b->slope[(3 * band + a) * 512 + voxel];
                    above -= slope * segment->middle[a];
                    gain += slope * segment->change[a];
                }
                if (bent && x > 1e-3)
                    segment_integrals(x, above, gain, t);
                else if (bent) { /* to the order of x^2 */
                    t[0] = (x - x * x / 2) * above - x * x / 12 * gain;
                    t[1] = -x * x / 12 * above - x / 12 * gain;
                }
                tally[voxel] += 0.25 * t[0];
                for (int a = 0; a < 3; a++)
                    slope_tally[a * 512 + voxel] +=
                        0.25 * (segment->middle[a] * t[0] + segment->change[a] * t[1]);
                plane[at] -= t[0];
            }
        }
    }
}

/* A tally is compared as what it stands for, up to 24 steps in floats on values up to 2. */
static void check_tally(const float *tally, const double *wanted, const float *kappa_t)
{
    for (int i = 0; i < 512; i++)
        assert_within(tally[i] / kappa_t[i], wanted[i] / kappa_t[i],
                      1e-5 * fmax(fabs(wanted[i]) / kappa_t[i], 0.1));
}

/* A kernel against double precision. */
static void check_job(murk_kernel_fn *kernel, const brick *b, int sign, murk_depth depth, int bands,
                      bool bent, brick *out)
{
    static double tally[512], slope_tally[3 * 512], plane[PLANE];
    *out = *b;
    const murk_kernel_job job = job_of(out, sign, depth, bands, bent);
    kernel(&job);
    for (int band = 0; band < bands; band++) {
        memset(tally, 0, sizeof tally);
        memset(slope_tally, 0, sizeof slope_tally);
        for (int i = 0; i < PLANE; i++)
            plane[i] = b->plane[band * PLANE + i];
        reference(b, sign, band, bent, tally, slope_tally, plane);
        for (int i = 0; i < PLANE; i++)
            assert_within(out->plane[band * PLANE + i], plane[i], 1e-5 * fmax(fabs(plane[i]), 0.1));
        check_tally(out->tally + band * 512, tally, b->kappa_t);
        for (int a = 0; bent && a < 3; a++)
            check_tally(out->slope_tally + (3 * band + a) * 512, slope_tally + a * 512, b->kappa_t);
    }
}

static void check_kernel(const char *name)
{
    murk_context_options options = MURK_CONTEXT_DEFAULT;
    options.kernel = name;
    murk_context *context = NULL;
    murk_kernel_fn *kernel = NULL;
    const char *chosen = NULL;
    if (murk_context_create(&options, &context) || murk_kernel_choose(context, &kernel, &chosen)) {
        murk_context_release(context);
        print_message("this processor cannot run %s\n", name);
        skip();
    }
    assert_string_equal(chosen, name);
    murk_context_release(context);
    static const double depths[] = {1e-4, 0.01, 0.05, 0.24, 1, 10, 200};
    static brick b, out, portable;
    murk_context *plain = check_context(1, "portable");
    murk_kernel_fn *portable_kernel = NULL;
    murk_kernel_choose(plain, &portable_kernel, &chosen);
    murk_context_release(plain);
    uint64_t random = 10;
    for (int n = 0; n < 84; n++) {
        double most = depths[n % 7];
        int sign = n % 4 < 2 ? 1 : -1, bands = 1 + n % BANDS;
        fill(&b, most, &random);
        /* By the series that its depth allows and by the more general ones. */
        for (int depth = (int)murk_depth_of(1.2 * most); depth <= MURK_DEPTH_ANY; depth++) {
            check_job(kernel, &b, sign, (murk_depth)depth, bands, false, &out);
            check_job(portable_kernel, &b, sign, (murk_depth)depth, bands, false, &portable);
            for (int i = 0; i < bands * PLANE; i++)
                assert_within(out.plane[i], portable.plane[i], 1e-5 * fmax(portable.plane[i], 0.1));
        }
        check_job(kernel, &b, sign, MURK_DEPTH_ANY, bands, true, &out);
    }
}

static void portable(void **state)
{
    (void)state;
    check_kernel("portable");
}

static void avx2(void **state)
{
    (void)state;
    check_kernel("avx2");
}

static void avx512(void **state)
{
    (void)state;
    check_kernel("avx512");
}

/* Where source and light are equal nothing may change, to the last bit: an isothermal enclosure
   stays so at any depth. */
static void equilibrium(void **state)
{
    (void)state;
    static const char *const names[] = {"portable", "avx2", "avx512"};
    static brick b;
    for (int n = 0; n < 3; n++) {
        murk_context_options options = MURK_CONTEXT_DEFAULT;
        options.kernel = names[n];
        murk_context *context = NULL;
        murk_kernel_fn *kernel = NULL;
        const char *name = NULL;
        if (!murk_context_create(&options, &context) &&
            !murk_kernel_choose(context, &kernel, &name)) {
            uint64_t random = 11;
            fill(&b, 30, &random);
            for (int i = 0; i < 512; i++)
                b.source[i] = 0.7f;
            for (int i = 0; i < PLANE; i++)
                b.plane[i] = 0.7f;
            memset(b.slope, 0, sizeof b.slope);
            for (int bent = 0; bent < 2; bent++) {
                const murk_kernel_job job = job_of(&b, 1, MURK_DEPTH_ANY, 1, bent);
                kernel(&job);
                for (int i = 0; i < PLANE; i++)
                    assert_within(b.plane[i], 0.7f, 0);
                for (int i = 0; i < 512; i++)
                    assert_within(b.tally[i], 0, 0);
                for (int i = 0; i < 3 * 512; i++)
                    assert_within(b.slope_tally[i], 0, 0);
            }
        }
        murk_context_release(context);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(portable),
        cmocka_unit_test(avx2),
        cmocka_unit_test(avx512),
        cmocka_unit_test(equilibrium),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
