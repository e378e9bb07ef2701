/* SPDX-License-Identifier: Apache-2.0 */
/* What an iteration of the paper's method costs. */
#ifndef MURK_EXCHANGE_MULTIPLICATIONS_H
#define MURK_EXCHANGE_MULTIPLICATIONS_H

/* Multiplications of one iteration, [BG91] eq. (18): zones^2 + 2 patches zones, which for
   Nx Ny Nz zones over Nx Ny patches is the paper's. */
double murk_multiplications_full(double zones, double patches);
/* The same with a window of m[0] x m[1] x m[2] zones, [BG91] eq. (19). */
double murk_multiplications_window(double zones, double patches, const int m[3]);

#endif
