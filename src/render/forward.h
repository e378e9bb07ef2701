/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The path radiance of media that scatter forward. It is that of the reduced medium (similarity.h),
 * of which t' is the optical depth from the camera, plus what isotropic scattering leaves out:
 *
 *   pi L = int e^-t' B' dt' + (e^-t' - e^-t) pi L_b + pi L_F
 *
 * The second term is light that comes from behind, L_b on average, and is scattered only forward:
 * surfaces themselves are seen through e^-t. The third is the sun's light that has been scattered
 * by n = 1, 2, ... small angles, straight but for these. Since n phase functions of Henyey and
 * Greenstein one after another are one of g^n, and n scatterings at the scattering depth s on the
 * way (sun's and camera's legs together) have the probability e^-s s^n / n!,
 *
 *   L_F = int F e^-T V(s) kappa_s dx,  V(s) = sum s^(n-1)/n! (p_(g^n) - (1 - g^n) / 4 pi),
 *
 * T being the optical depth on the way. The reduced medium isotropically scatters the part 1 - g^n
 * of that already. n = 1 is the correction of Nakajima and Tanaka (1988). V is fitted by a sum of
 * a_j e^(x_j s): each term is sunlight scattered once in the medium in which the part x_j of the
 * scattered light counts as not scattered, which the camera sees as it sees any source.
 */
#ifndef MURK_RENDER_FORWARD_H
#define MURK_RENDER_FORWARD_H

#include "blur.h"
#include "march.h"

enum { MURK_FORWARD_TERMS = 3 };

typedef struct murk_forward {
    murk_solution reduced; /* no medium: scattering is isotropic, and nothing else is set */
    murk_march march;      /* of B' */
    murk_blur ground;      /* for L_b */
    double asymmetry;

    /* Sunlight scattered once, and where; no weights: no sun. */
    double (*weight)[MURK_FORWARD_TERMS]; /* a_j by the angle, see forward.c */
    murk_medium *medium[MURK_FORWARD_TERMS];
    murk_march sun[MURK_FORWARD_TERMS];
    double travel[3];
} murk_forward;

/* The tangent of the angle within which half of the light is scattered that counts as not scattered
   in the reduced medium; turned: the optical depth of that, t - t'. */
double murk_forward_spread(const murk_forward *forward, double turned);

/* What a packet meets in those media. */
typedef struct murk_forwarded {
    double path[MURK_LANES], depth[MURK_LANES]; /* of the reduced medium */
    double sun[MURK_FORWARD_TERMS][MURK_LANES]; /* but for the first, the packet's own path */
} murk_forwarded;

/* For a medium whose asymmetry is not 0. */
murk_status murk_forward_create(murk_context *context, const murk_solution *solution,
                                murk_forward *out);
void murk_forward_clear(murk_forward *forward);

static inline bool murk_forward_needed(const murk_forward *forward)
{
    return forward->reduced.medium;
}

/* The march of the packet itself, where x_1 = 0: through the medium as it is, `march` without a
 * sun.
 */
static inline const murk_march *murk_forward_itself(const murk_forward *forward,
                                                    const murk_march *march)
{
    return forward->weight ? &forward->sun[0] : march;
}

/* Carries a packet through the bricks; false when memory runs out. What the reduced medium, then
   the second and third sun's term give on the way goes to trace[0], trace[stride] and so on. */
bool murk_forward_march(const murk_forward *forward, const int32_t *brick, size_t count,
                        const murk_packet *packet, murk_trace *trace, size_t stride,
                        murk_forwarded *out);

/* Sets the path of a packet that went through the medium itself (murk_forward_itself()) along
   `direction`, unit vectors in the world; behind: pi L_b. */
void murk_forward_light(const murk_forward *forward, const murk_forwarded *passed,
                        const double direction[3][MURK_LANES], const double behind[MURK_LANES],
                        murk_packet *packet);

#endif
