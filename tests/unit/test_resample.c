/* SPDX-License-Identifier: Apache-2.0 */
/* Quantities from one transform to another, against closed forms. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "resample.h"

#include <math.h>
#include <string.h>

typedef double field(double x, double y, double z);

static double linear(double x, double y, double z)
{
    return 3 + 0.5 * x - 0.25 * y + 0.125 * z;
}

static double constant(double x, double y, double z)
{
    (void)x, (void)y, (void)z;
    return 7;
}

/* Any values without order. */
static double noise(double x, double y, double z)
{
    double s = sin(12.9898 * x + 78.233 * y + 37.719 * z) * 43758.5453;
    return s - floor(s);
}

/* Voxels of given edges, turned about z, with voxel (0, 0, 0) at a place. */
typedef struct frame {
    double edge[3], angle, place[3];
} frame;

static void set_transform(murk_bricks *bricks, const frame *f)
{
    const double c = cos(f->angle), s = sin(f->angle);
    const double m[16] = {c * f->edge[0],
                          -s * f->edge[1],
                          0,
                          f->place[0],
                          s * f->edge[0],
                          c * f->edge[1],
                          0,
                          f->place[1],
                          0,
                          0,
                          f->edge[2],
                          f->place[2],
                          0,
                          0,
                          0,
                          1};
    memcpy(bricks->index_to_world, m, sizeof m);
}

static void find_world(const murk_bricks *bricks, const double index[3], double world[3])
{
    const double *m = bricks->index_to_world;
    for (int r = 0; r < 3; r++)
        world[r] =
            m[4 * r] * index[0] + m[4 * r + 1] * index[1] + m[4 * r + 2] * index[2] + m[4 * r + 3];
}

static bool is_active(const murk_bricks *bricks, size_t b, int slot)
{
    return bricks->mask[b][slot >> 6] >> (slot & 63) & 1;
}

/* The box of bricks [lo, hi) with all voxels active and the field's values at their centres. */
static murk_bricks make_box(const frame *f, const int lo[3], const int hi[3], field *values)
{
    size_t count = (size_t)((hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2])), b = 0;
    murk_bricks bricks = {.count = count,
                          .brick = murk_alloc(count, sizeof *bricks.brick),
                          .mask = murk_alloc(count, sizeof *bricks.mask),
                          .values = murk_alloc(count * MURK_BRICK_SLOTS, sizeof(float))};
    set_transform(&bricks, f);
    memset(bricks.mask, 0xff, count * sizeof *bricks.mask);
    for (int x = lo[0]; x < hi[0]; x++)
        for (int y = lo[1]; y < hi[1]; y++)
            for (int z = lo[2]; z < hi[2]; z++, b++) {
                const int32_t place[3] = {x, y, z};
                memcpy(bricks.brick[b], place, sizeof place);
                for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
                    const double index[3] = {8 * x + (slot >> 6), 8 * y + (slot >> 3 & 7),
                                             8 * z + (slot & 7)};
                    double world[3];
                    find_world(&bricks, index, world);
                    bricks.values[b * MURK_BRICK_SLOTS + (size_t)slot] =
                        (float)values(world[0], world[1], world[2]);
                }
            }
    return bricks;
}

static const int far_lo[3] = {-4, -4, -4}, far_hi[3] = {4, 4, 4};
static const int near_lo[3] = {-1, -1, -1}, near_hi[3] = {1, 1, 1};

static murk_bricks resample(murk_context *context, murk_bricks *source, const murk_bricks *target,
                            murk_absence absence, bool corner, murk_resample_report *report)
{
    const murk_resample_options options = {.absence = absence, .corner = corner};
    murk_bricks out = {0};
    if (murk_resample(context, source, target, &options, &out, report))
        fail_msg("%s", murk_context_message(context));
    assert_int_equal(out.count, target->count);
    assert_memory_equal(out.brick, target->brick, out.count * sizeof *out.brick);
    assert_memory_equal(out.mask, target->mask, out.count * sizeof *out.mask);
    assert_memory_equal(out.index_to_world, target->index_to_world, sizeof out.index_to_world);
    return out;
}

static const frame frames[] = {
    {{0.1, 0.1, 0.1}, 0, {0, 0, 0}},           /* the target's own */
    {{0.1, 0.1, 0.1}, 0, {0.03, -0.02, 0.01}}, /* shifted */
    {{0.25, 0.25, 0.25}, 0, {0.05, 0, 0}},     /* coarser */
    {{0.05, 0.05, 0.05}, 0, {0.025, 0, 0}},    /* finer */
    {{0.04, 0.1, 0.3}, 0, {0, 0, 0}},          /* both */
    {{0.08, 0.13, 0.11}, 0.6, {0.2, 0.1, 0}},  /* turned */
    {{0.03, 0.07, 0.2}, 2.5, {0, 0, 0.1}},     /* turned by more than a right angle */
    {{0.02, 0.02, 0.02}, 0.3, {0, 0, 0}},      /* turned, and fine enough to be halved */
    {{-0.1, 0.1, 0.05}, 0, {0.01, 0, 0}},      /* mirrored */
};

