/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file exchange.h
 * The exchange operator: what a method of computing the exchange between zones and patches has to
 * provide, for authors of a method. Users of murk need murk.h alone.
 *
 * In the terms of [BG91] eqs. (1), (2), with B the radiosities of zones and patches:
 *
 *     zone k:   G_k / 4 = (1 / (4 kappa_k V)) [ sum_j Bs_j S_jV_k + sum_m Bv_m V_mV_k + sky ]
 *     patch i:  H_i     = (1 / A_i)           [ sum_k Bv_k V_kS_i + sky ]
 *
 * The sums hold the self-factor V_kV_k. The ground is flat: S_jS_i = 0. An operator delivers for
 * zones the *net* incident radiosity G/4 - B, because that stays exact where emission and
 * incidence almost cancel (thick media, albedo near 1), and for patches H.
 *
 * With weights w = 4 kappa V for zones and A for patches the operator is symmetric (reciprocity):
 * <u, G v>_w = <G u, v>_w for sky = horizon = 0.
 */
#ifndef MURK_EXCHANGE_H
#define MURK_EXCHANGE_H

#include "murk/murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Radiosities that act [W/m^2]. zone: one value a slot of the medium's grid (512 a brick, slots
 *  that are no zones hold 0); patch: one value a patch; NULL stands for all 0. */
typedef struct murk_radiosity {
    const float *zone;
    const float *patch;
    double sky;     /**< pi * radiance of the sky */
    double horizon; /**< radiosity of the ground beyond all patches */
    /** Change of B across the zones along the grid's axes, where a method has been told which zones
     *  have one; NULL: B is constant in each zone. */
    const float *slope;
} murk_radiosity;

/** Bands that an operator takes at once. */
enum { MURK_MOST_BANDS = 3 };

/** What arrives [W/m^2]; both arrays are overwritten. */
typedef struct murk_incident {
    float *zone;  /**< G/4 - B of each zone; undefined in slots that are no zones */
    float *patch; /**< H of each patch */
    float *slope; /**< like the zones', of slopes as in murk_radiosity; NULL: not asked for */
    /** Power [W] that enters the medium from the sky and the ground minus what leaves it. */
    double net_power;
} murk_incident;

/** A method: how the operator of one scene is made, applied and released. */
typedef struct murk_exchange_method {
    const char *name;

    /** Prepares the operator for a medium and a ground (may be NULL); both outlive it. */
    murk_status (*init)(murk_context *context, const murk_medium *medium, const murk_ground *ground,
                        const murk_solve_options *options, void **state);

    /** out = G in, for all zones and patches at once, and for 1 ... MURK_MOST_BANDS bands: kinds of
     *  light that share kappa_t, each with its own `in` and `out`. */
    murk_status (*apply)(murk_context *context, void *state, const murk_radiosity *in,
                         murk_incident *out, int bands);

    /**
     * Optional (NULL: the method cannot): one row for Gauss-Seidel. Element e < zones is the zone
     * with that number, e - zones a patch; x holds the radiosities of all elements. Returns
     * sum_j x_j F_je / w_e over all j, with the self-factor left out and given in *self as
     * F_ee / w_e; sky and horizon not included.
     */
    double (*row)(void *state, size_t element, const double *x, double *self);

    void (*release)(void *state);
} murk_exchange_method;

#ifdef __cplusplus
}
#endif
#endif
