/* SPDX-License-Identifier: Apache-2.0 */
/*
 * [BG91] eqs. (5), (6) by lines between points of the two zones. Along a line the integral over the
 * two chords is elementary, (1 - e^(-kappa_m l_m)) tau (1 - e^(-kappa_k l_k)), so each line stands
 * for the mean over its chords and thick zones need no finer points than thin ones.
 */
#include "factor_far.h"

#include <math.h>

double murk_far_geometry(const double size[3], const double offset[3])
{
    double volume = size[0] * size[1] * size[2];
    double r2 = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    double second = 0; /* (size^2 / 12) d^2(1/r^2) / (1/r^2): the spread of both boxes */
    for (int a = 0; a < 3; a++)
        second += size[a] * size[a] / 12 * (8 * offset[a] * offset[a] / r2 - 2) / r2;
    return volume * volume / (M_PI * r2) * (1 + second);
}

/* Attenuation along the line through p in zone m and q in zone k; *r2 is their distance squared. */
static double attenuation(const murk_sight *sight, const double (*box)[3], const double p[3],
                          const double q[3], double kappa_m, double kappa_k, double *r2)
{
    double d[3], t_m[2], t_k[2];
    *r2 = 0;
    for (int a = 0; a < 3; a++)
        *r2 += (q[a] - p[a]) * (q[a] - p[a]);
    double r = sqrt(*r2);
    for (int a = 0; a < 3; a++)
        d[a] = (q[a] - p[a]) / r;
    if (!murk_box_chord(box[0], box[1], p, d, t_m) || !murk_box_chord(box[2], box[3], p, d, t_k))
        return 0;
    double depth = murk_sight_depth(sight, p, d, t_m[1], t_k[0]);
    return murk_chord_escape(kappa_m * (t_m[1] - t_m[0])) * exp(-depth) *
           murk_chord_escape(kappa_k * (t_k[1] - t_k[0]));
}

double murk_far_attenuation(const murk_sight *sight, const int32_t m[3], const int32_t k[3],
                            double kappa_m, double kappa_k)
{
    const double *size = sight->grid->voxel;
    double box[4][3], p[3], q[3], r2;
    for (int a = 0; a < 3; a++) {
        box[0][a] = m[a] * size[a];
        box[1][a] = (m[a] + 1) * size[a];
        box[2][a] = k[a] * size[a];
        box[3][a] = (k[a] + 1) * size[a];
        p[a] = (box[0][a] + box[1][a]) / 2;
        q[a] = (box[2][a] + box[3][a]) / 2;
    }
    const double(*zones)[3] = (const double(*)[3])box;
    double middle = attenuation(sight, zones, p, q, kappa_m, kappa_k, &r2);
    double edge = fmax(size[0], fmax(size[1], size[2]));
    if (sight->kappa_max * edge < 0.05 || (middle > 0 && middle < 1e-8))
        return middle;
    /* Stroud's C6: 3-1, twelve points in the cube of both positions, exact to degree 3; thick zones
       take four such sets, turned against one another. */
    int sets = fmax(kappa_m, kappa_k) * edge > 0.8 ? 4 : 1;
    double sum = 0, weights = 0;
    for (int j = 0; j < 12 * sets; j++) {
        double x[6];
        for (int n = 0; n < 3; n++) {
            double angle = (2 * n + 1) * j * M_PI / (6 * sets);
            x[2 * n] = sqrt(2. / 3) * cos(angle);
            x[2 * n + 1] = sqrt(2. / 3) * sin(angle);
        }
        for (int a = 0; a < 3; a++) {
            p[a] = (m[a] + 0.5 + 0.5 * x[a]) * size[a];
            q[a] = (k[a] + 0.5 + 0.5 * x[3 + a]) * size[a];
        }
        double value = attenuation(sight, zones, p, q, kappa_m, kappa_k, &r2);
        sum += value / r2;
        weights += 1 / r2;
    }
    return sum / weights;
}
