/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels for each instruction set against one another and against plain double precision. */
#include "check.h"
#include "context.h"
#include "kernel.h"

enum { STRIDE = 40, PLANE = STRIDE * STRIDE, AT = 16 * STRIDE + 16, BANDS = MURK_MOST_BANDS };

/* A random brick and random lines through it. */
typedef struct brick {
    _Alignas(64) float kappa_t[512], source[BANDS * 512], tally[BANDS * 512];
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
    for (int i = 0; i < BANDS * PLANE; i++)
        b->plane[i] = (float)(2 * check_random(random));
    b->chunks = check_random(random) < 0.5 ? ~0u : (uint32_t)(check_random(random) * 4294967295.0);
    for (int k = 0; k < 8; k++) {
        murk_layer *layer = &b->layer[k];
        layer->count = 1 + (int)(3 * check_random(random));
        for (int c = 0; c < 2; c++)
            layer->shift[c] = (int32_t)(8 * check_random(random)) - 4;
        for (int s = 0; s < layer->count; s++)
            layer->segment[s] = (murk_segment){.du = s > 0,
                                               .dv = s > 1 ? -1 : 0,
                                               .length = 1.2f / (float)layer->count,
                                               .fraction = 1 / (float)layer->count};
    }
}

static murk_kernel_job job_of(brick *b, int sign, murk_depth depth, int bands)
{
    return (murk_kernel_job){.kappa_t = b->kappa_t,
                             .source = b->source,
                             .tally = b->tally,
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

/* What kernel.h says of one band, line by line. */
static void reference(const brick *b, int sign, int band, double *tally, double *plane)
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
                double t = -expm1(-x) * (plane[at] - b->source[band * 512 + voxel]);
                tally[voxel] += 0.25 * t;
                plane[at] -= t;
            }
        }
    }
}

/* A kernel against double precision, and against another's result where that is given. */
static void check_job(murk_kernel_fn *kernel, const brick *b, int sign, murk_depth depth, int bands,
                      brick *out)
{
    static double tally[512], plane[PLANE];
    *out = *b;
    const murk_kernel_job job = job_of(out, sign, depth, bands);
    kernel(&job);
    for (int band = 0; band < bands; band++) {
        memset(tally, 0, sizeof tally);
        for (int i = 0; i < PLANE; i++)
            plane[i] = b->plane[band * PLANE + i];
        reference(b, sign, band, tally, plane);
        /* Up to 24 steps in floats on values up to 2; a tally is compared as what it stands for. */
        for (int i = 0; i < PLANE; i++)
            assert_within(out->plane[band * PLANE + i], plane[i], 1e-5 * fmax(plane[i], 0.1));
        for (int i = 0; i < 512; i++)
            assert_within(out->tally[band * 512 + i] / b->kappa_t[i], tally[i] / b->kappa_t[i],
                          1e-5 * fmax(fabs(tally[i]) / b->kappa_t[i], 0.1));
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
            check_job(kernel, &b, sign, (murk_depth)depth, bands, &out);
            check_job(portable_kernel, &b, sign, (murk_depth)depth, bands, &portable);
            for (int i = 0; i < bands * PLANE; i++)
                assert_within(out.plane[i], portable.plane[i], 1e-5 * fmax(portable.plane[i], 0.1));
        }
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
            const murk_kernel_job job = job_of(&b, 1, MURK_DEPTH_ANY, 1);
            kernel(&job);
            for (int i = 0; i < PLANE; i++)
                assert_within(b.plane[i], 0.7f, 0);
            for (int i = 0; i < 512; i++)
                assert_within(b.tally[i], 0, 0);
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
