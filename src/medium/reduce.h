/* SPDX-License-Identifier: Apache-2.0 */
/* Media that scatter less in place of those that scatter forward. */
#ifndef MURK_MEDIUM_REDUCE_H
#define MURK_MEDIUM_REDUCE_H

#include "medium.h"

/*
 * Makes the medium in which `part` < 1 of the scattered light counts as not scattered,
 *   kappa_s' = kappa_s (1 - part), kappa_a' = kappa_a, that is
 *   kappa_t' = kappa_t (1 - albedo part), albedo' = albedo (1 - part) / (1 - albedo part),
 * and the rest is scattered isotropically. Light that was scattered many times behaves there as in
 * the medium itself where the part is g (similarity, van de Hulst 1980). Grids and emission are
 * those of `medium`, which the new one shares.
 */
murk_status murk_medium_reduce(murk_context *context, const murk_medium *medium, double part,
                               murk_medium **out);

#endif