/* Linear fields and constants stay what they are where the source is all around: of the finest, in
   the inner half of the target. */
static void test_linear(void **state)
{
    static field *const fields[] = {linear, constant};
    const frame own = {{0.1, 0.1, 0.1}, 0, {0, 0, 0}};
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++)
        for (int n = 0; n < 2; n++)
            for (int corner = 0; corner < 2; corner++) {
                murk_resample_report report;
                murk_bricks source = make_box(&frames[i], far_lo, far_hi, fields[n]);
                murk_bricks target = make_box(&own, near_lo, near_hi, fields[n]);
                murk_bricks out = resample(*state, &source, &target,
                                           n ? MURK_ABSENT_IS_BACKGROUND : MURK_ABSENT_IS_UNKNOWN,
                                           corner, &report);
                double shift[2];
                for (int s = 0; s < 2; s++) { /* of corners, the centres are half a voxel on */
                    const double *m = (s ? &target : &source)->index_to_world;
                    shift[s] = corner && !n ? 0.5 * (linear(m[0] + m[1] + m[2], m[4] + m[5] + m[6],
                                                            m[8] + m[9] + m[10]) -
                                                     3)
                                            : 0;
                }
                for (size_t b = 0; b < out.count; b++)
                    for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
                        size_t k = b * MURK_BRICK_SLOTS + (size_t)slot;
                        const int at[3] = {8 * out.brick[b][0] + (slot >> 6),
                                           8 * out.brick[b][1] + (slot >> 3 & 7),
                                           8 * out.brick[b][2] + (slot & 7)};
                        double wanted = target.values[k] + shift[1] - shift[0];
                        bool inner = at[0] >= -4 && at[0] < 4 && at[1] >= -4 && at[1] < 4 &&
                                     at[2] >= -4 && at[2] < 4;
                        if (inner && fabs(out.values[k] - wanted) > 2e-6)
                            fail_msg("frame %zu, corner %d: %.8g for %.8g", i, corner,
                                     (double)out.values[k], wanted);
                    }
                murk_bricks_clear(&source);
                murk_bricks_clear(&target);
                murk_bricks_clear(&out);
            }
}

static double sum(const murk_bricks *bricks, double volume)
{
    double all = 0;
    for (size_t i = 0; i < bricks->count * MURK_BRICK_SLOTS; i++)
        all += bricks->values[i];
    return all * volume;
}

/* A finer grid of any values keeps its mean, wherever its voxels lie between those of the target;
   background around both. */
static void test_mean(void **state)
{
    const frame own = {{0.12, 0.12, 0.12}, 0, {0, 0, 0}};
    const int lo[3] = {0, 0, 0}, hi[3] = {3, 3, 3}, wide_lo[3] = {-1, -1, -1},
              wide_hi[3] = {4, 4, 4};
    for (int ratio = 1; ratio <= 4; ratio++)
        for (int n = 0; n < 3; n++) {
            const double edge = 0.12 / ratio, place = 0.013 * n;
            const frame fine = {{edge, edge, edge}, 0, {place, -place, 0.3 * n}};
            murk_resample_report report;
            murk_bricks source = make_box(&fine, lo, hi, noise);
            murk_bricks target = make_box(&own, wide_lo, wide_hi, constant);
            murk_bricks out =
                resample(*state, &source, &target, MURK_ABSENT_IS_BACKGROUND, false, &report);
            const double before = sum(&source, pow(edge, 3)), after = sum(&out, pow(0.12, 3));
            assert_true(fabs(after / before - 1) < 1e-6);
            murk_bricks_clear(&source);
            murk_bricks_clear(&target);
            murk_bricks_clear(&out);
        }
}

/* Ratios that are not whole, or beyond 4: the mean over many voxels. */
static void test_mean_odd(void **state)
{
    static const double ratios[] = {1.5, 2.7, 5, 8, 11.3};
    const frame own = {{0.12, 0.12, 0.12}, 0, {0, 0, 0}};
    const int lo[3] = {0, 0, 0}, hi[3] = {4, 4, 4}, wide_lo[3] = {-1, -1, -1},
              wide_hi[3] = {4, 4, 4};
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++) {
        const double edge = 0.12 / ratios[i];
        const frame fine = {{edge, edge, edge}, 0.4 * (double)(i % 2), {0.5, 0.6, 0.7}};
        murk_resample_report report;
        murk_bricks source = make_box(&fine, lo, hi, noise);
        murk_bricks target = make_box(&own, wide_lo, wide_hi, constant);
        murk_bricks out =
            resample(*state, &source, &target, MURK_ABSENT_IS_BACKGROUND, false, &report);
        const double before = sum(&source, pow(edge, 3)), after = sum(&out, pow(0.12, 3));
        if (!(fabs(after / before - 1) < 0.01))
            fail_msg("ratio %g: %g became %g", ratios[i], before, after);
        murk_bricks_clear(&source);
        murk_bricks_clear(&target);
        murk_bricks_clear(&out);
    }
}

