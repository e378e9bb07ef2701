/* SPDX-License-Identifier: Apache-2.0 */
#include "planck.h"

#include "context.h"

/* SI 2019: exact. */
static const double H = 6.62607015e-34, C = 299792458, K = 1.380649e-23;

/* x^3 / (e^x - 1) */
static double integrand(double x)
{
    return x > 0 ? x * x * x / expm1(x) : 0;
}

/* Its integral from x >= 1 to infinity: 1 / (e^x - 1) as a geometric series. */
static double from(double x)
{
    double sum = 0, base = exp(-x), power = base;
    for (int n = 1; n < 60 && power > 0; n++, power *= base) {
        double inverse = 1.0 / n;
        double term =
            power * inverse * (x * x * x + inverse * (3 * x * x + inverse * 6 * (x + inverse)));
        sum += term;
        if (term < 1e-17 * sum)
            break;
    }
    return sum;
}

/* And from 0 to x <= 1: 1 / (e^x - 1) by Bernoulli's numbers. */
static double up_to(double x)
{
    static const double bernoulli[] = {1 / 6.,       -1 / 30., 1 / 42.,      -1 / 30.,    5 / 66.,
                                       -691 / 2730., 7 / 6.,   -3617 / 510., 43867 / 798.};
    double sum = 1 / 3. - x / 8, factorial = 1, power = 1;
    for (int n = 1; n <= (int)(sizeof bernoulli / sizeof *bernoulli); n++) {
        factorial *= 2 * n * (2 * n - 1);
        power *= x * x;
        sum += bernoulli[n - 1] / factorial * power / (2 * n + 3);
    }
    return x * x * x * sum;
}

/* Over [low, high]. */
static double integral(double low, double high)
{
    static const double pi4 = M_PI * M_PI * M_PI * M_PI;
    if (low >= 1)
        return from(low) - from(high);
    if (high <= 1)
        return up_to(high) - up_to(low);
    return pi4 / 15 - up_to(low) - from(high);
}

double murk_planck_slope(const murk_band *band, double kelvin, double *slope)
{
    const double low = band->wavelength[0], high = band->wavelength[1];
    double x_low = H * C / (high * K * kelvin), x_high = H * C / (low * K * kelvin);
    if (low < high) {
        double scale = 2 * pow(K * kelvin, 4) / (H * H * H * C * C);
        double radiance = scale * integral(x_low, x_high);
        *slope = (4 * radiance + scale * (x_low * integrand(x_low) - x_high * integrand(x_high))) /
                 kelvin;
        return radiance;
    }
    double radiance = 1e-6 * 2 * H * C * C / pow(low, 5) / expm1(x_low);
    *slope = radiance * x_low / (-expm1(-x_low) * kelvin);
    return radiance;
}

double murk_planck_radiance(const murk_band *band, double kelvin)
{
    double slope;
    return kelvin > 0 && murk_band_valid(band) ? murk_planck_slope(band, kelvin, &slope) : 0;
}

/* Newton's steps on the logarithm over 1 / T, which is almost a straight line (Wien), and nowhere
   bends the other way. */
double murk_planck_temperature(const murk_band *band, double radiance)
{
    enum { STEPS = 100 };
    if (!(radiance > 0) || !murk_band_valid(band))
        return 0;
    double inverse = 1 / 300.0, slope;
    for (int n = 0; n < STEPS; n++) {
        double kelvin = 1 / inverse, found = murk_planck_slope(band, kelvin, &slope);
        double step = 0.5;
        if (found > 0)
            step = log(found / radiance) * found / (slope * kelvin);
        else
            step = -0.5; /* too cold for a number: warmer */
        step = fmin(fmax(step, -0.5), 1);
        inverse *= 1 + step;
        if (fabs(step) < 1e-12)
            break;
    }
    return 1 / inverse;
}
