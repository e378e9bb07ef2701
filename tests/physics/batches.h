/* SPDX-License-Identifier: Apache-2.0 */
/* Values against the means of independent batches of a Monte Carlo. */
#ifndef BATCHES_H
#define BATCHES_H

#include "check.h"

enum { BATCHES = 64, MOST = 1000, MOST_VALUES = 24 };

struct batches {
    double b[BATCHES][MOST], value[BATCHES][MOST_VALUES];
};

/* Within 4 standard errors and an allowance. */
static inline void check_value(const struct batches *mc, int which, double value, double allowance)
{
    double mean = 0, spread = 0;
    for (int n = 0; n < BATCHES; n++)
        mean += mc->value[n][which] / BATCHES;
    for (int n = 0; n < BATCHES; n++)
        spread += pow(mc->value[n][which] - mean, 2);
    double error = sqrt(spread / BATCHES / (BATCHES - 1));
    if (!(fabs(value - mean) <= 4 * error + allowance))
        fail_msg("value %d is %.6g; Monte Carlo says %.6g +- %.2g, allowance %.2g (off by %.3f %%)",
                 which, value, mean, error, allowance, 100 * (value / mean - 1));
}

/*
 * The squared L2 distance of b to the expectation of the batches, without their noise: the mean U
 * of <b - b_n, b - b_m> over n != m. With C the covariance of a batch and a the distance, its
 * variance is 4 a C a / N + 2 tr C^2 / (N (N - 1)) (Hoeffding 1948), where a C a <= |a|^2 (tr
 * C^2)^(1/2) and tr C^2 is the mean of <e_n, e_m>^2 over independent deviations.
 */
static inline void check_l2(const struct batches *mc, int zones, const double *weight,
                            const double *b, double allowance)
{
    double total[MOST] = {0}, squares = 0, trace = 0, norm2 = 0, sum2 = 0;
    for (int z = 0; z < zones; z++) {
        for (int n = 0; n < BATCHES; n++) {
            total[z] += b[z] - mc->b[n][z];
            squares += weight[z] * pow(b[z] - mc->b[n][z], 2);
        }
        sum2 += weight[z] * total[z] * total[z];
        norm2 += weight[z] * b[z] * b[z];
    }
    for (int n = 0; n < BATCHES; n += 2) {
        double product = 0;
        for (int z = 0; z < zones; z++)
            product += weight[z] * (b[z] - mc->b[n][z] - total[z] / BATCHES) *
                       (b[z] - mc->b[n + 1][z] - total[z] / BATCHES);
        trace += product * product / (BATCHES / 2);
    }
    double pairs = BATCHES * (BATCHES - 1), u = (sum2 - squares) / pairs;
    double most = allowance * allowance * norm2;
    double error = sqrt(4 * most * sqrt(trace) / BATCHES + 2 * trace / pairs);
    print_message("L2 error %.3f %% (+- %.3f %%), allowed %.3f %%\n",
                  100 * sqrt(fmax(0, u) / norm2), 100 * sqrt(error / norm2), 100 * allowance);
    if (!(u <= most + 4 * error))
        fail_msg("L2 error %.3f %%, above %.3f %%", 100 * sqrt(u / norm2),
                 100 * sqrt((most + 4 * error) / norm2));
}

#endif