/* At the rim, a temperature is that of its active voxels; an emission fades; beyond, the background
   holds for both. NaN is as if it were not there. */
static void test_rim(void **state)
{
    const frame own = {{1, 1, 1}, 0, {0, 0, 0}}, shifted = {{1, 1, 1}, 0, {-0.25, 0, 0}};
    const int lo[3] = {0, 0, 0}, hi[3] = {2, 1, 1}, source_hi[3] = {1, 1, 1};
    for (int absence = 0; absence < 2; absence++) {
        murk_bricks source = make_box(&shifted, lo, source_hi, constant);
        murk_bricks target = make_box(&own, lo, hi, constant);
        source.background = 1;
        source.values[3 << 6] = NAN;
        murk_resample_report report;
        murk_bricks out = resample(*state, &source, &target, absence, false, &report);
        const bool unknown = absence == MURK_ABSENT_IS_UNKNOWN;
        /* Target x = 7 lies at 7.25 of the source, three quarters on its last voxel. */
        assert_float_equal(out.values[7 << 6], unknown ? 7 : 0.75 * 7 + 0.25 * 1, 1e-6);
        assert_float_equal(out.values[6 << 6], 7, 1e-6);
        assert_float_equal(out.values[3 << 6], unknown ? 7 : 0.75 * 1 + 0.25 * 7, 1e-6);
        assert_float_equal(out.values[MURK_BRICK_SLOTS], 1, 0);
        assert_true(out.background == 1);
        assert_int_equal(report.invalid, 1);
        assert_int_equal(report.covered, MURK_BRICK_SLOTS);
        assert_true(is_active(&out, 1, 5));
        murk_bricks_clear(&source);
        murk_bricks_clear(&target);
        murk_bricks_clear(&out);
    }
}

/* Halving leaves the rim to what is there, too: a lone hot voxel is as hot as before. */
static void test_rim_halved(void **state)
{
    const frame own = {{1, 1, 1}, 0, {0, 0, 0}}, fine = {{0.1, 0.1, 0.1}, 0, {0, 0, 0}};
    const int lo[3] = {0, 0, 0}, hi[3] = {1, 1, 1};
    for (int absence = 0; absence < 2; absence++) {
        murk_bricks source = make_box(&fine, lo, hi, constant);
        murk_bricks target = make_box(&own, lo, hi, constant);
        memset(source.mask, 0, sizeof *source.mask);
        source.mask[0][1] = 1 << 9; /* (1, 1, 1) alone */
        source.background = 2;
        murk_resample_report report;
        murk_bricks out = resample(*state, &source, &target, absence, false, &report);
        if (absence == MURK_ABSENT_IS_UNKNOWN)
            assert_float_equal(out.values[0], 7, 1e-6);
        else
            assert_true(out.values[0] > 2 && out.values[0] < 2.02);
        assert_float_equal(out.values[MURK_BRICK_SLOTS - 1], 2, 1e-6);
        murk_bricks_clear(&source);
        murk_bricks_clear(&target);
        murk_bricks_clear(&out);
    }
}

/* Places beyond all indices are nowhere. */
static void test_far(void **state)
{
    const frame own = {{1, 1, 1}, 0, {0, 0, 0}}, away = {{1e-9, 1e-9, 1e-9}, 0, {1e9, 0, 0}};
    const int lo[3] = {0, 0, 0}, hi[3] = {1, 1, 1};
    murk_bricks source = make_box(&away, lo, hi, constant);
    murk_bricks target = make_box(&own, lo, hi, constant);
    murk_resample_report report;
    murk_bricks out = resample(*state, &source, &target, MURK_ABSENT_IS_UNKNOWN, false, &report);
    assert_int_equal(report.covered, 0);
    assert_true(out.values[17] == 0);
    murk_bricks_clear(&source);
    murk_bricks_clear(&target);
    murk_bricks_clear(&out);
}

static int make_context(void **state)
{
    murk_context *context = NULL;
    murk_status status = murk_context_create(NULL, &context);
    *state = context;
    return status;
}

static int drop_context(void **state)
{
    murk_context_release(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_linear),     cmocka_unit_test(test_mean),
        cmocka_unit_test(test_mean_odd),   cmocka_unit_test(test_rim),
        cmocka_unit_test(test_rim_halved), cmocka_unit_test(test_far),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
