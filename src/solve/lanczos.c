/* SPDX-License-Identifier: Apache-2.0 */
#include "lanczos.h"

#include <math.h>
#include <string.h>

murk_status murk_lanczos_create(murk_context *context, int most, murk_lanczos *out)
{
    murk_lanczos made = {.diagonal = murk_alloc((size_t)most, sizeof(double)),
                         .off = murk_alloc((size_t)most, sizeof(double))};
    if (!made.diagonal || !made.off) {
        murk_lanczos_clear(&made);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %d iterations", most);
    }
    *out = made;
    return MURK_OK;
}

void murk_lanczos_clear(murk_lanczos *lanczos)
{
    murk_free(lanczos->diagonal);
    murk_free(lanczos->off);
    memset(lanczos, 0, sizeof *lanczos);
}

void murk_lanczos_add(murk_lanczos *lanczos, double a, double b)
{
    int i = lanczos->count++;
    lanczos->diagonal[i] = 1 / a + (i ? lanczos->last_b / lanczos->last_a : 0);
    lanczos->off[i] = sqrt(b) / a;
    lanczos->last_a = a;
    lanczos->last_b = b;
}

/* How many eigenvalues lie below x: the negative pivots of T - x (Sturm sequence). */
static int count_below(const murk_lanczos *t, double x)
{
    int below = 0;
    double pivot = 1;
    for (int i = 0; i < t->count; i++) {
        double square = i ? t->off[i - 1] * t->off[i - 1] : 0;
        pivot = t->diagonal[i] - x - square / pivot;
        if (pivot == 0)
            pivot = 1e-300;
        below += pivot < 0;
    }
    return below;
}

double murk_lanczos_least(const murk_lanczos *lanczos, double most)
{
    double low = 1e-12, high = most;
    while (high > 1.01 * low) {
        double middle = sqrt(low * high);
        if (count_below(lanczos, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}
