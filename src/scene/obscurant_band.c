/* SPDX-License-Identifier: Apache-2.0 */
/* Means over a band of an obscurant's values. */
#include "obscurant.h"

#include <math.h>
#include <stdio.h>

/* Extinction k, scattering k a and k a g: what the means are made of. */
struct sums {
    double k, ka, kag;
};

static double between(double a, double b, double t)
{
    return a + t * (b - a);
}

/* The values at a wavelength within those of the file. */
static struct scene_optics at(const struct scene_obscurant *obscurant, double wavelength)
{
    size_t i = 0;
    while (i + 2 < obscurant->count && wavelength > obscurant->wavelength[i + 1])
        i++;
    if (obscurant->count == 1)
        return obscurant->optics[0];
    const double *w = &obscurant->wavelength[i];
    const struct scene_optics *o = &obscurant->optics[i];
    double t = (wavelength - w[0]) / (w[1] - w[0]);
    return (struct scene_optics){.mass_extinction =
                                     between(o[0].mass_extinction, o[1].mass_extinction, t),
                                 .albedo = between(o[0].albedo, o[1].albedo, t),
                                 .asymmetry = between(o[0].asymmetry, o[1].asymmetry, t)};
}

/* Adds the values at a wavelength with a weight. */
static void add(struct sums *sums, const struct scene_obscurant *obscurant, double wavelength,
                double weight)
{
    struct scene_optics o = at(obscurant, wavelength);
    double k = weight * o.mass_extinction;
    sums->k += k;
    sums->ka += k * o.albedo;
    sums->kag += k * o.albedo * o.asymmetry;
}

/* The trapezoidal rule, with weights that add up to 1. */
static struct sums integrate(const struct scene_obscurant *obscurant, double low, double high)
{
    struct sums sums = {0};
    double before = low;
    if (low == high || obscurant->count == 1) {
        add(&sums, obscurant, low, 1);
        return sums;
    }
    for (size_t i = 0; before < high; i++) {
        double next = i < obscurant->count ? fmin(high, obscurant->wavelength[i]) : high;
        double weight = 0.5 * (next - before) / (high - low);
        if (!(next > before))
            continue;
        add(&sums, obscurant, before, weight);
        add(&sums, obscurant, next, weight);
        before = next;
    }
    return sums;
}

static murk_status outside(const struct scene_obscurant *obscurant, const double wavelength[2],
                           char *message)
{
    const double first = obscurant->wavelength[0];
    const double last = obscurant->wavelength[obscurant->count - 1];
    char range[64];
    if (obscurant->count == 1)
        snprintf(range, sizeof range, "has %g m alone", first);
    else
        snprintf(range, sizeof range, "covers %g to %g m", first, last);
    snprintf(message, SCENE_MESSAGE_SIZE,
             "%s: wavelength: %s, which the band from %g to %g m %s; add values for it, or give "
             "the band its own \"mass_extinction\" and \"albedo\"",
             obscurant->path, range, wavelength[0], wavelength[1],
             obscurant->count == 1 ? "does not hold" : "reaches beyond");
    return MURK_ERROR_INPUT;
}

murk_status scene_obscurant_band(const struct scene_obscurant *obscurant,
                                 const double wavelength[2], struct scene_optics *out,
                                 char message[SCENE_MESSAGE_SIZE])
{
    const double low = wavelength[0], high = wavelength[1];
    const double first = obscurant->wavelength[0];
    const double last = obscurant->wavelength[obscurant->count - 1];
    /* One value stands for all of a band that holds it, several for what lies between them. */
    bool covered =
        obscurant->count == 1 ? low <= first && first <= high : first <= low && high <= last;
    if (!covered)
        return outside(obscurant, wavelength, message);
    struct sums sums = integrate(obscurant, low, high);
    *out = (struct scene_optics){.mass_extinction = sums.k,
                                 .albedo = sums.k > 0 ? fmin(1, sums.ka / sums.k) : 0,
                                 .asymmetry = sums.ka > 0 ? sums.kag / sums.ka : 0};
    return MURK_OK;
}
