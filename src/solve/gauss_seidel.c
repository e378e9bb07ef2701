/* SPDX-License-Identifier: Apache-2.0 */
#include "gauss_seidel.h"

#include <math.h>

/* [BG91] eq. (7) (corrected, see EQUATIONS.md): the patches from the newest zones. The ground is
   flat, so patches do not see one another. */
static double sweep_patches(const murk_exchange_method *method, void *state,
                            const murk_ground *ground, size_t zones, const double *source,
                            double *x)
{
    double change = 0;
    for (size_t i = 0; i < ground->patch_count; i++) {
        double self;
        double incident = method->row(state, zones + i, x, &self);
        double next = source[zones + i] + ground->reflectance[i] * incident;
        change = fmax(change, fabs(next - x[zones + i]));
        x[zones + i] = next;
    }
    return change;
}

/* [BG91] eq. (8) (corrected, see EQUATIONS.md): the zones in order, each from the newest values of
   all others. The light of a zone on itself is on the left side. */
static double sweep_zones(const murk_exchange_method *method, void *state,
                          const murk_medium *medium, const double *source, double *x)
{
    const murk_grid *grid = medium->grid;
    double change = 0;
    size_t k = 0;
    for (size_t b = 0; b < grid->brick_count; b++)
        for (int slot = 0; slot < MURK_BRICK_SLOTS; slot++) {
            if (!murk_grid_active(grid, b, slot))
                continue;
            double albedo = murk_value(&medium->albedo, b * MURK_BRICK_SLOTS + (size_t)slot), self;
            double incident = method->row(state, k, x, &self);
            double next = (source[k] + albedo * incident) / (1 - albedo * self);
            change = fmax(change, fabs(next - x[k]));
            x[k++] = next;
        }
    return change;
}

murk_status murk_gauss_seidel(murk_context *context, const murk_exchange_method *method,
                              void *state, const murk_medium *medium, const murk_ground *ground,
                              const double *source, double epsilon, int max_iterations, double *x,
                              int *iterations, double *change)
{
    if (!method->row)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "solver: Gauss-Seidel needs single rows, which the method %s does not "
                         "have; use the method pairwise or conjugate gradients",
                         method->name);
    size_t zones = medium->grid->zone_count;
    double first = 0, largest = INFINITY;
    int count = 0;
    while (count < max_iterations && largest >= epsilon) {
        largest = ground ? sweep_patches(method, state, ground, zones, source, x) : 0;
        largest = fmax(largest, sweep_zones(method, state, medium, source, x));
        if (++count == 1)
            first = largest;
        double range = log(epsilon / first);
        murk_progress(context, "solve",
                      range < 0 && largest > 0 ? fmin(1, fmax(0, log(largest / first) / range))
                                               : 1);
    }
    *iterations = count;
    *change = largest;
    return MURK_OK;
}
