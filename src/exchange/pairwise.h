/* SPDX-License-Identifier: Apache-2.0 */
/* The exchange operator of the paper: every factor of [BG91] eqs. (3)-(6), computed and stored. */
#ifndef MURK_EXCHANGE_PAIRWISE_H
#define MURK_EXCHANGE_PAIRWISE_H

#include "murk/exchange.h"

/*
 * Uniform media that fill a box keep factors by offset ([BG91] section 5), all others a full
 * matrix; init refuses more than 4 GiB of factors. options->window is the window of eq. (19): what
 * lies outside the M zones (patches) about a zone is dropped, zones cut by the window's face count
 * by their part inside, and rows no longer sum to 4 kappa V.
 */
extern const murk_exchange_method murk_exchange_pairwise;

/* Multiplications of one iteration, [BG91] eqs. (18) and (19): zones n[], window m[]. */
double murk_multiplications_full(const double n[3]);
double murk_multiplications_window(const double n[3], const double m[3]);

#endif
