/* SPDX-License-Identifier: Apache-2.0 */
#include "ground.h"

#include <math.h>

/* Margin patches grow by this ratio until the ground reaches REACH times the extent. */
static const double GROWTH = 1.4;
static const double REACH = 30;

static murk_status check(murk_context *context, const murk_ground_options *o)
{
    for (int c = 0; c < 2; c++) {
        if (!(o->extent_max[c] > o->extent_min[c]) ||
            !isfinite(o->extent_max[c] - o->extent_min[c]))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "ground.extent: [%g, %g] is empty on axis %c; the second corner has "
                             "to lie beyond the first",
                             o->extent_min[c], o->extent_max[c], "ab"[c]);
        if (o->patches[c] < 1 || o->patches[c] > 1 << 14)
            return murk_fail(context, MURK_ERROR_INPUT,
                             "ground.patches: %d is not between 1 and 16384", o->patches[c]);
    }
    if (!isfinite(o->height))
        return murk_fail(context, MURK_ERROR_INPUT, "ground.height: not a finite number");
    size_t count = (size_t)o->patches[0] * (size_t)o->patches[1];
    for (size_t i = 0; i < count; i++) {
        double rho = o->reflectance_image ? o->reflectance_image[i] : o->reflectance;
        double e = o->emission_image ? o->emission_image[i] : o->emission;
        if (!(rho >= 0 && rho <= 1))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "ground.reflectance: %g is not between 0 and 1", rho);
        if (!(e >= 0) || !isfinite(e))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "ground.emission: %g is not a finite number >= 0", e);
        if (!o->reflectance_image && !o->emission_image)
            break;
    }
    return MURK_OK;
}

static int margin_count(const murk_ground_options *o)
{
    double extent = fmax(o->extent_max[0] - o->extent_min[0], o->extent_max[1] - o->extent_min[1]);
    double patch = fmin((o->extent_max[0] - o->extent_min[0]) / o->patches[0],
                        (o->extent_max[1] - o->extent_min[1]) / o->patches[1]);
    return (int)ceil(log(1 + REACH * extent / patch * (GROWTH - 1)) / log(GROWTH));
}

/* Smallest distance whose leading bits have the number k in margin_start. */
static double lookup_distance(int k)
{
    return ldexp(1 + (k & 3) / 4.0, k >> 2) - 1;
}

static bool fill_margin(murk_ground *ground)
{
    int margin = ground->margin, cells = 1;
    ground->margin_edge = murk_alloc((size_t)margin + 1, sizeof(double));
    if (!ground->margin_edge)
        return false;
    for (int i = 1; i <= margin; i++)
        ground->margin_edge[i] = (pow(GROWTH, i) - 1) / (GROWTH - 1) * GROWTH;
    while (lookup_distance(cells) <= ground->margin_edge[margin])
        cells++;
    ground->margin_start = murk_alloc((size_t)cells + 1, sizeof *ground->margin_start);
    for (int k = 0, i = 0; ground->margin_start && k <= cells; k++) {
        while (i + 1 < margin && ground->margin_edge[i + 1] <= lookup_distance(k))
            i++;
        ground->margin_start[k] = (uint16_t)i;
    }
    return ground->margin_start;
}

static void fill_edges(murk_ground *ground, const murk_ground_options *o)
{
    for (int c = 0; c < 2; c++) {
        double *edge = ground->edge[c], low = o->extent_min[c], high = o->extent_max[c];
        int n = ground->interior[c], margin = ground->margin;
        double step = (high - low) / n;
        ground->per_metre[c] = n / (high - low);
        for (int i = 0; i <= n; i++)
            edge[margin + i] = low + (high - low) * i / n;
        for (int i = 1; i <= margin; i++) {
            edge[margin - i] = low - step * ground->margin_edge[i];
            edge[margin + n + i] = high + step * ground->margin_edge[i];
        }
    }
}

