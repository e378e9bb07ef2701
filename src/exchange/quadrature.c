/* SPDX-License-Identifier: Apache-2.0 */
#include "quadrature.h"

#include <math.h>
#include <string.h>

enum { MOMENTS = 8 };

/* The functions that weights are fitted to: 1, the flux, and products of the two invariants
   x^4 + y^4 + z^4 and x^2 y^2 z^2 in ascending degree; with their means over the sphere,
   <x^2a y^2b z^2c> = (2a-1)!! (2b-1)!! (2c-1)!! / (2(a+b+c)+1)!!. */
static void moments(const double p[3], double out[MOMENTS])
{
    double x = p[0] * p[0], y = p[1] * p[1], z = p[2] * p[2];
    double i4 = x * x + y * y + z * z, i6 = x * y * z;
    out[0] = 1;
    out[1] = p[0] + p[1] + p[2];
    out[2] = i4;
    out[3] = i6;
    out[4] = i4 * i4;
    out[5] = i4 * i6;
    out[6] = i6 * i6;
    out[7] = i4 * i4 * i4;
}

static const double MEANS[MOMENTS] = {1,
                                      1.5,
                                      3.0 / 5,
                                      1.0 / 105,
                                      (3 * 105.0 + 6 * 9) / 945,
                                      3 * 15.0 / 10395,
                                      27.0 / 135135,
                                      (3 * 10395.0 + 18 * 315 + 6 * 27) / 135135};

/* The part of v at right angles to the unit vector w, normalised. */
static void reject(const double v[3], const double w[3], double out[3])
{
    double d = v[0] * w[0] + v[1] * w[1] + v[2] * w[2], length = 0;
    for (int c = 0; c < 3; c++) {
        out[c] = v[c] - d * w[c];
        length += out[c] * out[c];
    }
    for (int c = 0; c < 3; c++)
        out[c] /= sqrt(length);
}

/* Area-preserving map of the unit square to the triangle x >= y >= z >= 0 of the sphere:
   J. Arvo, "Stratified sampling of spherical triangles", SIGGRAPH 1995. */
static void map_triangle(double u, double v, double out[3])
{
    const double a[3] = {1, 0, 0}, b[3] = {M_SQRT1_2, M_SQRT1_2, 0};
    const double c[3] = {1 / sqrt(3), 1 / sqrt(3), 1 / sqrt(3)};
    const double alpha = M_PI / 4, area = M_PI / 12, cos_c = M_SQRT1_2;
    double s = sin(u * area - alpha), t = cos(u * area - alpha);
    double p = t - cos(alpha), q = s + sin(alpha) * cos_c;
    double k = ((q * t - p * s) * cos(alpha) - q) / ((q * s + p * t) * sin(alpha));
    double away[3], corner[3];
    k = fmin(1, fmax(-1, k));
    reject(c, a, away);
    for (int i = 0; i < 3; i++)
        corner[i] = k * a[i] + sqrt(1 - k * k) * away[i];
    double z = 1 - v * (1 - (corner[0] * b[0] + corner[1] * b[1] + corner[2] * b[2]));
    reject(corner, b, away);
    for (int i = 0; i < 3; i++)
        out[i] = z * b[i] + sqrt(1 - z * z) * away[i];
}

/* Solves the small symmetric system in place by elimination; false where it is singular. */
static bool eliminate(int n, double matrix[MOMENTS][MOMENTS], double x[MOMENTS])
{
    for (int i = 0; i < n; i++) {
        if (fabs(matrix[i][i]) < 1e-14)
            return false;
        for (int r = i + 1; r < n; r++) {
            double f = matrix[r][i] / matrix[i][i];
            for (int c = i; c < n; c++)
                matrix[r][c] -= f * matrix[i][c];
            x[r] -= f * x[i];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int c = i + 1; c < n; c++)
            x[i] -= matrix[i][c] * x[c];
        x[i] /= matrix[i][i];
    }
    return true;
}

/* The weights nearest to 1/n that fulfil the first `fitted` moments; false if one leaves
   [1/4, 4] / n. */
