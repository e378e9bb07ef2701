/* SPDX-License-Identifier: Apache-2.0 */
/* The colours of false_color.h. */
#include "murk/false_color.h"

#include <math.h>

static const double DARKEST = 0.16, BRIGHTEST = 0.97;
static const murk_color GREY = {0.216f, 0.216f, 0.216f}; /* 0x808080; no value has it */

/* OKLab's a and b at equal steps of lightness: violet, magenta, red, orange, yellow. */
static const double POINTS[][2] = {
    {0.028, -0.053}, {0.096, -0.107}, {0.168, -0.030}, {0.168, 0.089},
    {0.087, 0.138},  {0.012, 0.137},  {-0.013, 0.046},
};
enum { INTERVALS = sizeof POINTS / sizeof *POINTS - 1 };

/* The Catmull-Rom spline through the points, one of a and b (axis 0, 1). */
static double spline(double part, int axis)
{
    double x = part * INTERVALS;
    int i = (int)fmin(floor(x), INTERVALS - 1);
    double u = x - i;
    double before = POINTS[i > 0 ? i - 1 : 0][axis], from = POINTS[i][axis];
    double to = POINTS[i + 1][axis], after = POINTS[i + 2 <= INTERVALS ? i + 2 : INTERVALS][axis];
    return 0.5 * (2 * from + (to - before) * u + (2 * before - 5 * from + 4 * to - after) * u * u +
                  (3 * from - before - 3 * to + after) * u * u * u);
}

static float within(double light)
{
    return (float)fmin(fmax(light, 0), 1);
}

/* [Ottosson 2020]: from OKLab to linear sRGB. */
static murk_color to_color(double lightness, double a, double b)
{
    double l = pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    double m = pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    double s = pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return (murk_color){within(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                        within(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                        within(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

murk_color murk_false_color_at(double part)
{
    if (isnan(part))
        return GREY;
    part = fmin(fmax(part, 0), 1);
    return to_color(DARKEST + part * (BRIGHTEST - DARKEST), spline(part, 0), spline(part, 1));
}
