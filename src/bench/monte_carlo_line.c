/* SPDX-License-Identifier: Apache-2.0 */
#include "monte_carlo_line.h"

#include <math.h>

/* The part of the line in the box; false where there is none. */
static bool clip(const struct bench_mc_scene *s, const double at[3], const double along[3],
                 double *begin)
{
    double end = INFINITY;
    *begin = 0;
    for (int a = 0; a < 3; a++) {
        double low = s->low[a] - at[a], high = low + s->size[a] * s->voxel[a];
        if (along[a] == 0 && (low > 0 || high < 0))
            return false;
        if (along[a] == 0)
            continue;
        double t0 = low / along[a], t1 = high / along[a];
        *begin = fmax(*begin, fmin(t0, t1));
        end = fmin(end, fmax(t0, t1));
    }
    return *begin < end;
}

bool bench_mc_line_begin(struct bench_mc_line *line, const struct bench_mc_scene *scene,
                         const double at[3], const double along[3])
{
    const struct bench_mc_scene *s = scene;
    const int stride[3] = {s->size[1] * s->size[2], s->size[2], 1};
    if (!clip(s, at, along, &line->t))
        return false;
    line->zone = 0;
    for (int a = 0; a < 3; a++) {
        double x = (at[a] + line->t * along[a] - s->low[a]) / s->voxel[a];
        int n = x < 0 ? 0 : x >= s->size[a] ? s->size[a] - 1 : (int)x;
        bool up = along[a] > 0;
        line->zone += n * stride[a];
        line->left[a] = up ? s->size[a] - n : n + 1;
        line->stride[a] = up ? stride[a] : -stride[a];
        line->step[a] = line->wall[a] = INFINITY;
        if (along[a] == 0)
            continue;
        line->step[a] = s->voxel[a] / fabs(along[a]);
        line->wall[a] = (s->low[a] + s->voxel[a] * (n + up) - at[a]) / along[a];
    }
    return true;
}
