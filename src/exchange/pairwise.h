/* SPDX-License-Identifier: Apache-2.0 */
/* The exchange operator of the paper: every factor of [BG91] eqs. (3)-(6), computed and stored. */
#ifndef MURK_EXCHANGE_PAIRWISE_H
#define MURK_EXCHANGE_PAIRWISE_H

#include "murk/exchange.h"

/*
 * Uniform media that fill a box keep factors by offset ([BG91] section 5), all others a full
 * matrix; init refuses more than 4 GiB of factors. options->window is the window of eq. (19): what
 * lies outside the M zones (patches) about a zone is dropped, zones cut by the window's face count
 * by their part inside, and rows no longer sum to 4 kappa V. A ground that cuts through the medium
 * counts as lying under it, and its factors are coarse.
 */
extern const murk_exchange_method murk_exchange_pairwise;

/* Bytes of the factors and of what they are used with. */
double murk_pairwise_memory(const murk_medium *medium, const murk_ground *ground);

#endif
