/* SPDX-License-Identifier: Apache-2.0 */
#ifndef MURK_SOLVE_RESIDUAL_H
#define MURK_SOLVE_RESIDUAL_H

#include "system.h"

/* Light from sky and from the ground beyond all patches, as in murk_radiosity. */
typedef struct murk_around {
    double sky, horizon;
} murk_around;

typedef struct murk_residual {
    murk_system *system;
    const murk_vector *direct; /* radiosities by beam and emission alone */
    const murk_around *around;
    const murk_vector *x; /* NULL for 0 */
    murk_vector *r;
    murk_vector *scratch; /* overwritten; NULL: diffuse is not asked for */
    double diffuse;       /* set to the power of sky and ground that the medium takes [W] */
} murk_residual;

/* r = b - L x, where b is `direct` plus what sky and horizon add to it, for up to MURK_MOST_BANDS
   systems over one operator, which is applied to all at once. */
murk_status murk_system_residual(murk_residual *of, int bands);

#endif
