/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A point has more than s to go where it stays inside when shifted by s: a share
 * g(s) = (1 - s/X)(1 - s/Y)(1 - s/Z) of all, X, Y, Z being the shifts by a whole edge. So the mean
 * is 1 - kappa times the integral of exp(-kappa s) g(s) up to the least of them.
 */
#include "box_escape.h"

#include <math.h>

/* The integrals of exp(-x u) u^n over [0, 1] for n = 0 ... 3. */
static void moments(double x, double out[4])
{
    if (x > 2) {
        double end = exp(-x);
        out[0] = (1 - end) / x;
        for (int n = 1; n < 4; n++)
            out[n] = (n * out[n - 1] - end) / x;
        return;
    }
    for (int n = 0; n < 4; n++)
        out[n] = 0;
    double term = 1;
    for (int i = 0; i < 14 && fabs(term) > 1e-9; term *= -x / ++i)
        for (int n = 0; n < 4; n++)
            out[n] += term / (i + n + 1);
}

double murk_box_escape(const double size[3], const double direction[3], double kappa)
{
    double most = 0, along[3], m[4];
    for (int a = 0; a < 3; a++) {
        along[a] = fabs(direction[a]) / size[a];
        most = fmax(most, along[a]);
    }
    double x = kappa / most, one = 0, two = 0, three = 1;
    for (int a = 0; a < 3; a++) {
        double share = along[a] / most;
        two += one * share;
        one += share;
        three *= share;
    }
    moments(x, m);
    return 1 - x * (m[0] - one * m[1] + two * m[2] - three * m[3]);
}

/* Of an opaque box one sees the faces: the solid angle of each is, to first order in size over
   distance, that of its middle, and the sum over `seen` faces that of the cross-section, nearer by
   (3 - seen)/4 of the mean chord. */
double murk_box_shift(const double size[3], const double direction[3], double kappa, double r)
{
    double inverse = 0; /* of the mean chord: volume over cross-section */
    int seen = 0;
    for (int a = 0; a < 3; a++) {
        inverse += fabs(direction[a]) / size[a];
        seen += fabs(direction[a]) * r > size[a] / 2;
    }
    double x = kappa / inverse, opaque = fabs(x) < 1e-2 ? x / 6 : 1 - 2 / x + 2 / expm1(x);
    return opaque * (3 - seen) / 4 / inverse;
}

double murk_box_mean(const double size[3], const double direction[3], double kappa)
{
    double mean = 1;
    for (int a = 0; a < 3; a++) {
        double x = kappa * size[a] * direction[a] / 2, square = x * x;
        mean *= square < 1 ? 1 + square / 6 * (1 + square / 20 * (1 + square / 42)) : sinh(x) / x;
    }
    return mean;
}
