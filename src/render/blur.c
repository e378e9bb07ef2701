/* SPDX-License-Identifier: Apache-2.0 */
#include "blur.h"

#include <math.h>

murk_status murk_blur_create(murk_context *context, const murk_solution *solution, murk_blur *out)
{
    const murk_ground *ground = solution->ground;
    const size_t columns = (size_t)ground->count[0], rows = (size_t)ground->count[1];
    double *sum = murk_alloc((columns + 1) * (rows + 1), sizeof *sum);
    if (!sum)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    for (size_t j = 0; j < rows; j++) {
        double row = 0;
        for (size_t i = 0; i < columns; i++) {
            size_t patch = j * columns + i;
            row += solution->patch[patch] * murk_ground_area(ground, patch);
            sum[(j + 1) * (columns + 1) + i + 1] = sum[j * (columns + 1) + i + 1] + row;
        }
    }
    *out = (murk_blur){ground, ground->horizon ? solution->horizon : 0, sum};
    return MURK_OK;
}

void murk_blur_clear(murk_blur *blur)
{
    murk_free(blur->sum);
}

/* x moved into the patches, the column it is in and how far. */
static double enter(const murk_ground *ground, int axis, double x, int *column, double *fraction)
{
    const double *edge = ground->edge[axis];
    int low = 0, high = ground->count[axis] - 1;
    x = fmin(fmax(x, edge[0]), edge[high + 1]);
    while (low < high) {
        int middle = (low + high + 1) / 2;
        if (edge[middle] <= x)
            low = middle;
        else
            high = middle - 1;
    }
    *column = low;
    *fraction = (x - edge[low]) / (edge[low + 1] - edge[low]);
    return x;
}

/* The sum below a point: patches are of one radiosity, so it is bilinear in each. */
static double sum_below(const murk_blur *blur, const int column[2], const double fraction[2])
{
    const size_t stride = (size_t)blur->ground->count[0] + 1;
    const double *low = blur->sum + (size_t)column[1] * stride + (size_t)column[0];
    const double *high = low + stride;
    double near = low[0] + fraction[0] * (low[1] - low[0]);
    double far = high[0] + fraction[0] * (high[1] - high[0]);
    return near + fraction[1] * (far - near);
}

double murk_blur_mean(const murk_blur *blur, double a, double b, double reach)
{
    const double middle[2] = {a, b};
    double area = 1, power = 0, fraction[2][2];
    int column[2][2];
    for (int c = 0; c < 2; c++) {
        double low = enter(blur->ground, c, middle[c] - reach, &column[0][c], &fraction[0][c]);
        double high = enter(blur->ground, c, middle[c] + reach, &column[1][c], &fraction[1][c]);
        area *= high - low;
    }
    for (int n = 0; n < 4; n++) {
        const int at[2] = {column[n & 1][0], column[n >> 1][1]};
        const double on[2] = {fraction[n & 1][0], fraction[n >> 1][1]};
        power += (n == 0 || n == 3 ? 1 : -1) * sum_below(blur, at, on);
    }
    double all = 4 * reach * reach;
    return (power + (all - area) * blur->beyond) / all;
}
