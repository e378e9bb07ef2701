/* SPDX-License-Identifier: Apache-2.0 */
/* What an iteration of the paper's method costs. */
#ifndef MURK_EXCHANGE_MULTIPLICATIONS_H
#define MURK_EXCHANGE_MULTIPLICATIONS_H

/* Multiplications of one iteration for n[] zones over n[0] * n[1] patches, [BG91] eq. (18). */
double murk_multiplications_full(const double n[3]);
/* The same with a window of m[] zones, [BG91] eq. (19). */
double murk_multiplications_window(const double n[3], const double m[3]);

#endif