static bool fit_weights(int n, const double (*base)[3], int fitted, double *weight)
{
    double gram[MOMENTS][MOMENTS] = {{0}}, defect[MOMENTS], m[MOMENTS];
    memcpy(defect, MEANS, sizeof defect);
    for (int i = 0; i < n; i++) {
        moments(base[i], m);
        for (int r = 0; r < fitted; r++) {
            defect[r] -= m[r] / n;
            for (int c = 0; c < fitted; c++)
                gram[r][c] += m[r] * m[c];
        }
    }
    if (!eliminate(fitted, gram, defect))
        return false;
    for (int i = 0; i < n; i++) {
        moments(base[i], m);
        weight[i] = 1.0 / n;
        for (int r = 0; r < fitted; r++)
            weight[i] += m[r] * defect[r];
        if (!(weight[i] * n > 0.25 && weight[i] * n < 4))
            return false;
    }
    return true;
}

/* The images of base point p with its shift s. An image by a rotation takes s along; the others are
   rotations of -p, whose lines are those of p. */
static void place_orbit(const double p[3], const double s[3], double weight,
                        murk_quadrature *quadrature, int first)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int i = 0; i < MURK_ORBIT; i++) {
        bool turned = (__builtin_popcount((unsigned)i & 7) + (i >= 24)) % 2 == 0;
        for (int c = 0; c < 3; c++) {
            int sign = i >> c & 1 ? -1 : 1;
            quadrature->direction[first + i][c] = sign * p[order[i >> 3][c]];
            quadrature->shift[first + i][c] = (turned ? sign : -sign) * s[order[i >> 3][c]];
        }
        quadrature->weight[first + i] = weight / MURK_ORBIT;
    }
}

static double fraction(double x)
{
    return x - floor(x);
}

/* Strides of Kronecker sequences: the golden ratio in one dimension, and powers of the root of
   x^4 = x + 1 in three. */
static const double GOLDEN = 0.6180339887498949;
static const double STRIDE[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

murk_status murk_quadrature_create(murk_context *context, int orbits, int set, murk_quadrature *out)
{
    size_t n = (size_t)orbits;
    murk_quadrature made = {.count = orbits * MURK_ORBIT,
                            .direction = murk_alloc(n * MURK_ORBIT, sizeof *made.direction),
                            .weight = murk_alloc(n * MURK_ORBIT, sizeof *made.weight),
                            .shift = murk_alloc(n * MURK_ORBIT, sizeof *made.shift)};
    double(*base)[3] = murk_alloc(n, sizeof *base), *weight = murk_alloc(n, sizeof *weight);
    if (!made.direction || !made.weight || !made.shift || !base || !weight) {
        murk_quadrature_clear(&made);
        murk_free(base);
        murk_free(weight);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d directions", made.count);
    }
    for (int i = 0; i < orbits; i++) {
        map_triangle((i + 0.5) / orbits, fraction((i + 0.5) * GOLDEN), base[i]);
        weight[i] = 1.0 / orbits;
    }
    if (orbits == 1) {
        /* The one point that integrates both |x| and degree 4: with e1 = 3/2, e2 = 5/8,
           e3 = 61/960, its coordinates are the roots of t^3 - e1 t^2 + e2 t - e3. */
        const double angle = acos(sqrt(3.0 / 800)) / 3;
        for (int c = 0; c < 3; c++)
            base[0][c] = 0.5 + sqrt(1.0 / 6) * cos(angle - 2 * M_PI * c / 3);
        double lowest = base[0][1], middle = base[0][2];
        base[0][1] = fmax(lowest, middle);
        base[0][2] = fmin(lowest, middle);
    } else {
        int fitted = orbits < MOMENTS ? orbits : MOMENTS;
        while (fitted > 1 && !fit_weights(orbits, (const double(*)[3])base, fitted, weight))
            fitted--;
    }
    for (int i = 0; i < orbits; i++) {
        double shift[3];
        for (int c = 0; c < 3; c++)
            shift[c] = orbits > 1 ? fraction((i + set * orbits + 0.5) * STRIDE[c]) - 0.5
                                  : set * sqrt(1.0 / 12);
        place_orbit(base[i], shift, weight[i], &made, i * MURK_ORBIT);
    }
    murk_free(base);
    murk_free(weight);
    *out = made;
    return MURK_OK;
}

void murk_quadrature_clear(murk_quadrature *quadrature)
{
    murk_free(quadrature->direction);
    murk_free(quadrature->weight);
    murk_free(quadrature->shift);
    memset(quadrature, 0, sizeof *quadrature);
}
