/* SPDX-License-Identifier: Apache-2.0 */
#include "zonewise.h"

#include <math.h>
#include <string.h>

/* Eight bins an octave: the exponent of a float and three bits of its fraction. */
enum { SHIFT = 20, BINS = 1 << (31 - SHIFT) };

double murk_zonewise_change(const murk_medium *medium, const float *change, const float *value)
{
    size_t bin[BINS] = {0}, zones = 0;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++) {
        if (!(medium->kappa_t[i] > 0) || !(value[i] > 0))
            continue;
        float ratio = fabsf(change[i] / value[i]);
        uint32_t bits;
        memcpy(&bits, &ratio, sizeof bits);
        bin[bits >> SHIFT]++;
        zones++;
    }
    size_t above = zones / 20, n = BINS - 1;
    for (; n > 0 && bin[n] <= above; n--)
        above -= bin[n];
    uint32_t bits = (uint32_t)n << SHIFT;
    float ratio;
    memcpy(&ratio, &bits, sizeof ratio);
    return zones ? ratio : 0;
}
