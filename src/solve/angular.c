/* SPDX-License-Identifier: Apache-2.0 */
#include "angular.h"

#include <math.h>

/* The part of the tolerance that directions and sources within zones may use up together, and the
   least that is left to directions. */
static const double ANGULAR = 0.85, LEAST_ANGULAR = 0.3;

double murk_angular_goal(double tolerance, double spatial)
{
    return fmax(ANGULAR * tolerance - spatial, LEAST_ANGULAR * tolerance);
}

double murk_angular_scale(double change, int last, int now)
{
    return change / sqrt(1.0 / last + 1.0 / now);
}

int murk_angular_needed(double tolerance, double goal, double scale, int now)
{
    double needed = pow(scale / goal, 2);
    if (scale / sqrt(now) <= goal)
        needed = fmax(needed, tolerance < MURK_LOOSE ? now : 0.5 * now);
    else
        needed = fmin(fmin(2.0 * now, fmax(needed, 1.5 * now)), MURK_MOST_DIRECTIONS);
    return (int)ceil(needed / MURK_ORBIT) * MURK_ORBIT;
}
