/* SPDX-License-Identifier: Apache-2.0 */
#include "ticks.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* 1, 2 or 5 times a power of ten, not below x. */
static double round_up(double x)
{
    double power = pow(10, floor(log10(x)));
    const double digit = x / power;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

static double power_of_ten(int n)
{
    char text[16];
    double value = 0;
    snprintf(text, sizeof text, "1e%d", n); /* the nearest double, unlike pow() */
    sscanf(text, "%lf", &value);
    return value;
}

bool murk_axis_range(const murk_axis *axis, double low, double high, double range[2])
{
    if (axis->min != 0 || axis->max != 0) {
        range[0] = axis->min;
        range[1] = axis->max;
    } else if (axis->log) {
        double middle = high > low ? 0 : 0.5; /* one value stands in the middle of a decade */
        range[0] = pow(10, log10(low) - middle);
        range[1] = pow(10, log10(high) + middle);
        double margin = 0.05 * log10(range[1] / range[0]);
        range[0] *= pow(10, -margin);
        range[1] *= pow(10, margin);
    } else {
        double size = high > low ? high - low : fmax(1e-9, fabs(low));
        double step = round_up(size / 10);
        range[0] = step * floor(low / step);
        range[1] = step * ceil(high / step);
        if (high == low) {
            range[0] -= size;
            range[1] += size;
        }
    }
    return range[1] > range[0] && isfinite(range[1] - range[0]) && (!axis->log || range[0] > 0);
}

/* An axis of short numbers goes without exponents. */
static bool is_plain(const double range[2])
{
    return range[0] > 0.9e-4 && range[1] < 9e4;
}

static void name_power(int n, bool plain, char label[MURK_LABEL_SIZE])
{
    if (plain || n == 0 || n == 1)
        snprintf(label, MURK_LABEL_SIZE, "%g", power_of_ten(n));
    else
        snprintf(label, MURK_LABEL_SIZE, "10^%d", n);
}

static int log_ticks(const double range[2], int most, murk_tick *ticks)
{
    int first = (int)floor(log10(range[0])), last = (int)ceil(log10(range[1])), count = 0;
    double decades = log10(range[1] / range[0]);
    int stride = (int)fmax(1, ceil(decades / most));
    bool plain = is_plain(range), between = plain && decades < 2 && 3 * decades < most;
    for (int n = first; n <= last; n++)
        for (int digit = 1; digit < 10 && count < MURK_TICKS_MOST; digit++) {
            double value = digit * power_of_ten(n);
            if (value < range[0] * (1 - 1e-9) || value > range[1] * (1 + 1e-9) ||
                (stride > 1 && digit > 1))
                continue;
            murk_tick *tick = &ticks[count++];
            *tick = (murk_tick){.value = value};
            if (digit == 1 && n % stride == 0)
                name_power(n, plain, tick->label);
            else if (between && (digit == 2 || digit == 5))
                snprintf(tick->label, MURK_LABEL_SIZE, "%g", value);
        }
    return count;
}

static int linear_ticks(const double range[2], int most, murk_tick *ticks)
{
    double step = round_up((range[1] - range[0]) / most);
    double first = ceil(range[0] / step - 1e-9);
    int count = 0;
    for (double n = first; n * step <= range[1] + 1e-9 * step && count < MURK_TICKS_MOST; n++) {
        double value = n * step + 0.0; /* -0 is 0 */
        ticks[count] = (murk_tick){.value = value};
        snprintf(ticks[count++].label, MURK_LABEL_SIZE, "%.10g", value);
    }
    return count;
}

int murk_axis_ticks(bool log, const double range[2], int most, murk_tick ticks[MURK_TICKS_MOST])
{
    if (!log || range[1] < 4 * range[0]) /* too short for powers of ten */
        return linear_ticks(range, most, ticks);
    return log_ticks(range, most, ticks);
}

double murk_axis_place(bool log, const double range[2], double value)
{
    if (!isfinite(value) || (log && !(value > 0)))
        return NAN;
    return log ? log10(value / range[0]) / log10(range[1] / range[0])
               : (value - range[0]) / (range[1] - range[0]);
}
