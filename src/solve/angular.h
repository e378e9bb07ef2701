/* SPDX-License-Identifier: Apache-2.0 */
/* How many directions a tolerance needs. */
#ifndef MURK_SOLVE_ANGULAR_H
#define MURK_SOLVE_ANGULAR_H

#include "quadrature.h"

enum { MURK_MOST_DIRECTIONS = 64 * MURK_ORBIT };

/* Tolerances from here on begin with fewer directions. */
#define MURK_LOOSE 0.03

/* The relative error that directions may leave, where sources within zones leave `spatial`. */
double murk_angular_goal(double tolerance, double spatial);

/* The error of N directions is scale / sqrt(N), and independent quadratures of n and N differ by
   scale sqrt(1/n + 1/N): the scale from the change from `last` directions to `now`. */
double murk_angular_scale(double change, int last, int now);

/* How many directions the goal needs, by what `now` of them told: where the light is smooth the
   error falls faster than the root, so no leaps, and fewer only where the tolerance is loose. */
int murk_angular_needed(double tolerance, double goal, double scale, int now);

#endif
