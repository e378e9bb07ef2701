/* SPDX-License-Identifier: Apache-2.0 */
/* Directions: moments over the sphere and the symmetry of the cube. */
#include "check.h"
#include "quadrature.h"

static const int SIZES[] = {1, 2, 3, 4, 7, 8, 16, 32, 64, 100};

enum { SIZE_COUNT = sizeof SIZES / sizeof *SIZES };

/* Mean of |x|^p |y|^q |z|^r over the quadrature. */
static double moment(const murk_quadrature *quadrature, int p, int q, int r)
{
    double sum = 0;
    for (int i = 0; i < quadrature->count; i++) {
        const double *d = quadrature->direction[i];
        sum += quadrature->weight[i] * pow(fabs(d[0]), p) * pow(fabs(d[1]), q) * pow(fabs(d[2]), r);
    }
    return sum;
}

static void moments(void **state)
{
    for (int n = 0; n < SIZE_COUNT; n++) {
        murk_quadrature q;
        assert_int_equal(murk_quadrature_create(*state, SIZES[n], n % 2, &q), MURK_OK);
        assert_int_equal(q.count, 48 * SIZES[n]);
        double sum = 0;
        for (int i = 0; i < q.count; i++) {
            const double *d = q.direction[i];
            assert_within(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-14);
            assert_true(q.weight[i] > 0);
            sum += q.weight[i];
        }
        assert_within(sum, 1, 1e-12);
        for (int a = 0; a < 3; a++) {
            const int one[3] = {a == 0, a == 1, a == 2};
            /* <|x|> = 1/2, <x^2> = 1/3, <x^4> = 1/5; two or three points cannot carry degree 4 with
               weights that are all positive, and one can by its place alone. */
            assert_within(moment(&q, one[0], one[1], one[2]), 1. / 2, 1e-12);
            assert_within(moment(&q, 2 * one[0], 2 * one[1], 2 * one[2]), 1. / 3, 1e-12);
            if (SIZES[n] == 1 || SIZES[n] >= 4)
                assert_within(moment(&q, 4 * one[0], 4 * one[1], 4 * one[2]), 1. / 5, 1e-12);
        }
        /* <x^2 y^2 z^2> = 1/105 and <x^8> = 1/9. */
        if (SIZES[n] >= 8) {
            assert_within(moment(&q, 2, 2, 2), 1. / 105, 1e-12);
            assert_within(moment(&q, 8, 0, 0), 1. / 9, 1e-12);
        }
        murk_quadrature_clear(&q);
        assert_null(q.direction);
    }
}

static double distance(const double a[3], const double b[3])
{
    return fabs(a[0] - b[0]) + fabs(a[1] - b[1]) + fabs(a[2] - b[2]);
}

/* Every image of every direction under the 48 operations is there, once, with the same weight. */
static void symmetry(void **state)
{
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int n = 0; n < 6; n++) {
        murk_quadrature q;
        assert_int_equal(murk_quadrature_create(*state, SIZES[n], n % 2, &q), MURK_OK);
        for (int i = 0; i < q.count; i++)
            for (int op = 0; op < 48; op++) {
                double image[3];
                int found = 0;
                for (int a = 0; a < 3; a++)
                    image[a] = (op >> a & 1 ? -1 : 1) * q.direction[i][order[op / 8][a]];
                for (int j = 0; j < q.count; j++)
                    if (distance(image, q.direction[j]) < 1e-12) {
                        assert_within(q.weight[j], q.weight[i], 0);
                        found++;
                    }
                assert_int_equal(found, 1);
            }
        murk_quadrature_clear(&q);
    }
}

/* A cap of 1/20 of the sphere about (1, 2, 3), which no weight was fitted to: not further off than
   three standard deviations of as many independent directions. */
static void caps(void **state)
{
    for (int n = 0; n < SIZE_COUNT; n++) {
        murk_quadrature q;
        double sum = 0;
        assert_int_equal(murk_quadrature_create(*state, SIZES[n], n % 2, &q), MURK_OK);
        for (int i = 0; i < q.count; i++) {
            const double *d = q.direction[i];
            sum += (d[0] + 2 * d[1] + 3 * d[2]) / sqrt(14) > 0.9 ? q.weight[i] : 0;
        }
        assert_within(sum, 0.05, 3 * sqrt(0.05 * 0.95 / q.count));
        murk_quadrature_clear(&q);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moments),
        cmocka_unit_test(symmetry),
        cmocka_unit_test(caps),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