static void fill_patches(murk_ground *ground, const murk_ground_options *o)
{
    int nx = ground->interior[0], ny = ground->interior[1];
    double rho_sum = 0, e_sum = 0;
    for (int ib = 0; ib < ny; ib++)
        for (int ia = 0; ia < nx; ia++) {
            size_t pixel = (size_t)murk_ground_row(ground, ib) * (size_t)nx + (size_t)ia;
            size_t patch = murk_ground_interior(ground, ia, ib);
            double rho =
                murk_or_none(o->reflectance_image ? o->reflectance_image[pixel] : o->reflectance);
            double e = murk_or_none(o->emission_image ? o->emission_image[pixel] : o->emission);
            ground->reflectance[patch] = (float)rho;
            ground->emission[patch] = (float)e;
            rho_sum += rho;
            e_sum += e;
        }
    ground->mean_reflectance = rho_sum / ((double)nx * ny);
    ground->mean_emission = e_sum / ((double)nx * ny);
    for (int ib = 0; ib < ground->count[1]; ib++)
        for (int ia = 0; ia < ground->count[0]; ia++) {
            int in_a = ia - ground->margin, in_b = ib - ground->margin;
            if (in_a >= 0 && in_a < nx && in_b >= 0 && in_b < ny)
                continue;
            size_t patch = (size_t)ib * (size_t)ground->count[0] + (size_t)ia;
            ground->reflectance[patch] = (float)ground->mean_reflectance;
            ground->emission[patch] = (float)ground->mean_emission;
        }
}

murk_status murk_ground_create(murk_context *context, const murk_ground_options *options,
                               murk_ground **out)
{
    const murk_ground_options defaults = MURK_GROUND_DEFAULT;
    if (!options)
        options = &defaults;
    murk_status status = check(context, options);
    if (status)
        return status;
    murk_ground *ground = murk_alloc(1, sizeof *ground);
    if (!ground)
        return murk_fail(context, MURK_ERROR_MEMORY, "ground: out of memory");
    ground->references = 1;
    ground->up = options->up;
    ground->height = options->height;
    ground->horizon = options->horizon;
    ground->margin = options->horizon ? margin_count(options) : 0;
    for (int c = 0; c < 2; c++) {
        ground->interior[c] = options->patches[c];
        ground->count[c] = options->patches[c] + 2 * ground->margin;
        ground->edge[c] = murk_alloc((size_t)ground->count[c] + 1, sizeof(double));
    }
    ground->patch_count = (size_t)ground->count[0] * (size_t)ground->count[1];
    ground->reflectance = murk_alloc(ground->patch_count, sizeof(float));
    ground->emission = murk_alloc(ground->patch_count, sizeof(float));
    if (!ground->edge[0] || !ground->edge[1] || !ground->reflectance || !ground->emission ||
        !fill_margin(ground)) {
        murk_ground_release(ground);
        return murk_fail(context, MURK_ERROR_MEMORY, "ground: out of memory for its patches");
    }
    fill_edges(ground, options);
    fill_patches(ground, options);
    *out = ground;
    return MURK_OK;
}

murk_ground *murk_ground_share(const murk_ground *ground)
{
    murk_ground *shared = (murk_ground *)ground;
    if (shared)
        shared->references++;
    return shared;
}

void murk_ground_release(murk_ground *ground)
{
    if (!ground || --ground->references > 0)
        return;
    murk_free(ground->edge[0]);
    murk_free(ground->edge[1]);
    murk_free(ground->margin_edge);
    murk_free(ground->margin_start);
    murk_free(ground->reflectance);
    murk_free(ground->emission);
    murk_free(ground);
}

double murk_ground_difference(const murk_ground *ground, const float *a, const float *b)
{
    double size = 0, difference = 0; /* of equal areas */
    for (int ib = 0; ground && ib < ground->interior[1]; ib++)
        for (int ia = 0; ia < ground->interior[0]; ia++) {
            size_t i = murk_ground_interior(ground, ia, ib);
            size += (double)a[i] * a[i];
            difference += (double)b[i] * b[i];
        }
    return size > 0 ? sqrt(difference / size) : 0;
}

double murk_ground_area(const murk_ground *ground, size_t patch)
{
    size_t ia = patch % (size_t)ground->count[0], ib = patch / (size_t)ground->count[0];
    return (ground->edge[0][ia + 1] - ground->edge[0][ia]) *
           (ground->edge[1][ib + 1] - ground->edge[1][ib]);
}

size_t murk_ground_interior(const murk_ground *ground, int ia, int ib)
{
    return (size_t)(ib + ground->margin) * (size_t)ground->count[0] + (size_t)(ia + ground->margin);
}

int murk_ground_row(const murk_ground *ground, int ib)
{
    return ground->up == MURK_UP_Z ? ground->interior[1] - 1 - ib : ib;
}

int murk_ground_axis_a(const murk_ground *ground)
{
    (void)ground;
    return 0;
}

int murk_ground_axis_b(const murk_ground *ground)
{
    return murk_axis_b(ground->up);
}

int murk_ground_axis_up(const murk_ground *ground)
{
    return murk_axis_up(ground->up);
}

void murk_ground_patches(const murk_ground *ground, int patches[2])
{
    patches[0] = ground->interior[0];
    patches[1] = ground->interior[1];
}
