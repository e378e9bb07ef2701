/* SPDX-License-Identifier: Apache-2.0 */
#include "apparent.h"

#include "planck.h"

void murk_apparent_init(const murk_band *band, double low, double high, murk_apparent *out)
{
    out->low = log(low);
    out->step = fmax(log(high / low), 1e-9) / (MURK_APPARENT_NODES - 1);
    for (int n = 0; n < MURK_APPARENT_NODES; n++) {
        double slope, radiance = exp(out->low + n * out->step);
        double kelvin = murk_planck_temperature(band, radiance);
        radiance = murk_planck_slope(band, kelvin, &slope);
        out->inverse[n] = 1 / kelvin;
        out->slope[n] = -radiance / (slope * kelvin * kelvin) * out->step;
    }
}

double murk_apparent_temperature(const murk_apparent *apparent, double radiance)
{
    if (!(radiance > 0))
        return 0;
    double x = (log(radiance) - apparent->low) / apparent->step;
    int n = (int)fmin(fmax(x, 0), MURK_APPARENT_NODES - 2);
    double t = x - n, u = 1 - t;
    const double *y = apparent->inverse + n, *d = apparent->slope + n;
    return 1 / (u * u * ((1 + 2 * t) * y[0] + t * d[0]) + t * t * ((1 + 2 * u) * y[1] - u * d[1]));
}
